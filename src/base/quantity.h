#pragma once

#include <span>
#include <string>
#include <string_view>

namespace knitmech::base {

/// What a number measures. Internally everything is in mm, N, s, t and hence MPa; text always says the unit.
enum class Dimension {
  number,             ///< a pure number, written without a unit
  length,             ///< [mm]
  inverse_length,     ///< [1/mm]
  pressure,           ///< [MPa], also a modulus
  density,            ///< [t/mm^3]
  speed,              ///< [mm/s]
  time,               ///< [s]
  inverse_time,       ///< [1/s]
  force,              ///< [N]
  bending_stiffness,  ///< [N mm^2], also a torsional stiffness
  stiffness,          ///< [N/mm]
  linear_density,     ///< [t/mm], the fineness of a yarn
};

/// A unit of text: value [internal] = value [unit] * multiply / divide.
///
/// Both factors are whole numbers that a double holds exactly, so that "120 um" and "0.12 mm" give the same bits.
struct Unit {
  std::string_view name;
  double multiply = 1;
  double divide = 1;
};

/// The units in which a dimension may be written; the first is the one used for writing. Empty for a pure number.
[[nodiscard]] std::span<const Unit> units_of(Dimension dimension);

/// "a length", "a pressure", ...: for messages.
[[nodiscard]] std::string_view name_of(Dimension dimension);

/// The names of the units of a dimension, "mm, um, cm, m": for messages.
[[nodiscard]] std::string unit_names(Dimension dimension);

/// The value of a text such as "0.12 mm" in internal units.
///
/// Number, then unit, with or without space between them. Of a unit these spellings are the same: "N mm^2", "N*mm^2",
/// "N·mm²", "N mm2"; "um" and "µm"; "/mm", "1/mm" and "mm^-1".
///
/// @throws InputError that says what is wrong with the text and what would be right: no number, no unit, a unit that
/// does
///         not fit (and of what it is a unit), a decimal comma, not finite. The place of the text is for the caller to
///         add.
[[nodiscard]] double parse_quantity(std::string_view text, Dimension dimension);

/// The text of a value [internal units], with the fewest digits from which parse_quantity() gives the same bits.
///
/// A pure number has no unit. @param value finite
[[nodiscard]] std::string format_quantity(double value, Dimension dimension);

}  // namespace knitmech::base
