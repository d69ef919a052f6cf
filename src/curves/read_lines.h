#pragma once

#include <string>
#include <string_view>

#include "curves/yarn_lines.h"

namespace knitmech::curves {

/// Yarns from a table of points, as csv_text() writes it; other tools may leave more freedom.
///
/// The first line names the columns yarn, x, y, z and, if there is one, radius, in any order and among others; they may
/// say their unit, x_mm, "x [mm]" or "x (um)", all the same one. Cells are separated by commas, semicolons or tabs. The
/// cell of the yarn is any word; the lines of one yarn follow each other in its order. A yarn that ends exactly where
/// it begins is closed.
///
/// @throws InputError, without the file, with one sentence on what is wrong and in which line
[[nodiscard]] YarnLines parse_csv(std::string_view bytes);

/// Yarns from a binary curve collection, see bcc_text(). The control points of type "C0" are those of
/// LineKind::inner_points, those of type "PL", a polyline, lie on the centreline.
/// @throws InputError, without the file, with one sentence on what is wrong and at which byte
[[nodiscard]] YarnLines parse_bcc(std::string_view bytes);

/// Yarns from a .yarns file, see yarns_text(). Source lines, units and checkpoints are passed over; chunks behind the
/// yarns may be missing, as in files of older programs. A yarn that ends exactly where it begins is closed.
/// @throws InputError, without the file, with one sentence on what is wrong and at which byte
[[nodiscard]] YarnLines parse_yarns(std::string_view bytes);

}  // namespace knitmech::curves
