#pragma once

#include "model/model.h"

namespace knitmech::model {

/// EI / l summed over all half stitches of the fabric, l the length of yarn in one [mJ]; EI is that of the yarn, also
/// on turning arcs. A half stitch that is bent by one radian more, evenly, holds EI / (2 l). So this is what strain
/// energies are measured against where the question is how far the loops have been bent, whatever the mesh, the yarn
/// and the size of the fabric.
[[nodiscard]] double bending_measure(const Model& model);

}  // namespace knitmech::model
