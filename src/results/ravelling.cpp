#include "results/ravelling.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace knitmech::results {

RavelledPlace place_of(const model::Model& model, const model::Ravelling& event) {
  const model::ModelYarn& yarn = model.yarns.at(static_cast<std::size_t>(event.yarn));
  const model::ModelYarn& other = model.yarns.at(static_cast<std::size_t>(event.other_yarn));
  const auto first = static_cast<std::size_t>(yarn.first_node);
  const auto last = first + static_cast<std::size_t>(yarn.n_nodes) - 1;
  const bool starts_left = model.nodes[first].x() <= model.nodes[last].x();
  const double stitch = 2 * model.half_stitch_length;
  const int wale = stitch > 0 ? static_cast<int>(std::floor(event.other_place / stitch)) + 1 : 1;
  return {yarn.course + 1, starts_left != event.is_last_end ? "left" : "right", other.course + 1, std::max(wale, 1)};
}

std::string ravelling_text(const model::Model& model, const model::RunOutcome& outcome) {
  if (outcome.ravelled.empty()) return {};
  const model::Ravelling& event = outcome.ravelled.front();
  const RavelledPlace place = place_of(model, event);
  const std::size_t n = outcome.ravelled.size();
  const std::string what =
      fmt::format("the {} end of course {} over course {}, wale {}, at {:.3g} % strain", place.side, place.course,
                  place.other_course, place.other_wale, 100 * event.strain);
  if (n == 1) return fmt::format("Ravelling: one yarn end slipped out of a loop, {}.", what);
  return fmt::format("Ravelling: {} yarn ends slipped out of loops, first {}.", n, what);
}

}  // namespace knitmech::results
