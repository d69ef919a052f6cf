#include "model/facts.h"

#include "knit/constants.h"
#include "knit/out_of_plane.h"
#include "model/build_model.h"

namespace knitmech::model {
namespace {

constexpr double kGramsPerSquareMetre = 1e12;  ///< of one t/mm^2

double depth_of(const knit::LoopShape& loop) {
  return loop.out_of_plane * loop.height * loop.height / 4;
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
  facts.yarn_length = facts.stitch_length * layout.wales * layout.courses;
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
  return facts;
}

}  // namespace knitmech::model
