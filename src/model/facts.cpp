#include "model/facts.h"

#include <fmt/format.h>

#include <cstddef>

#include "knit/constants.h"
#include "knit/out_of_plane.h"
#include "knit/turning_arc.h"
#include "model/build_from_file.h"
#include "model/build_model.h"
#include "model/constants.h"
#include "model/places.h"

namespace knitmech::model {
namespace {

constexpr double kGramsPerSquareMetre = 1e12;  ///< of one t/mm^2

double depth_of(const knit::LoopShape& loop) {
  return loop.out_of_plane * loop.height * loop.height / 4;
}

void add_structure(FabricFacts& facts, const knit::FabricLayout& layout, const Model& model) {
  facts.n_ties = static_cast<int>(model.ties.size());
  if (layout.structure != knit::Structure::adjusted) return;
  facts.n_turning_arcs = layout.courses - 1;
  facts.turning_arc_length = knit::make_turning_arc(layout).length;
  facts.edge_section = model.sections.at(1);
}

/// What holds for every fabric.
FabricFacts common_facts(const Model& model) {
  FabricFacts facts;
  facts.yarn_length = yarn_length_of(model);
  facts.n_elements = model.n_elements();
  facts.n_nodes = model.n_nodes();
  facts.n_degrees_of_freedom = 6 * model.n_nodes();
  facts.section = model.sections.front();
  return facts;
}

FileFacts file_facts(const Case& input, const Model& model, double yarn_length) {
  const curves::YarnLines& lines = input.fabric.yarn_file->lines;
  FileFacts facts;
  for (const curves::YarnLine& yarn : lines.yarns) facts.n_points += yarn.points.size();
  facts.half_stitch = model.half_stitch_length;
  facts.element_length = yarn_length / model.n_elements();
  facts.diameter_in_file = 2 * lines.yarns.front().radius * input.fabric.file_unit.value_or(1);
  facts.grip_depth = grip_depth_of(input, model);
  facts.n_bottom = model.node_sets.at(kBottomFeet).size();
  facts.n_top = model.node_sets.at(kTopHeads).size();
  facts.closest = nearest_in(input, model, kGapReach * input.yarn.diameter);
  return facts;
}

FabricFacts describe_file(const Case& input, const Model& model) {
  FabricFacts facts = common_facts(model);
  facts.file = file_facts(input, model, facts.yarn_length);
  facts.stitch_length = 2 * model.half_stitch_length;
  Eigen::Vector3d lowest = model.nodes.front(), highest = lowest;
  for (const Eigen::Vector3d& node : model.nodes) {
    lowest = lowest.cwiseMin(node);
    highest = highest.cwiseMax(node);
  }
  const Eigen::Vector3d size = highest - lowest;
  facts.width = size.x();
  facts.height = size.y();
  facts.thickness = size.z() + input.yarn.diameter;
  const double mass = facts.yarn_length * facts.section.mass_per_length;
  facts.mass_per_area = facts.width > 0 ? kGramsPerSquareMetre * mass / (facts.width * facts.height) : 0;
  return facts;
}

}  // namespace

std::string fabric_text(const Case& input) {
  if (const auto& file = input.fabric.yarn_file) {
    const std::size_t n = file->lines.yarns.size();
    return fmt::format("{} yarn{} from a file", n, n == 1 ? "" : "s");
  }
  return fmt::format("{} wales x {} courses", input.fabric.wales, input.fabric.courses);
}

FabricFacts describe(const Case& input, const Model& model) {
  if (input.fabric.yarn_file) return describe_file(input, model);
  const double diameter = input.yarn.diameter;
  const knit::FabricLayout layout = resolved_layout(input);
  FabricFacts facts = common_facts(model);
  facts.erc = knit::make_erc(layout.loop);
  facts.automatic_out_of_plane = !input.loop.out_of_plane;
  facts.out_of_plane = layout.loop.out_of_plane;
  facts.least_out_of_plane = knit::required_out_of_plane(layout, diameter, 0);
  facts.stitch_length = 2 * facts.erc.length;
  facts.closest_on_curve = least_gap(closest_approaches(facts.erc, layout, diameter, knit::kCurvePieces));
  facts.closest_on_elements = least_gap(closest_approaches(facts.erc, layout, diameter, layout.elements_per_erc));
  facts.width = layout.wales * layout.loop.width;
  facts.height = (layout.courses - 1) * layout.course_spacing + layout.loop.height;
  facts.thickness = depth_of(layout.loop) + diameter;
  facts.mass_per_area = kGramsPerSquareMetre * facts.stitch_length * facts.section.mass_per_length /
                        (layout.loop.width * layout.course_spacing);
  add_structure(facts, layout, model);
  return facts;
}

}  // namespace knitmech::model
