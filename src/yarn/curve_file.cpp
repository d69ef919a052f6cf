#include "yarn/curve_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::yarn {
namespace {

constexpr std::size_t kLargestFile = 100'000'000;  // [bytes]

}  // namespace

std::string curve_file_bytes(const std::string& path) {
  const auto refuse = [&](const char* reason) {
    throw FileError(fmt::format("cannot read {}: {}", base::in_quotes(path), reason));
  };
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) refuse("there is no such file");
  if (std::filesystem::is_directory(path, ignored)) refuse("it is a folder; give the files in it");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse("the file cannot be opened");
  std::string bytes;
  constexpr std::size_t kBlock = 1 << 20;
  while (stream && bytes.size() <= kLargestFile) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kBlock);
    stream.read(bytes.data() + size, kBlock);
    bytes.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) refuse("reading failed");
  if (bytes.size() > kLargestFile) {
    throw InputError(fmt::format("{}: is larger than {} bytes; give the curves of fewer specimens, or fewer points",
                                 path, kLargestFile));
  }
  return bytes;
}

}  // namespace knitmech::yarn
