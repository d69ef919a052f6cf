#include "yarn/curve_file.h"

#include "base/file_bytes.h"

namespace knitmech::yarn {

std::string curve_file_bytes(const std::string& path) {
  constexpr std::size_t kLargestFile = 100'000'000;  // [bytes]
  return base::file_bytes(path, kLargestFile, "give the curves of fewer specimens, or fewer points");
}

}  // namespace knitmech::yarn
