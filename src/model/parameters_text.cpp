#include "model/parameters_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/case_rules.h"

namespace knitmech::model {
namespace {

/// Young's modulus and Poisson's ratio are optional to the reader, but one way of giving the yarn must be active.
bool is_active_in_template(const Parameter& parameter) {
  return parameter.need == Need::required || parameter.key == "yarn.youngs_modulus" ||
         parameter.key == "yarn.poissons_ratio";
}

std::string described(const Parameter& parameter) {
  return parameter.symbol.empty() ? std::string(parameter.help)
                                  : fmt::format("{}: {}", parameter.symbol, parameter.help);
}

std::string choices_text(const Parameter& parameter) {
  return fmt::format("\"{}\"", fmt::join(parameter.choices, "\" or \""));
}

std::string default_text(const Parameter& parameter) {
  switch (parameter.need) {
    case Need::required:
      return "required";
    case Need::defaulted:
      return toml_text(parameter, parameter.value);
    case Need::automatic:
      return "\"auto\"";
    case Need::optional:
      return "not given";
  }
  return {};
}

std::string range_text(const Parameter& parameter) {
  switch (kind_of(parameter)) {
    case Kind::text:
      return "any words";
    case Kind::choice:
      return choices_text(parameter);
    case Kind::quantity:
    case Kind::whole_number:
    case Kind::list_of_quantities:
      break;
  }
  const auto text = [&](double each) { return base::format_quantity(each, parameter.dimension); };
  return fmt::format("{} {} to {}", parameter.range.least_excluded ? "above" : "from", text(parameter.range.least),
                     text(parameter.range.greatest));
}

std::string written_as(const Parameter& parameter) {
  switch (kind_of(parameter)) {
    case Kind::text:
      return "text";
    case Kind::choice:
      return "one of the words";
    case Kind::whole_number:
      return "whole number";
    case Kind::list_of_quantities:
      return parameter.dimension == base::Dimension::number
                 ? "list of numbers"
                 : fmt::format("list of texts, {}", base::unit_names(parameter.dimension));
    case Kind::quantity:
      break;
  }
  if (parameter.dimension == base::Dimension::number) return "number";
  return base::unit_names(parameter.dimension);
}

/// The parameters of a section.
std::vector<Parameter> parameters_in(const CaseSection& section) {
  std::vector<Parameter> found;
  std::ranges::copy_if(parameters(), std::back_inserter(found),
                       [&](const Parameter& each) { return section_name_of(each.key) == section.name; });
  return found;
}

/// Pairs of assignment and comment with the comments in one column.
std::string commented_lines(const std::vector<std::pair<std::string, std::string>>& lines) {
  std::size_t width = 0;
  for (const auto& [left, comment] : lines) width = std::max(width, left.size());
  std::string text;
  for (const auto& [left, comment] : lines) text += fmt::format("{:{}}  # {}\n", left, width, comment);
  return text;
}

/// The case that holds when no parameter with a default is given.
Case case_of_defaults() {
  Case input = default_case();
  cut_frames_to_test(input);
  return input;
}

std::string template_line(const Parameter& parameter) {
  if (is_active_in_template(parameter)) return example_of(parameter);
  if (parameter.need == Need::optional) return "# " + example_of(parameter);
  return "# " + assignment(parameter, value_in(case_of_defaults(), parameter));
}

}  // namespace

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    const bool control = static_cast<unsigned char>(letter) < ' ' || letter == 0x7F;
    result += control ? fmt::format("\\u{:04x}", static_cast<unsigned>(letter)) : std::string(1, letter);
  }
  return result + "\"";
}

std::string toml_text(const Parameter& parameter, const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return "\"auto\"";
  if (const auto* text = std::get_if<std::string>(&value)) return toml_string(*text);
  if (const auto* whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
  const auto written = [&](double number) {
    const std::string text = base::format_quantity(number, parameter.dimension);
    return parameter.dimension == base::Dimension::number ? text : toml_string(text);
  };
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (numbers == nullptr) return written(std::get<double>(value));
  std::vector<std::string> items;
  for (const double number : *numbers) items.push_back(written(number));
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string assignment(const Parameter& parameter, const Value& value) {
  return fmt::format("{} = {}", name_of(parameter.key), toml_text(parameter, value));
}

std::string case_template() {
  std::string text =
      "# A case for KnitMech. A value with a dimension is written in quotes with its unit, \"0.12 mm\".\n"
      "# A line that begins with \"# name =\" shows what holds when the line is not there; to change it, remove the "
      "\"#\".\n"
      "# In [yarn] and [edge_yarn], stiffnesses, filaments, curve and strength are examples instead: most take the "
      "place of\n# youngs_modulus and poissons_ratio.\n"
      "# A file of yarn centrelines can take the place of [loop] and [fabric]: fabric.yarns, see docs/import.md.\n";
  for (const CaseSection& section : sections()) {
    text += section.name.empty() ? "\n" : fmt::format("\n# {}.\n[{}]\n", section.help, section.name);
    std::vector<std::pair<std::string, std::string>> lines;
    for (const Parameter& parameter : parameters_in(section)) {
      if (parameter.from == FabricFrom::file) continue;
      lines.emplace_back(template_line(parameter), described(parameter));
    }
    text += commented_lines(lines);
  }
  return text;
}

std::string input_reference() {
  std::string text =
      "# Input reference\n\n"
      "Every key of a case file. This page is written by `knitmech parameters --markdown` from the table that the "
      "program\n"
      "reads its input with.\n\n"
      "A case file is [TOML](https://toml.io). A value with a dimension is a text of a number and a unit, `\"0.12 "
      "mm\"`; a\n"
      "pure number has no quotes. What is not required may be left out, then the default holds.\n";
  for (const CaseSection& section : sections()) {
    const std::string title = section.name.empty() ? "Top of the file" : fmt::format("[{}]", section.name);
    text += fmt::format("\n## {}\n\n{}.\n\n", title, section.help);
    text += "| key | symbol | meaning | written as | default | allowed | example |\n|---|---|---|---|---|---|---|\n";
    for (const Parameter& each : parameters_in(section)) {
      text += fmt::format("| `{}` | {} | {} | {} | {} | {} | `{}` |\n", name_of(each.key), each.symbol, each.help,
                          written_as(each), default_text(each), range_text(each), toml_text(each, each.value));
    }
  }
  return text;
}

std::string parameter_list() {
  std::string text;
  for (const Parameter& each : parameters()) {
    text += fmt::format("{}\n    {}\n    {}; default: {}; allowed: {}\n", each.key, described(each), written_as(each),
                        default_text(each), range_text(each));
  }
  return text;
}

}  // namespace knitmech::model
