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
  if (!model.has_stitches) return {.side = side, .yarn = event.yarn + 1, .other_yarn = event.other_yarn + 1};
  return {.course = model.course[end] + 1,
          .side = side,
          .other_course = model.course[other] + 1,
          .other_wale = model.wale[other] + 1,
          .yarn = event.yarn + 1,
          .other_yarn = event.other_yarn + 1};
}

std::string ravelled_text(const RavelledPlace& place, const char* verb) {
  const char* const article = place.side == "broken" ? "a" : "the";
  if (place.course == 0) {
    return fmt::format("{} {} end of yarn {} {}over yarn {}", article, place.side, place.yarn, verb, place.other_yarn);
  }
  return fmt::format("{} {} end of course {} {}over course {}, wale {}", article, place.side, place.course, verb,
                     place.other_course, place.other_wale);
}

std::string ravelling_text(const model::Model& model, const model::RunOutcome& outcome) {
  if (outcome.ravelled.empty()) return {};
  const model::Ravelling& event = outcome.ravelled.front();
  const RavelledPlace place = place_of(model, event);
  const std::size_t n = outcome.ravelled.size();
  const std::string what = fmt::format("{}, at {:.3g} % strain", ravelled_text(place, ""), 100 * event.strain);
  if (n == 1) return fmt::format("Ravelling: one yarn end slipped out of a loop, {}.", what);
  return fmt::format("Ravelling: {} yarn ends slipped out of loops, first {}.", n, what);
}

}  // namespace knitmech::results
