#include "study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "base/quantity.h"
#include "model/case_rules.h"
#include "model/parameters.h"
#include "study/samples.h"
#include "study/value_in_range.h"

namespace knitmech::study {
namespace {

/// The values of each variant, before it is known whether they can be.
using Rows = std::vector<std::vector<model::Value>>;

Rows grid_rows(const Study& study) {
  Rows rows = {{}};
  for (const Variation& variation : study.variations) {
    Rows longer;
    for (const auto& row : rows) {
      for (const model::Value& value : variation.values) {
        longer.push_back(row);
        longer.back().push_back(value);
      }
    }
    rows = std::move(longer);
  }
  return rows;
}

std::vector<model::Value> base_row(const Study& study) {
  std::vector<model::Value> row;
  for (const Variation& variation : study.variations) row.push_back(model::value_in(study.base, *variation.parameter));
  return row;
}

Rows one_at_a_time_rows(const Study& study) {
  Rows rows = {base_row(study)};
  for (std::size_t i = 0; i < study.variations.size(); ++i) {
    for (const model::Value& value : study.variations[i].values) {
      std::vector<model::Value> row = rows.front();
      row[i] = value;
      if (std::ranges::find(rows, row) == rows.end()) rows.push_back(std::move(row));
    }
  }
  return rows;
}

Rows sampled_rows(const Study& study) {
  const auto n_samples = static_cast<std::size_t>(study.samples);
  const std::size_t n_variations = study.variations.size();
  const Samples samples =
      study.plan == Plan::sobol ? sobol(n_samples, n_variations) : latin_hypercube(n_samples, n_variations, study.seed);
  Rows rows;
  for (const auto& sample : samples) {
    std::vector<model::Value> row;
    for (std::size_t i = 0; i < n_variations; ++i) row.push_back(value_in_range(study.variations[i], sample[i]));
    rows.push_back(std::move(row));
  }
  return rows;
}

Rows rows_of(const Study& study) {
  switch (study.plan) {
    case Plan::grid:
      return grid_rows(study);
    case Plan::one_at_a_time:
      return one_at_a_time_rows(study);
    case Plan::latin_hypercube:
    case Plan::sobol:
      break;
  }
  return sampled_rows(study);
}

/// A text as a part of a file name: letters, digits, "." and "-".
std::string as_file_name(const std::string& text) {
  std::string name;
  for (const char each : text) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(each)) != 0 || each == '.' || each == '-';
    if (is_plain) {
      name += each;
    } else if (!name.empty() && name.back() != '_' && each != ' ') {
      name += '_';
    }
  }
  return name;
}

/// Of a case that differs from the base in few values: "friction-0.1"; of a sample: "sample-007".
std::string name_of(const Study& study, const std::vector<model::Value>& row, std::size_t index) {
  constexpr int kDigits = 6;
  if (study.plan == Plan::latin_hypercube || study.plan == Plan::sobol) return fmt::format("sample-{:03}", index + 1);
  const std::vector<model::Value> base = base_row(study);
  std::string name;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const model::Parameter& parameter = *study.variations[i].parameter;
    if (study.plan == Plan::one_at_a_time && row[i] == base[i]) continue;
    name += fmt::format("{}{}-{}", name.empty() ? "" : "_", model::name_of(parameter.key),
                        as_file_name(value_text(parameter, row[i], kDigits)));
  }
  return name.empty() ? "base" : name;
}

/// The first thing that is wrong with the values of a case; empty if nothing is.
std::string complaint_about_row(const Study& study, const std::vector<model::Value>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const model::Parameter& parameter = *study.variations[i].parameter;
    if (std::holds_alternative<std::monostate>(row[i])) continue;  // "auto", or not given in the base case
    const std::string complaint = model::complaint_about(parameter, row[i]);
    if (!complaint.empty()) return fmt::format("{} {}", parameter.key, complaint);
  }
  return {};
}

void fill_case(const Study& study, Variant& variant) {
  variant.input = study.base;
  variant.complaint = complaint_about_row(study, variant.values);
  if (!variant.complaint.empty()) return;
  for (std::size_t i = 0; i < variant.values.size(); ++i) {
    model::set_value(variant.input, *study.variations[i].parameter, variant.values[i]);
  }
  const auto broken = model::broken_rule(variant.input);
  if (!broken) return;
  const bool names_key = broken->complaint.find(broken->key) != std::string::npos;
  variant.complaint = names_key ? broken->complaint : fmt::format("{}: {}", broken->key, broken->complaint);
}

/// A number without the last digits that steps through a range leave: 0.3 for 0.30000000000000004.
double without_rounding(double number) {
  const std::string text = fmt::format("{:.12g}", number);
  double rounded = number;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

}  // namespace

model::Value value_in_range(const Variation& variation, double share) {
  const double number = variation.logarithmic ? variation.from * std::pow(variation.to / variation.from, share)
                                              : variation.from + share * (variation.to - variation.from);
  if (kind_of(*variation.parameter) == model::Kind::whole_number) return static_cast<int>(std::lround(number));
  return without_rounding(number);
}

std::string value_text(const model::Parameter& parameter, const model::Value& value, std::optional<int> digits) {
  if (std::holds_alternative<std::monostate>(value)) return "auto";
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  if (const auto* whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
  const double number = std::get<double>(value);
  std::string whole_text = base::format_quantity(number, parameter.dimension);
  if (!digits) return whole_text;
  const auto space = whole_text.find(' ');
  const std::string unit = space == std::string::npos ? "" : whole_text.substr(space);
  double in_unit = 0;
  std::from_chars(whole_text.data(), whole_text.data() + whole_text.size(), in_unit);
  return fmt::format("{:.{}g}{}", in_unit, *digits, unit);
}

std::vector<Variant> variants_of(const Study& study) {
  std::vector<Variant> variants;
  std::set<std::string> names;
  for (const std::vector<model::Value>& row : rows_of(study)) {
    Variant variant;
    variant.name = name_of(study, row, variants.size());
    // Two values that look alike when rounded, or a value that is there twice.
    for (int copy = 2; !names.insert(variant.name).second; ++copy) {
      variant.name = fmt::format("{}_{}", name_of(study, row, variants.size()), copy);
    }
    variant.values = row;
    fill_case(study, variant);
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace knitmech::study
