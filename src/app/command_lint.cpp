#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/errors.h"
#include "base/text.h"
#include "exchange/abaqus_lint.h"

namespace knitmech::app {
namespace {

using exchange::DeckFinding;

std::vector<DeckFinding> findings_in(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw FileError(fmt::format("cannot read the deck {}", base::in_quotes(file)));
  return exchange::lint_abaqus(in, file);
}

std::string place_of(const DeckFinding& finding, const std::string& file) {
  return finding.line == 0 ? "" : fmt::format("{}, line {}: ", file, finding.line);
}

std::string lint_json(const std::vector<DeckFinding>& findings, const std::string& file) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DeckFinding& each : findings) {
    list.push_back({{"line", each.line == 0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(each.line)},
                    {"kind", each.is_error ? "error" : "note"},
                    {"message", each.message}});
  }
  return nlohmann::ordered_json{{"file", file}, {"findings", list}}.dump(2);
}

}  // namespace

ExitCode run_command(const LintOptions& options) {
  const std::vector<DeckFinding> findings = findings_in(options.file);
  const auto n_errors = std::ranges::count_if(findings, &DeckFinding::is_error);
  if (options.json) {
    fmt::print("{}\n", lint_json(findings, options.file));
    return n_errors == 0 ? kDone : kWrongInput;
  }
  for (const DeckFinding& each : findings) {
    fmt::print("{}{}{}\n", place_of(each, options.file), each.is_error ? "" : "note: ", each.message);
  }
  fmt::print("{}: {} {}, {} {}\n", options.file, n_errors, n_errors == 1 ? "error" : "errors",
             findings.size() - static_cast<std::size_t>(n_errors), "notes");
  return n_errors == 0 ? kDone : kWrongInput;
}

}  // namespace knitmech::app
