#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "model/yarn_curve.h"

namespace knitmech::exchange {

/// The smooth yarns as polylines in a .vtp file of ParaView (results/vtk_xml.h), one line per yarn or piece of a broken
/// one, points as samples_of() has them. Point data: tube_radius_mm, yarn, course and wale, counted from 0 as in the
/// frames of a run (wale -1: on a turning arc), arc_length_mm from the yarn's first node along the stress-free yarn,
/// and displacement_mm since the start.
///
/// @param pieces model::yarn_curves() of the model, in any of its shapes   @param strain of that shape [-]
[[nodiscard]] std::string vtp_text(const model::Model& model, const std::vector<model::CurvePiece>& pieces,
                                   double strain);

}  // namespace knitmech::exchange
