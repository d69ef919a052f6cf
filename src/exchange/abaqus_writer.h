#pragma once

#include <iosfwd>

#include "model/model.h"

namespace knitmech::exchange {

/// What an Abaqus deck needs besides the model.
struct AbaqusOptions {
  double mass_scaling = 1;       ///< factor on every mass [-], > 0; 1 writes no *FIXED MASS SCALING
  double bulk_viscosity = 0.06;  ///< linear [-]
};

/// Writes a model as an input file for Abaqus/Explicit (docs/abaqus.md): B31 beams, one element set for each course
/// (COURSE_1 is the lowest), sections with the true radius and the first axis, material, node sets under their names in
/// the model, general contact with friction, and the tensile test as one explicit step. Units mm, N, s, t, MPa.
///
/// Node i of the model has the number i + 1; elements are numbered from 1 along the yarns, yarn after yarn. The same
/// model gives the same text, byte for byte. Numbers as in abaqus_number(). Throws std::invalid_argument for a model
/// whose grips are not among its node sets or are empty.
void write_abaqus(std::ostream& out, const model::Model& model, const AbaqusOptions& options = {});

}  // namespace knitmech::exchange
