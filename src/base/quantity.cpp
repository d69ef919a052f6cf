#include "base/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::base {
namespace {

constexpr std::array kLength{Unit{"mm"}, Unit{"um", 1, 1e3}, Unit{"cm", 10}, Unit{"m", 1e3}};
constexpr std::array kInverseLength{Unit{"/mm"}, Unit{"/cm", 1, 10}, Unit{"/m", 1, 1e3}};
constexpr std::array kPressure{Unit{"MPa"}, Unit{"GPa", 1e3}, Unit{"kPa", 1, 1e3}, Unit{"Pa", 1, 1e6}, Unit{"N/mm^2"}};
constexpr std::array kDensity{Unit{"kg/m^3", 1, 1e12}, Unit{"g/cm^3", 1, 1e9}, Unit{"t/mm^3"}};
constexpr std::array kSpeed{Unit{"mm/s"}, Unit{"mm/min", 1, 60}, Unit{"cm/s", 10}, Unit{"m/s", 1e3}};
constexpr std::array kTime{Unit{"s"}, Unit{"ms", 1, 1e3}, Unit{"us", 1, 1e6}, Unit{"min", 60}};
constexpr std::array kInverseTime{Unit{"/s"}, Unit{"/ms", 1e3}, Unit{"/min", 1, 60}};
constexpr std::array kForce{Unit{"N"}, Unit{"mN", 1, 1e3}, Unit{"cN", 1, 1e2}, Unit{"kN", 1e3}};
constexpr std::array kBendingStiffness{Unit{"N mm^2"}, Unit{"mN mm^2", 1, 1e3}, Unit{"cN mm^2", 1, 1e2},
                                       Unit{"N m^2", 1e6}};
constexpr std::array kStiffness{Unit{"N/mm"}, Unit{"N/m", 1, 1e3}, Unit{"cN/mm", 1, 1e2}, Unit{"kN/m"}};
constexpr std::array kLinearDensity{Unit{"tex", 1, 1e12}, Unit{"dtex", 1, 1e13}, Unit{"den", 1, 9e12},
                                    Unit{"g/m", 1, 1e9}, Unit{"t/mm"}};

constexpr std::array kDimensions{Dimension::length,       Dimension::inverse_length, Dimension::pressure,
                                 Dimension::density,      Dimension::speed,          Dimension::time,
                                 Dimension::inverse_time, Dimension::force,          Dimension::bending_stiffness,
                                 Dimension::stiffness,    Dimension::linear_density};

/// Another spelling of a part of a unit, and the usual one.
struct Spelling {
  std::string_view other;
  std::string_view usual;
};

/// Replaced in this order.
constexpr std::array kSpellings{Spelling{"\u00b5", "u"},
                                Spelling{"\u03bc", "u"},
                                Spelling{"\u00b2", "^2"},
                                Spelling{"\u00b3", "^3"},
                                Spelling{"\u207b\u00b9", "^-1"},
                                Spelling{"\u00b7", ""},
                                Spelling{"\u22c5", ""},
                                Spelling{"*", ""},
                                Spelling{" ", ""},
                                Spelling{"m2", "m^2"},
                                Spelling{"m3", "m^3"}};

std::string normalised(std::string_view unit) {
  std::string result(unit);
  for (const auto& [other, usual] : kSpellings) {
    for (auto at = result.find(other); at != std::string::npos; at = result.find(other, at + usual.size())) {
      result.replace(at, other.size(), usual);
    }
  }
  if (result.starts_with("1/")) result.erase(0, 1);
  if (result.ends_with("^-1")) result = "/" + result.substr(0, result.size() - 3);
  return result;
}

const Unit* find_unit(std::string_view name, Dimension dimension) {
  const auto units = units_of(dimension);
  const auto found = std::ranges::find_if(
      units, [wanted = normalised(name)](const Unit& unit) { return normalised(unit.name) == wanted; });
  return found == units.end() ? nullptr : &*found;
}

/// ", which is for a time", or nothing for a unit that is not known at all.
std::string what_it_measures(std::string_view unit) {
  for (const Dimension dimension : kDimensions) {
    if (find_unit(unit, dimension) != nullptr) return fmt::format(", which is for {}", name_of(dimension));
  }
  return {};
}

double to_internal(double value, const Unit& unit) {
  return value * unit.multiply / unit.divide;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A number and what follows it.
struct Split {
  double number = 0;
  std::string_view rest;
};

std::optional<Split> split_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Split split;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), split.number);
  if (error != std::errc{} || !std::isfinite(split.number)) return std::nullopt;
  split.rest = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  return split;
}

