#pragma once

#include <iosfwd>
#include <string>

#include "model/model.h"

namespace knitmech::exchange {

/// What an OpenRadioss deck needs besides the model.
struct OpenRadiossOptions {
  std::string run_name = "fabric";  ///< the files are NAME_0000.rad and NAME_0001.rad
  double mass_scaling = 1;          ///< factor on the density [-], > 0
  int history_points = 1000;        ///< rows of the time history over the test [-]
  int pictures = 50;                ///< animation files over the test [-]
};

/// Writes a model as a starter deck for OpenRadioss (docs/openradioss.md): /BEAM elements with /PROP/BEAM and
/// /MAT/ELAST, one part for each section, /MPC where yarns are tied, self-contact of all yarns by /INTER/TYPE11 with
/// the normal law and stiffness of KnitMech's own chords and friction in the incremental form, grips by /BCS and
/// /IMPVEL, time histories. Units Mg, mm, s, hence N, MPa, mJ.
///
/// Node i of the model has the number i + 1; elements are numbered from 1 along the yarns; part k + 1 is section k.
/// The same model gives the same text, byte for byte. The columns are those of the format year 2018, or 2020 where
/// elements are so short that contact along a yarn has to be left out (openradioss_year()).
/// Throws InputError for a measured yarn curve and a run name that OpenRadioss does not take, std::invalid_argument for
/// a model whose grips are not among its node sets or are empty.
///
/// Source: Radioss Reference Guide, "Starter Input"; the page of each card is named where it is written.
void write_openradioss_starter(std::ostream& out, const model::Model& model, const OpenRadiossOptions& options);

/// Writes the engine deck: duration, time history, pictures, time step.
/// Source: Radioss Reference Guide, "Engine Input". Throws like write_openradioss_starter().
void write_openradioss_engine(std::ostream& out, const model::Model& model, const OpenRadiossOptions& options);

/// Format year of the deck: 2018; 2020, the first whose /INTER/TYPE11 has Irem_gap, if a yarn diameter is more than
/// half the shortest element.
[[nodiscard]] int openradioss_year(const model::Model& model);

}  // namespace knitmech::exchange
