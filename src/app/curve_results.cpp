#include "app/curve_results.h"

#include <fmt/format.h>

#include <system_error>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::app {

namespace fs = std::filesystem;

void make_curve_folder(const fs::path& folder, const std::vector<const char*>& names,
                       const std::vector<std::string>& files_read) {
  for (const char* name : names) {
    for (const std::string& file : files_read) {
      std::error_code not_there;
      if (!fs::equivalent(folder / name, file, not_there)) continue;
      throw InputError(
          fmt::format("{} is one of the curves and would be overwritten; give another folder", base::in_quotes(file)));
    }
  }
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw FileError(fmt::format("cannot write the folder {}: {}", folder.string(), failed.message()));
}

}  // namespace knitmech::app
