#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "curves/yarn_lines.h"

namespace knitmech::curves {

/// The endings of files of yarns: a table, a binary curve collection, a file of the smobj tools.
inline constexpr std::array<std::string_view, 3> kYarnFileEndings = {".csv", ".bcc", ".yarns"};

/// A name for a copy of a file of yarns: "yarns.csv". It collides with no file of a run folder.
[[nodiscard]] inline std::string plain_name(std::string_view ending) {
  return "yarns" + std::string(ending);
}

/// A file of yarns: what it holds, and its content bit by bit, so that it can be put beside the results.
struct YarnFile {
  std::filesystem::path path;  ///< that it was read from
  std::string ending;          ///< one of kYarnFileEndings
  std::string bytes;
  YarnLines lines;
};

/// Reads a file of yarns in the format of its ending, in capitals or not.
/// @throws FileError if it cannot be read
/// @throws InputError with one sentence, the file in it, for another ending and for a damaged or impossible content
[[nodiscard]] YarnFile read_yarn_file(const std::filesystem::path& path);

/// Sixteen digits and letters that tell one content from another (FNV-1a, 64 bits, www.isthe.com/chongo/tech/comp/fnv).
/// Against slips, not against a forger.
[[nodiscard]] std::string checksum_of(std::string_view bytes);

}  // namespace knitmech::curves