std::string what_would_be_right(Dimension dimension) {
  if (dimension == Dimension::number) return "write a pure number";
  return fmt::format("write {} as a number and a unit, one of {}", name_of(dimension), unit_names(dimension));
}

}  // namespace

std::span<const Unit> units_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return {};
    case Dimension::length:
      return kLength;
    case Dimension::inverse_length:
      return kInverseLength;
    case Dimension::pressure:
      return kPressure;
    case Dimension::density:
      return kDensity;
    case Dimension::speed:
      return kSpeed;
    case Dimension::time:
      return kTime;
    case Dimension::inverse_time:
      return kInverseTime;
    case Dimension::force:
      return kForce;
    case Dimension::bending_stiffness:
      return kBendingStiffness;
    case Dimension::stiffness:
      return kStiffness;
    case Dimension::linear_density:
      return kLinearDensity;
  }
  return {};
}

std::string_view name_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return "a pure number";
    case Dimension::length:
      return "a length";
    case Dimension::inverse_length:
      return "a number per length";
    case Dimension::pressure:
      return "a pressure or modulus";
    case Dimension::density:
      return "a density";
    case Dimension::speed:
      return "a speed";
    case Dimension::time:
      return "a time";
    case Dimension::inverse_time:
      return "a number per time";
    case Dimension::force:
      return "a force";
    case Dimension::bending_stiffness:
      return "a bending or torsional stiffness";
    case Dimension::stiffness:
      return "a stiffness";
    case Dimension::linear_density:
      return "a linear density";
  }
  return {};
}

std::string unit_names(Dimension dimension) {
  std::string names;
  for (const Unit& unit : units_of(dimension)) {
    if (!names.empty()) names += ", ";
    names += unit.name;
  }
  return names;
}

double parse_quantity(std::string_view text, Dimension dimension) {
  const auto split = split_number(trimmed(text));
  if (!split) {
    throw InputError(
        fmt::format("{} does not begin with a finite number; {}", in_quotes(text), what_would_be_right(dimension)));
  }
  const std::string_view unit_text = split->rest;
  if (unit_text.starts_with(',')) {
    throw InputError(fmt::format("{} has a decimal comma; write a decimal point", in_quotes(text)));
  }
  if (dimension == Dimension::number) {
    if (unit_text.empty()) return split->number;
    throw InputError(fmt::format("{} has a unit where a pure number is due", in_quotes(text)));
  }
  if (unit_text.empty()) {
    throw InputError(fmt::format("{} has no unit; {}", in_quotes(text), what_would_be_right(dimension)));
  }
  const Unit* unit = find_unit(unit_text, dimension);
  if (unit == nullptr) {
    throw InputError(fmt::format("{} has the unit {}{}; {}", in_quotes(text), in_quotes(unit_text),
                                 what_it_measures(unit_text), what_would_be_right(dimension)));
  }
  const double value = to_internal(split->number, *unit);
  if (!std::isfinite(value)) {
    throw InputError(fmt::format("{} is too large a number; {}", in_quotes(text), what_would_be_right(dimension)));
  }
  return value;
}

std::string format_quantity(double value, Dimension dimension) {
  if (dimension == Dimension::number) return fmt::format("{}", value);
  constexpr int kDigitsOfDouble = 17;
  const Unit& unit = units_of(dimension).front();
  const double in_unit = value * unit.divide / unit.multiply;
  for (int digits = 1; digits <= kDigitsOfDouble; ++digits) {
    const auto split = split_number(fmt::format("{:.{}g}", in_unit, digits));
    if (split && to_internal(split->number, unit) == value) return fmt::format("{} {}", split->number, unit.name);
  }
  // No number of this unit gives the same bits; every dimension has a unit that is the internal one, which always does.
  const auto units = units_of(dimension);
  const auto internal =
      std::ranges::find_if(units, [](const Unit& each) { return each.multiply == 1 && each.divide == 1; });
  return fmt::format("{} {}", value, internal->name);
}

}  // namespace knitmech::base
