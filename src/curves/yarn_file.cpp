#include "curves/yarn_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/text.h"
#include "curves/constants.h"
#include "curves/read_lines.h"

namespace knitmech::curves {
namespace {

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (std::ranges::find(kYarnFileEndings, std::string_view(ending)) == kYarnFileEndings.end()) {
    throw InputError(fmt::format("{}: the ending tells the format of a file of yarns, and must be {}", path.string(),
                                 base::alternatives({kYarnFileEndings.begin(), kYarnFileEndings.end()})));
  }
  return ending;
}

YarnLines parse(std::string_view bytes, std::string_view ending) {
  if (ending == ".bcc") return parse_bcc(bytes);
  if (ending == ".yarns") return parse_yarns(bytes);
  return parse_csv(bytes);
}

}  // namespace

YarnFile read_yarn_file(const std::filesystem::path& path) {
  YarnFile file{.path = path, .ending = ending_of(path), .bytes = {}, .lines = {}};
  file.bytes = base::file_bytes(path.string(), kLargestFile, "give a smaller piece of the fabric, or fewer points");
  try {
    file.lines = parse(file.bytes, file.ending);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
  return file;
}

std::string checksum_of(std::string_view bytes) {
  constexpr std::uint64_t kStart = 0xcbf29ce484222325;
  constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t sum = kStart;
  for (const char byte : bytes) {
    sum = (sum ^ static_cast<unsigned char>(byte)) * kPrime;
  }
  return fmt::format("{:016x}", sum);
}

}  // namespace knitmech::curves
