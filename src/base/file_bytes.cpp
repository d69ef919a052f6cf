#include "base/file_bytes.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::base {

std::string file_bytes(const std::string& path, std::size_t largest, std::string_view advice) {
  const auto refuse = [&](const char* reason) {
    throw FileError(fmt::format("cannot read {}: {}", in_quotes(path), reason));
  };
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) refuse("there is no such file");
  if (std::filesystem::is_directory(path, ignored)) refuse("it is a folder; give the files in it");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse("the file cannot be opened");
  std::string bytes;
  constexpr std::size_t kBlock = 1 << 20;
  while (stream && bytes.size() <= largest) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kBlock);
    stream.read(bytes.data() + size, kBlock);
    bytes.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) refuse("reading failed");
  if (bytes.size() > largest) {
    throw InputError(fmt::format("{}: is larger than {} bytes; {}", path, largest, advice));
  }
  return bytes;
}

}  // namespace knitmech::base
