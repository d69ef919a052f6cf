#pragma once

#include <iosfwd>

#include "model/model.h"

namespace knitmech::exchange {

/// Writes a model as an input file for CalculiX with the yarns as solid tubes of 20-node hexahedra (docs/calculix.md):
/// C3D20R with the area and the second moment of area of the circle (tube_hexahedra()), the yarns' surfaces, contact
/// with friction between neighbouring yarns, ties as equations, and the tensile test as one static step with large
/// displacements. Units mm, N, MPa.
///
/// Nodes and elements are numbered from 1 along the yarns. The same model gives the same text, byte for byte. Keywords
/// as in "CalculiX CrunchiX User's Manual", version 2.20.
/// @throws InputError for a yarn that is no solid circle, and for one yarn that runs through several courses
void write_calculix_solids(std::ostream& out, const model::Model& model);

}  // namespace knitmech::exchange
