#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace knitmech::curves {

// Where things stand in the head of a binary curve collection [bytes from its beginning]; see bcc_text().
inline constexpr std::string_view kBccMagic = "BCC";
inline constexpr std::size_t kBccNumberSizes = 3;  ///< bytes of an integer and of a floating-point number, 4 bits each
inline constexpr std::size_t kBccCurveType = 4;    ///< two letters
inline constexpr std::size_t kBccDimensions = 6;
inline constexpr std::size_t kBccCurveCount = 8;   ///< 64 bits
inline constexpr std::size_t kBccPointCount = 16;  ///< 64 bits, of all curves together
inline constexpr std::size_t kBccHead = 64;        ///< with 40 bytes for a note at the end

inline constexpr std::uint8_t kBccFourAndFour = 0x44;
inline constexpr std::string_view kBccCatmullRom = "C0";  ///< uniform parameter
inline constexpr std::string_view kBccPolyline = "PL";
inline constexpr std::uint8_t kBccZUp = 2;  ///< the axis that a viewer shows as up, by its index

inline constexpr std::size_t kPointBytes = 12;  ///< three 32-bit numbers, here and in .yarns

}  // namespace knitmech::curves
