#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "yarn/curve_columns.h"
#include "yarn/tensile_curve.h"

namespace knitmech::yarn {

/// Where the numbers of a tensile curve stand in a table, and what turns them into force and strain.
struct CurveHead {
  /// One specimen, or all if there is a column of specimens.
  struct Pair {
    std::size_t load = 0;       ///< index of its column
    std::size_t extension = 0;  ///< index of its column
  };

  char separator = ';';
  std::size_t line = 0;       ///< the one that names the columns, from 0
  std::size_t first_row = 0;  ///< line after it and after the units, from 0
  std::size_t n_cells = 0;    ///< of the line that names the columns
  std::vector<Pair> pairs;
  bool shared_extension = false;             ///< all pairs have the same column of extension
  std::vector<std::size_t> specimen_column;  ///< one index or none
  bool per_width = false;                    ///< the load is a force per width
  double newton_per_load = 0;                ///< [N] of a 1 in a column of load
  double strain_per_extension = 0;           ///< [-] of a 1 in a column of extension
};

/// Finds the line that names the columns, with its units.
/// @throws InputError, without the file, if there is none, a unit is missing or unknown, the facts do not suffice, or
/// it is not clear which column belongs to which
[[nodiscard]] CurveHead find_curve_head(const std::vector<std::string_view>& lines, const TestFacts& facts);

}  // namespace knitmech::yarn
