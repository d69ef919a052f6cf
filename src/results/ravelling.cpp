#include "results/ravelling.h"

#include <fmt/core.h>

#include "model/places.h"

namespace knitmech::results {

RavelledPlace place_of(const model::Model& model, const model::Ravelling& event) {
  const model::ModelYarn& yarn = model.yarns.at(static_cast<std::size_t>(event.yarn));
  const int yarn_end = yarn.first_node + (event.is_last_end ? yarn.n_nodes - 1 : 0);
  const auto end = static_cast<std::size_t>(event.broken_end.value_or(yarn_end));
  const std::size_t other = model::node_near(model, event.other_yarn, event.other_place);
  const std::string side = event.broken_end ? "broken" : model::side_of(model, end);
  return {model.course[end] + 1, side, model.course[other] + 1, model.wale[other] + 1};
}

std::string ravelling_text(const model::Model& model, const model::RunOutcome& outcome) {
  if (outcome.ravelled.empty()) return {};
  const model::Ravelling& event = outcome.ravelled.front();
  const RavelledPlace place = place_of(model, event);
  const std::size_t n = outcome.ravelled.size();
  const std::string what =
      fmt::format("{} {} end of course {} over course {}, wale {}, at {:.3g} % strain", event.broken_end ? "a" : "the",
                  place.side, place.course, place.other_course, place.other_wale, 100 * event.strain);
  if (n == 1) return fmt::format("Ravelling: one yarn end slipped out of a loop, {}.", what);
  return fmt::format("Ravelling: {} yarn ends slipped out of loops, first {}.", n, what);
}

}  // namespace knitmech::results
