#include "compare/comparison_table.h"

#include <fmt/format.h>

#include <cstddef>

namespace knitmech::compare {

std::string comparison_table(const Comparison& comparison) {
  std::string text = fmt::format("{}\n", kComparisonHeader);
  for (std::size_t i = 0; i < comparison.strains.size(); ++i) {
    text += fmt::format("{},{},{},{},{}\n", comparison.strains[i], comparison.simulated[i], comparison.mean[i],
                        comparison.lowest[i], comparison.highest[i]);
  }
  return text;
}

}  // namespace knitmech::compare
