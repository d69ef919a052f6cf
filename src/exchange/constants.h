#pragma once

#include <cstddef>

namespace knitmech::exchange {

/// Longest floating point number of an Abaqus data line [characters], sign, point and exponent included (Abaqus
/// Analysis User's Guide, "Input syntax rules"). A longer one may be cut, and with it its exponent.
inline constexpr std::size_t kAbaqusNumberWidth = 20;

/// Longest line of an Abaqus input file [characters] ("Input syntax rules").
inline constexpr std::size_t kAbaqusLineWidth = 256;

/// Most entries on a data line of *NSET and *ELSET (Abaqus Keywords Guide).
inline constexpr std::size_t kAbaqusSetEntries = 16;

/// Abaqus' default slenderness compensation factor of transverse shear [-], also that of the beam elements here.
/// Written into the deck so that it does not depend on a default, and because soft yarns need less (AbaqusSection).
inline constexpr double kSlendernessCompensation = 0.25;

/// How far EI may be from EA D^2 / 16 for a solid circle, as a share of EI [-]. Only rounding has to fit in.
inline constexpr double kCircleTolerance = 1e-9;

/// Straight pieces between two points of a measured curve [-]. More: nearer to the smooth curve, and a longer deck.
inline constexpr int kCurvePieces = 8;

/// Strain [-] that the written curve reaches into compression and beyond its last point.
inline constexpr double kCurveReach = 1;

/// Largest cosine [-] between an element and the first axis of its section: 45 degrees. Abaqus needs the two not
/// parallel; any direction has a coordinate axis at least 54.7 degrees away from it, so a fitting axis always exists.
inline constexpr double kLargestFirstAxisCosine = 0.7071067811865476;

}  // namespace knitmech::exchange
