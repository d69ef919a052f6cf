#include "study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "model/case_file.h"
#include "study/read_measured.h"
#include "study/read_variations.h"
#include "study/study_entries.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;

constexpr int kDefaultSamples = 16;

void check_top_keys(const StudyEntries& entries) {
  static const std::vector<std::string_view> kKeys = {"title", "base", "plan", "samples", "seed", "strains"};
  for (const model::TomlEntry& entry : entries.all()) {
    const bool is_section = std::holds_alternative<model::TomlSection>(entry.value);
    if (entry.key.find('.') != std::string::npos) continue;
    const bool is_known = std::ranges::find(kKeys, std::string_view(entry.key)) != kKeys.end();
    if (is_known && is_section) entries.refuse(entry.line, entry.key, "is a section, but must be a value");
    if (is_known || is_section) continue;
    const auto nearest = base::nearest_word(entry.key, kKeys);
    entries.refuse(entry.line, base::in_quotes(entry.key),
                   "there is no such key; " + (nearest.empty() ? "the keys are " + base::alternatives(kKeys)
                                                               : fmt::format("did you mean {}?", nearest)));
  }
}

Plan plan_in(const StudyEntries& entries) {
  static const std::vector<std::string_view> kPlans = {"grid", "one-at-a-time", "latin-hypercube", "sobol"};
  const std::string word = entries.text_at("plan", "grid");
  const auto found = std::ranges::find(kPlans, std::string_view(word));
  if (found == kPlans.end()) {
    entries.refuse(entries.find("plan")->line, "plan",
                   fmt::format("is {}, but must be {}", base::in_quotes(word), base::alternatives(kPlans)));
  }
  return static_cast<Plan>(found - kPlans.begin());
}

model::Case base_in(const StudyEntries& entries) {
  const std::string base = entries.text_at("base", "");
  if (base.empty()) {
    entries.refuse(0, "base", "is missing; write for example base = \"case.toml\", the case that is varied");
  }
  return model::read_case_file(entries.path().parent_path() / base);
}

/// \param otherwise where the file gives none
std::vector<double> strains_in(const StudyEntries& entries, const std::vector<double>& otherwise) {
  const std::vector<model::TomlItem> given = entries.list_at("strains");
  if (given.empty()) return otherwise;
  std::vector<double> strains;
  for (const model::TomlItem& item : given) {
    const auto* whole = std::get_if<std::int64_t>(&item);
    const auto* number = std::get_if<double>(&item);
    const double strain = whole != nullptr ? static_cast<double>(*whole) : number != nullptr ? *number : -1;
    const double before = strains.empty() ? 0 : strains.back();
    if (!(strain > before) || !std::isfinite(strain)) {
      entries.refuse(entries.find("strains")->line, "strains",
                     "must be ascending numbers above 0, for example [0.08, 0.16]");
    }
    strains.push_back(strain);
  }
  return strains;
}

/// Refuses to vary what says nothing about the fabric of the base case.
void check_meaning(const StudyEntries& entries, const Study& study) {
  for (const Variation& each : study.variations) {
    if (model::applies_to(*each.parameter, study.base)) continue;
    entries.refuse(0, each.parameter->key,
                   study.base.fabric.yarn_file ? "has no meaning for the base case, whose fabric is read from a file"
                                               : "has no meaning for the base case, whose fabric is made of loops");
  }
}

void check_sampling(const StudyEntries& entries, const Study& study) {
  if (takes_samples(study.plan)) {
    if (!study.variations.empty()) return;
    entries.refuse(0, "",
                   "has nothing to sample; write for example [contact.friction] and below it from = 0.1, to = 0.3");
  }
  for (const char* key : {"samples", "seed"}) {
    const model::TomlEntry* entry = entries.find(key);
    if (entry == nullptr) continue;
    entries.refuse(entry->line, key,
                   R"(serves only a plan that takes samples, "latin-hypercube" or "sobol"; remove it)");
  }
}

void check_number_of_cases(const StudyEntries& entries, const Study& study) {
  double number = 1;
  for (const Variation& each : study.variations) {
    number *= static_cast<double>(std::max<std::size_t>(1, each.values.size()));
  }
  if (study.plan != Plan::grid || number <= kMostCases) return;
  entries.refuse(0, "",
                 fmt::format("asks for {:.0f} cases, but at most {} are allowed; take fewer values, or plan = "
                             "\"latin-hypercube\"",
                             number, kMostCases));
}

}  // namespace

Study parse_study(std::string_view text, const fs::path& path) {
  const StudyEntries entries(text, path);
  check_top_keys(entries);
  Study study;
  study.file = path;
  study.title = entries.text_at("title", path.stem().string());
  study.plan = plan_in(entries);
  study.samples = static_cast<int>(entries.whole_at("samples", kDefaultSamples, 1, kMostCases));
  study.seed = static_cast<std::uint64_t>(entries.whole_at("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
  study.base = base_in(entries);
  study.strains = strains_in(entries, study.base.output.frames_at);
  study.measured = read_measured(entries);
  study.variations = read_variations(entries, study.plan);
  check_meaning(entries, study);
  check_sampling(entries, study);
  check_number_of_cases(entries, study);
  return study;
}

Study read_study_file(const fs::path& path) {
  return parse_study(model::case_file_text(path), path);
}

}  // namespace knitmech::study
