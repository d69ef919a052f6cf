#include "study/read_variations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "base/text.h"
#include "model/parameter_value.h"
#include "study/value_in_range.h"

namespace knitmech::study {
namespace {

/// What a section says about one parameter, as it stands in the file.
struct Given {
  int line = 0;
  std::map<std::string, model::TomlEntry, std::less<>> entries;

  [[nodiscard]] const model::TomlEntry* find(std::string_view name) const {
    const auto found = entries.find(name);
    return found == entries.end() ? nullptr : &found->second;
  }
};

const model::Parameter& parameter_of(const StudyEntries& entries, const std::string& key, int line) {
  const model::Parameter* parameter = model::find_parameter(key);
  if (parameter == nullptr) {
    std::vector<std::string_view> keys;
    for (const model::Parameter& each : model::parameters()) keys.emplace_back(each.key);
    const auto nearest = base::nearest_word(key, keys);
    entries.refuse(
        line, "",
        fmt::format("there is no parameter {}; {}", key,
                    nearest.empty() ? "`knitmech parameters` lists them" : fmt::format("did you mean {}?", nearest)));
  }
  if (kind_of(*parameter) == model::Kind::list_of_quantities || kind_of(*parameter) == model::Kind::text) {
    entries.refuse(line, key, "cannot be varied, only a number or a choice can");
  }
  return *parameter;
}

model::Value value_from(const StudyEntries& entries, const model::Parameter& parameter, const model::TomlValue& value,
                        int line) {
  try {
    return model::unchecked_value_from(parameter, value);
  } catch (const InputError& error) {
    entries.refuse(line, parameter.key, error.what());
  }
}

void take_values(const StudyEntries& entries, Variation& variation, const model::TomlEntry& entry) {
  const auto* list = std::get_if<std::vector<model::TomlItem>>(&entry.value);
  if (list == nullptr || list->empty()) entries.refuse(entry.line, entry.key, "must be a list with at least one entry");
  for (const model::TomlItem& item : *list) {
    const model::TomlValue value = std::visit([](const auto& each) -> model::TomlValue { return each; }, item);
    variation.values.push_back(value_from(entries, *variation.parameter, value, entry.line));
  }
}

/// One end of a range, as a number in internal units.
double end_of_range(const StudyEntries& entries, const model::Parameter& parameter, const Given& given,
                    const char* name) {
  const model::TomlEntry* entry = given.find(name);
  if (entry == nullptr) {
    entries.refuse(given.line, parameter.key, fmt::format("has no {}; write from and to, or a list of values", name));
  }
  const model::Value value = value_from(entries, parameter, entry->value, entry->line);
  if (const auto* whole = std::get_if<int>(&value)) return *whole;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  entries.refuse(entry->line, parameter.key, "has no range; give a list of values");
}

void take_spacing(const StudyEntries& entries, Variation& variation, const Given& given) {
  const model::TomlEntry* spacing = given.find("spacing");
  if (spacing == nullptr) return;
  const auto* word = std::get_if<std::string>(&spacing->value);
  if (word == nullptr || (*word != "linear" && *word != "logarithmic")) {
    entries.refuse(spacing->line, variation.parameter->key, R"(must have spacing "linear" or "logarithmic")");
  }
  variation.logarithmic = *word == "logarithmic";
  if (variation.logarithmic && !(variation.from > 0)) {
    entries.refuse(spacing->line, variation.parameter->key, "must begin above 0 to be spaced logarithmically");
  }
}

void take_range(const StudyEntries& entries, Plan plan, Variation& variation, const Given& given) {
  const model::Parameter& parameter = *variation.parameter;
  variation.from = end_of_range(entries, parameter, given, "from");
  variation.to = end_of_range(entries, parameter, given, "to");
  if (!(variation.from < variation.to)) entries.refuse(given.line, parameter.key, "must have from below to");
  take_spacing(entries, variation, given);
  const model::TomlEntry* steps = given.find("steps");
  if (takes_samples(plan)) {
    if (steps != nullptr)
      entries.refuse(steps->line, parameter.key, "has steps, but the plan takes samples; remove them");
    return;
  }
  const auto* whole = steps == nullptr ? nullptr : std::get_if<std::int64_t>(&steps->value);
  if (whole == nullptr || *whole < 2 || *whole > kMostCases) {
    entries.refuse(
        steps == nullptr ? given.line : steps->line, parameter.key,
        fmt::format("needs steps, the number of values in the range: a whole number from 2 to {}", kMostCases));
  }
  for (std::int64_t i = 0; i < *whole; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(*whole - 1);
    variation.values.push_back(value_in_range(variation, share));
  }
}

Variation variation_from(const StudyEntries& entries, Plan plan, const std::string& key, const Given& given) {
  static const std::vector<std::string_view> kNames = {"values", "from", "to", "steps", "spacing"};
  Variation variation;
  variation.parameter = &parameter_of(entries, key, given.line);
  for (const auto& [name, entry] : given.entries) {
    if (std::ranges::find(kNames, std::string_view(name)) == kNames.end()) {
      entries.refuse(entry.line, "",
                     fmt::format("there is no key {} here; the keys of [{}] are {}", base::in_quotes(name), key,
                                 base::alternatives(kNames)));
    }
  }
  const model::TomlEntry* values = given.find("values");
  if (values != nullptr && given.entries.size() > 1) {
    entries.refuse(values->line, key, "has both values and a range; remove one of the two");
  }
  if (values != nullptr && takes_samples(plan)) {
    entries.refuse(values->line, key, "has a list of values, but the plan takes samples of a range; write from and to");
  }
  if (values == nullptr) {
    take_range(entries, plan, variation, given);
  } else {
    take_values(entries, variation, *values);
  }
  return variation;
}

}  // namespace

std::vector<Variation> read_variations(const StudyEntries& entries, Plan plan) {
  std::vector<std::pair<std::string, Given>> sections;
  for (const model::TomlEntry& entry : entries.all()) {
    const auto n_dots = std::ranges::count(entry.key, '.');
    if (n_dots == 0 || entry.key.starts_with("measured.")) continue;
    if (n_dots == 1) {
      if (!std::holds_alternative<model::TomlSection>(entry.value)) {
        entries.refuse(entry.line, entry.key,
                       fmt::format("is a value; write [{}] and below it values = [...] to vary it", entry.key));
      }
      sections.push_back({entry.key, {.line = entry.line, .entries = {}}});
      continue;
    }
    // What stands below a section follows it, up to the next.
    const auto dot = entry.key.rfind('.');
    const auto section = std::ranges::find(sections, entry.key.substr(0, dot), &std::pair<std::string, Given>::first);
    if (section == sections.end()) entries.refuse(entry.line, "", fmt::format("there is no parameter {}", entry.key));
    section->second.entries.emplace(entry.key.substr(dot + 1), entry);
  }
  std::vector<Variation> variations;
  variations.reserve(sections.size());
  for (const auto& [key, given] : sections) variations.push_back(variation_from(entries, plan, key, given));
  return variations;
}

}  // namespace knitmech::study
