#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace knitmech::curves {

/// A chunk of a .yarns file: its name, and the bytes of one entry. See yarns_text().
struct YarnsChunk {
  std::string_view name;
  std::size_t entry_bytes = 0;
};

inline constexpr YarnsChunk kPointsChunk{"f3..", 12};       ///< x, y, z
inline constexpr YarnsChunk kSourceChunk{"src.", 4};        ///< per point, the line of the program that made it
inline constexpr YarnsChunk kYarnsChunk{"yarn", 16};        ///< first point, end of points, radius, colour
inline constexpr YarnsChunk kStringsChunk{"strs", 1};       ///< the letters of all names
inline constexpr YarnsChunk kUnitsChunk{"unit", 12};        ///< begin and end of the name, length
inline constexpr YarnsChunk kCheckpointsChunk{"chk.", 12};  ///< point, length, unit

/// In the order of the file.
inline constexpr std::array kYarnsChunks = {kPointsChunk,  kSourceChunk, kYarnsChunk,
                                            kStringsChunk, kUnitsChunk,  kCheckpointsChunk};

inline constexpr std::size_t kChunkHead = 8;  ///< [bytes] name, and number of bytes behind it

}  // namespace knitmech::curves
