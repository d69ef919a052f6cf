#pragma once

#include <iosfwd>

#include "model/model.h"

namespace knitmech::exchange {

/// Writes a model without its contact as an input file for CalculiX (docs/calculix.md): B32R beams with square sections
/// of the yarns' EA, EI and GJ (calculix_square()), ties as equations, and the tensile test as one static step with
/// large displacements. Units mm, N, MPa.
///
/// Node i of the model has the number i + 1, middles and ends within its elements follow. The same model gives the same
/// text, byte for byte. Keywords as in "CalculiX CrunchiX User's Manual", version 2.20: *BEAM SECTION, *ELASTIC,
/// *ORIENTATION, *EQUATION.
/// @throws InputError for yarns that hang on contact alone or on far softer ones, and for yarns that run along x, along
/// y and along z
void write_calculix_beams(std::ostream& out, const model::Model& model);

}  // namespace knitmech::exchange
