#include "results/yarn_breaks.h"

#include <fmt/core.h>

#include "model/places.h"

namespace knitmech::results {

std::string breaks_text(const model::Model& model, const model::RunOutcome& outcome) {
  if (outcome.breaks.empty()) return {};
  const model::YarnBreak& event = outcome.breaks.front();
  const std::string what = fmt::format("in {}, at {:.3g} % strain, with {:.3g} N and stretched by {:.3g} %",
                                       model::element_text(model, static_cast<std::size_t>(event.element)),
                                       100 * event.strain, event.axial_force, 100 * event.axial_strain);
  const std::size_t n = outcome.breaks.size();
  if (n == 1) return fmt::format("Break: a yarn broke {}.", what);
  return fmt::format("Breaks: yarns broke at {} places, first {}.", n, what);
}

}  // namespace knitmech::results
