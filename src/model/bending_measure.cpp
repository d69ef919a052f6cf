#include "model/bending_measure.h"

namespace knitmech::model {

double bending_measure(const Model& model) {
  double yarn_length = 0;
  for (const ModelYarn& yarn : model.yarns) {
    yarn_length += model.arc_length[static_cast<std::size_t>(yarn.first_node + yarn.n_nodes - 1)];
  }
  const double half_stitches = yarn_length / model.half_stitch_length;
  return model.sections.front().bending_stiffness / model.half_stitch_length * half_stitches;
}

}  // namespace knitmech::model
