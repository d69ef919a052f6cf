#pragma once

#include <string>
#include <vector>

#include "curves/yarn_lines.h"

namespace knitmech::curves {

/// Yarns as a table: a line per point with yarn (from 1), x_mm, y_mm, z_mm and, if all yarns have one, radius_mm; every
/// number with the fewest digits that give the same bits. A closed yarn has its first point once more at its end.
///
/// @param yarns [mm]; all of their points lie on the centreline (LineKind::through_points)
[[nodiscard]] std::string csv_text(const std::vector<YarnLine>& yarns);

/// Yarns as a binary curve collection (BCC), the format of the yarn-level models of C. Yuksel, J. Kaldor, D. James and
/// S. Marschner, "Stitch Meshes for Modeling Knitted Clothing with Yarn-level Detail", 2012
/// (cemyuksel.com/research/yarnmodels, cemyuksel.com/cyCodeBase/soln/using_bcc_files.html): head of 64 bytes, then per
/// yarn the number of its control points (32 bits; negative: closed) and their x, y, z as 32-bit floating-point
/// numbers. Little-endian.
///
/// The curve is the uniform Catmull-Rom spline (type "C0"), which runs from the second control point of an open yarn to
/// the last but one; therefore each end has one point more, which mirrors its neighbour. The format knows neither
/// radius nor unit.
///
/// @param yarns in any length, at least two points each; all lie on the centreline (LineKind::through_points)
/// @throws InputError if a coordinate is too large for 32 bits
[[nodiscard]] std::string bcc_text(const std::vector<YarnLine>& yarns);

/// Yarns as a .yarns file of the Textiles Lab of Carnegie Mellon University (github.com/textiles-lab/smobj, README.md,
/// ".yarns: a format for yarn curves"): chunks of a name of four letters, the number of its bytes (32 bits) and as many
/// bytes, in the order "f3..", "src.", "yarn", "strs", "unit", "chk.". Little-endian.
///
/// A reader draws quadratic arcs through the middles of the chords, so the corners that are written stand a little
/// outside the bends, in such a way that these arcs pass through the points given here. A closed yarn has its first
/// corner once more at its end. Colours are KnitMech's; source lines are 0, and checkpoints there are none.
///
/// @param yarns in any length, at least two points each; all lie on the centreline (LineKind::through_points)
/// @throws InputError if a coordinate is too large for 32 bits
[[nodiscard]] std::string yarns_text(const std::vector<YarnLine>& yarns);

}  // namespace knitmech::curves
