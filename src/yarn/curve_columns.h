#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/quantity.h"

namespace knitmech::yarn {

/// What a column of a tensile curve holds.
enum class ColumnQuantity {
  force,            ///< [N]
  specific_force,   ///< force per linear density [N/(t/mm)], the "stress" of textile tests, as in cN/tex
  stress,           ///< [MPa], of the unstrained section
  force_per_width,  ///< [N/mm], of the unstrained width, the "stress" of fabric tests
  strain,           ///< [-]
  displacement,     ///< of the grip [mm]
};

/// A unit in which a column may be written.
struct ColumnUnit {
  base::Unit unit;
  ColumnQuantity quantity = ColumnQuantity::force;
};

/// Which of the two axes of the curve a column is for, or what specimen a row belongs to.
enum class ColumnRole { load, extension, specimen };

/// A column of a table with its name.
struct Column {
  std::size_t index = 0;  ///< from 0
  ColumnRole role = ColumnRole::load;
  std::string head;                  ///< as it stands in the file
  std::string unit_text;             ///< empty if the head names none
  std::optional<ColumnUnit> unit{};  ///< empty if there is none, or none that is known for the role
  bool unit_is_chosen = false;       ///< by ColumnChoice
};

/// The columns to be taken, as their heads name them, where words do not tell; each may say its unit in brackets behind
/// the name, "axial_strain [-]", where the file does not. Empty: the words decide.
struct ColumnChoice {
  std::string load{};
  std::string extension{};
};

/// The columns that a line names, by words of load ("force", "Kraft", "tenacity", "contrainte", ...), of extension
/// ("strain", "Dehnung", "Weg", "allongement", ...) and of specimens ("specimen", "Probe", ...), anywhere in the cell
/// and without regard to capitals and accents. Other cells, such as a time, are no columns for us, nor are strains
/// across the pull ("transverse", "lateral", "quer", ...). A chosen column takes the place of all others of its role;
/// if the line does not name it, that role has no column.
///
/// The unit stands in the same cell: "Force [N]", "Kraft (cN)", "Strain / %", "Weg in mm", "force_N",
/// "stress_N_per_mm".
[[nodiscard]] std::vector<Column> columns_named_in(std::span<const std::string_view> cells,
                                                   const ColumnChoice& choice = {});

/// The unit of this spelling, for a column of this role; brackets around it are taken off. Empty if there is none.
[[nodiscard]] std::optional<ColumnUnit> find_column_unit(std::string_view spelling, ColumnRole role);

/// The units of a role, "N, mN, cN, ...": for messages.
[[nodiscard]] std::string column_unit_names(ColumnRole role);

}  // namespace knitmech::yarn
