#include "model/facts.h"

#include <cstddef>

#include "knit/constants.h"
#include "knit/out_of_plane.h"
#include "knit/turning_arc.h"
#include "model/build_model.h"

namespace knitmech::model {
namespace {

constexpr double kGramsPerSquareMetre = 1e12;  ///< of one t/mm^2

double depth_of(const knit::LoopShape& loop) {
  return loop.out_of_plane * loop.height * loop.height / 4;
}

double yarn_length_of(const Model& model) {
  double length = 0;
  for (const ModelYarn& yarn : model.yarns) {
    length += model.arc_length[static_cast<std::size_t>(yarn.first_node + yarn.n_nodes - 1)];
  }
  return length;
}

void add_structure(FabricFacts& facts, const knit::FabricLayout& layout, const Model& model) {
  facts.n_ties = static_cast<int>(model.ties.size());
  if (layout.structure != knit::Structure::adjusted) return;
  facts.n_turning_arcs = layout.courses - 1;
  facts.turning_arc_length = knit::make_turning_arc(layout).length;
  facts.edge_section = model.sections.at(1);
}

}  // namespace

FabricFacts describe(const Case& input, const Model& model) {
  const double diameter = input.yarn.diameter;
  const knit::FabricLayout layout = resolved_layout(input);
  FabricFacts facts;
  facts.erc = knit::make_erc(layout.loop);
  facts.automatic_out_of_plane = !input.loop.out_of_plane;
  facts.out_of_plane = layout.loop.out_of_plane;
  facts.least_out_of_plane = knit::required_out_of_plane(layout, diameter, 0);
  facts.stitch_length = 2 * facts.erc.length;
  facts.yarn_length = yarn_length_of(model);
  facts.n_elements = model.n_elements();
  facts.n_nodes = model.n_nodes();
  facts.n_degrees_of_freedom = 6 * model.n_nodes();
  facts.closest_on_curve = least_gap(closest_approaches(facts.erc, layout, diameter, knit::kCurvePieces));
  facts.closest_on_elements = least_gap(closest_approaches(facts.erc, layout, diameter, layout.elements_per_erc));
  facts.width = layout.wales * layout.loop.width;
  facts.height = (layout.courses - 1) * layout.course_spacing + layout.loop.height;
  facts.thickness = depth_of(layout.loop) + diameter;
  facts.section = model.sections.front();
  facts.mass_per_area = kGramsPerSquareMetre * facts.stitch_length * facts.section.mass_per_length /
                        (layout.loop.width * layout.course_spacing);
  add_structure(facts, layout, model);
  return facts;
}

}  // namespace knitmech::model
