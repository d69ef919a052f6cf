#include "model/parameter_value.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/text.h"
#include "model/parameters_text.h"

namespace knitmech::model {
namespace {

[[noreturn]] void refuse(const Parameter& parameter, const std::string& complaint) {
  throw InputError(fmt::format("{}, for example {}", complaint, example_of(parameter)));
}

std::string in_words(const TomlValue& given) {
  if (const auto* other = std::get_if<TomlOther>(&given)) return other->type;
  if (const auto* text = std::get_if<std::string>(&given)) return fmt::format("the text {}", base::in_quotes(*text));
  if (const auto* whole = std::get_if<std::int64_t>(&given)) return fmt::format("the number {}", *whole);
  if (const auto* number = std::get_if<double>(&given)) return fmt::format("the number {}", *number);
  return "a list";
}

/// A pure number of a file, whole or not; empty for anything else.
template <class Given>
std::optional<double> number_in(const Given& given) {
  if (const auto* whole = std::get_if<std::int64_t>(&given)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&given)) return *number;
  return std::nullopt;
}

double finite(const Parameter& parameter, double number) {
  if (!std::isfinite(number)) refuse(parameter, fmt::format("is {}; write a finite number", number));
  return number;
}

Value quantity_from(const Parameter& parameter, const TomlValue& given) {
  const auto* text = std::get_if<std::string>(&given);
  if (text != nullptr && *text == "auto" && parameter.need == Need::automatic) return {};
  const auto number = number_in(given);
  if (parameter.dimension == base::Dimension::number) {
    if (number) return finite(parameter, *number);
    refuse(parameter, fmt::format("is {}; write a number without quotes", in_words(given)));
  }
  if (number) {
    refuse(parameter, fmt::format("the number {} has no unit; write {} with its unit ({}) in quotes", *number,
                                  base::name_of(parameter.dimension), base::unit_names(parameter.dimension)));
  }
  if (text == nullptr) refuse(parameter, fmt::format("is {}; write a number and a unit in quotes", in_words(given)));
  try {
    return base::parse_quantity(*text, parameter.dimension);
  } catch (const InputError& error) {
    refuse(parameter, error.what());
  }
}

Value whole_number_from(const Parameter& parameter, const TomlValue& given) {
  const auto* whole = std::get_if<std::int64_t>(&given);
  if (whole == nullptr) refuse(parameter, fmt::format("is {}; write a whole number without quotes", in_words(given)));
  if (!std::in_range<int>(*whole)) {
    throw InputError(complaint_about(parameter, static_cast<double>(*whole)));
  }
  return static_cast<int>(*whole);
}

double item_from(const Parameter& parameter, const TomlItem& item, std::size_t place) {
  const auto number = number_in(item);
  if (parameter.dimension == base::Dimension::number) {
    if (number) return finite(parameter, *number);
    refuse(parameter, fmt::format("has something else than a number at place {}; write numbers without quotes", place));
  }
  const auto* text = std::get_if<std::string>(&item);
  if (text == nullptr) {
    refuse(parameter, fmt::format("has something else than a text at place {}; write each {} with its unit ({}) in "
                                  "quotes",
                                  place, base::name_of(parameter.dimension), base::unit_names(parameter.dimension)));
  }
  try {
    return base::parse_quantity(*text, parameter.dimension);
  } catch (const InputError& error) {
    refuse(parameter, fmt::format("at place {}: {}", place, error.what()));
  }
}

Value list_from(const Parameter& parameter, const TomlValue& given) {
  const auto* items = std::get_if<std::vector<TomlItem>>(&given);
  if (items == nullptr) refuse(parameter, fmt::format("is {}; write a list", in_words(given)));
  std::vector<double> numbers;
  for (const TomlItem& item : *items) numbers.push_back(item_from(parameter, item, numbers.size() + 1));
  return numbers;
}

Value text_from(const Parameter& parameter, const TomlValue& given) {
  if (const auto* text = std::get_if<std::string>(&given)) return *text;
  refuse(parameter, fmt::format("is {}; write a text in quotes", in_words(given)));
}

}  // namespace

Value unchecked_value_from(const Parameter& parameter, const TomlValue& given) {
  switch (kind_of(parameter)) {
    case Kind::quantity:
      return quantity_from(parameter, given);
    case Kind::whole_number:
      return whole_number_from(parameter, given);
    case Kind::list_of_quantities:
      return list_from(parameter, given);
    case Kind::text:
    case Kind::choice:
      break;
  }
  return text_from(parameter, given);
}

Value value_from(const Parameter& parameter, const TomlValue& given) {
  Value value = unchecked_value_from(parameter, given);
  const std::string complaint = complaint_about(parameter, value);
  if (!complaint.empty()) throw InputError(complaint);
  return value;
}

}  // namespace knitmech::model
