#include "results/ravelling.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace knitmech::results {

namespace {

bool starts_at_left(const model::Model& model, const model::ModelYarn& yarn) {
  const auto first = static_cast<std::size_t>(yarn.first_node);
  const auto last = first + static_cast<std::size_t>(yarn.n_nodes) - 1;
  return model.nodes[first].x() <= model.nodes[last].x();
}

}  // namespace

RavelledPlace place_of(const model::Model& model, const model::Ravelling& event) {
  const model::ModelYarn& yarn = model.yarns.at(static_cast<std::size_t>(event.yarn));
  const model::ModelYarn& other = model.yarns.at(static_cast<std::size_t>(event.other_yarn));
  const bool starts_left = starts_at_left(model, yarn);
  const double stitch = 2 * model.half_stitch_length;
  const bool other_starts_left = starts_at_left(model, other);
  const auto end = static_cast<std::size_t>(other.first_node + other.n_nodes) - 1;
  const double from_left = other_starts_left ? event.other_place : model.arc_length[end] - event.other_place;
  const int wale = stitch > 0 ? static_cast<int>(std::floor(from_left / stitch)) + 1 : 1;
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
