#pragma once

#include <iosfwd>

#include "model/model.h"

namespace knitmech::exchange {

/// What an LS-DYNA deck needs besides the model.
struct LsDynaOptions {
  double mass_scaling = 1;    ///< factor on the density [-], > 0
  int history_points = 1000;  ///< rows of the time histories over the test [-]
  int pictures = 50;          ///< states of d3plot over the test [-]
};

/// Writes a model as a keyword deck for LS-DYNA that OpenRadioss reads too (docs/lsdyna.md): resultant beams
/// (*SECTION_BEAM, ELFORM 2) of *MAT_ELASTIC, one part for each section, *CONSTRAINED_LINEAR_GLOBAL where yarns are
/// tied, *CONTACT_AUTOMATIC_GENERAL of all yarns with the friction of *DEFINE_FRICTION, grips by *BOUNDARY_SPC_SET and
/// *BOUNDARY_PRESCRIBED_MOTION_SET. Units t, mm, s, hence N, MPa, mJ.
///
/// Numbers as in write_openradioss_starter(), in the fixed columns of the standard format: values of ten characters,
/// that is six digits or more. The same model gives the same text, byte for byte. Throws InputError for a measured yarn
/// curve, std::invalid_argument for a model whose grips are not among its node sets or are empty.
///
/// Source: LS-DYNA Keyword User's Manual, volumes I and II; the page of each keyword is named where it is written. What
/// OpenRadioss makes of a keyword: its reader, reader/source/dyna2rad.
void write_lsdyna(std::ostream& out, const model::Model& model, const LsDynaOptions& options = {});

}  // namespace knitmech::exchange
