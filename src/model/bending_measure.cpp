#include "model/bending_measure.h"

#include "model/places.h"

namespace knitmech::model {

double bending_measure(const Model& model) {
  const double half_stitches = yarn_length_of(model) / model.half_stitch_length;
  return model.sections.front().bending_stiffness / model.half_stitch_length * half_stitches;
}

}  // namespace knitmech::model
