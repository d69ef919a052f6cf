#include "app/structure_texts.h"

#include <fmt/format.h>

#include "app/run_texts.h"

namespace knitmech::app {
namespace {

constexpr double kMillimetresPerMetre = 1000;

std::string adjusted_text(const model::FabricFacts& facts) {
  return fmt::format("adjusted: {} turning {} of {:.3g} mm, one yarn of {:.2g} m", facts.n_turning_arcs,
                     facts.n_turning_arcs == 1 ? "arc" : "arcs", facts.turning_arc_length,
                     facts.yarn_length / kMillimetresPerMetre);
}

}  // namespace

std::string structure_text(const model::Case& input, const model::FabricFacts& facts) {
  switch (input.fabric.structure) {
    case knit::Structure::basic:
      return "basic: free side edges";
    case knit::Structure::tied:
      return fmt::format("tied: {} crossings of the edge stitches are tied", facts.n_ties);
    case knit::Structure::adjusted:
      break;
  }
  return adjusted_text(facts);
}

std::string stiffness_text(const yarn::Section& section) {
  return fmt::format("EA {:.6g} N, EI {:.6g} N mm^2, GJ {:.6g} N mm^2", section.axial_stiffness,
                     section.bending_stiffness, section.torsional_stiffness);
}

std::string filaments_text(const model::YarnStiffness& yarn) {
  if (!yarn.filaments) return "";
  return fmt::format("{} filaments of {:.4g} mm, {:.4g} turns per mm", *yarn.filaments, *yarn.filament_diameter,
                     *yarn.twist);
}

double edge_friction(const model::Case& input) {
  return input.contact.edge_friction.value_or(input.contact.friction);
}

std::string ties_text(const model::Model& model, const model::RunOutcome& outcome) {
  if (model.ties.empty()) return "";
  return fmt::format("Ties: gave way by at most {:.2g} mm, {} of the yarn diameter.", outcome.largest_tie_stretch,
                     percent_text(outcome.largest_tie_stretch / model.sections.front().diameter));
}

}  // namespace knitmech::app
