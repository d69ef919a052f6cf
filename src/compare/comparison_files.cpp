#include "compare/comparison_files.h"

namespace knitmech::compare {

namespace fs = std::filesystem;

void remove_comparison(const fs::path& run) {
  const fs::path folder = run / kCompareFolder;
  for (const char* name : {kCompareTable, kCompareJson, kCompareChart}) fs::remove(folder / name);
  if (fs::is_directory(folder) && fs::is_empty(folder)) fs::remove(folder);
}

}  // namespace knitmech::compare
