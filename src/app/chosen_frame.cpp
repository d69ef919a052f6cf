#include "app/chosen_frame.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "app/run_texts.h"
#include "base/errors.h"

namespace knitmech::app {

int chosen_frame(const results::StoredRun& run, std::optional<int> number, std::optional<double> strain,
                 std::ostream& messages) {
  if (number) return *number;
  if (!strain) return run.frames.back().index;
  const results::StoredFrame& nearest = results::nearest_frame(run, *strain);
  messages << fmt::format("Frame {} at {} strain is the stored one nearest to {}.\n", nearest.index,
                          percent_text(nearest.strain), percent_text(*strain));
  return nearest.index;
}

void check_strain(std::optional<double> strain) {
  if (strain && !std::isfinite(*strain)) throw InputError("--strain should be a number, as 0.16");
}

}  // namespace knitmech::app
