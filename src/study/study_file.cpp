#include "study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/quantity.h"
#include "base/text.h"
#include "model/case_file.h"
#include "model/parameter_value.h"
#include "model/toml_entries.h"
#include "study/value_in_range.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;

constexpr int kMostSamples = 10000;
constexpr int kDefaultSamples = 16;

/// What a section says about one parameter, as it stands in the file.
struct Given {
  int line = 0;
  std::map<std::string, model::TomlEntry, std::less<>> entries;

  [[nodiscard]] const model::TomlEntry* find(std::string_view name) const {
    const auto found = entries.find(name);
    return found == entries.end() ? nullptr : &found->second;
  }
};

/// Reads one study file.
class Reader {
 public:
  Reader(std::string_view text, const fs::path& path) : path_(path) {
    study_.file = path;
    try {
      entries_ = model::toml_entries(text, 2);
    } catch (const model::TomlSyntaxError& error) {
      refuse(error.line(), "", error.what());
    }
  }

  Study read() {
    take_top();
    for (const model::TomlEntry& entry : entries_) take_section_entry(entry);
    for (const std::string& key : order_) study_.variations.push_back(variation_from(key, sections_.at(key)));
    if (is_sampled() && study_.variations.empty()) refuse(0, "", "has nothing to sample; " + advice());
    check_number();
    return std::move(study_);
  }

 private:
  [[noreturn]] void refuse(int line, const std::string& key, const std::string& complaint) const {
    throw model::CaseFileError(path_.string(), line, key, complaint);
  }
  [[nodiscard]] static std::string advice() {
    return "write for example [contact.friction] and below it values = [0, 0.1, 0.2]";
  }
  [[nodiscard]] bool is_sampled() const { return study_.plan == Plan::latin_hypercube || study_.plan == Plan::sobol; }

  [[nodiscard]] const model::TomlEntry* find(std::string_view key) const {
    const auto found = std::ranges::find(entries_, key, &model::TomlEntry::key);
    return found == entries_.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::string text_at(std::string_view key, const std::string& otherwise) const {
    const model::TomlEntry* entry = find(key);
    if (entry == nullptr) return otherwise;
    const auto* text = std::get_if<std::string>(&entry->value);
    if (text == nullptr) refuse(entry->line, entry->key, "is no text; write it in quotes");
    return *text;
  }

  [[nodiscard]] std::int64_t whole_at(std::string_view key, std::int64_t otherwise, std::int64_t least,
                                      std::int64_t greatest) const {
    const model::TomlEntry* entry = find(key);
    if (entry == nullptr) return otherwise;
    const auto* whole = std::get_if<std::int64_t>(&entry->value);
    if (whole == nullptr || *whole < least || *whole > greatest) {
      refuse(entry->line, entry->key, fmt::format("must be a whole number from {} to {}", least, greatest));
    }
    return *whole;
  }

  void take_top() {
    study_.title = text_at("title", path_.stem().string());
    take_plan();
    study_.samples = static_cast<int>(whole_at("samples", kDefaultSamples, 1, kMostSamples));
    study_.seed = static_cast<std::uint64_t>(whole_at("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
    take_base();
    take_strains();
    take_measured();
    for (const char* key : {"samples", "seed"}) {
      const model::TomlEntry* entry = find(key);
      if (entry != nullptr && !is_sampled()) {
        refuse(entry->line, key, R"(serves only a plan that takes samples, "latin-hypercube" or "sobol"; remove it)");
      }
    }
  }

  void check_number() const {
    double number = 1;
    for (const Variation& each : study_.variations)
      number *= static_cast<double>(std::max<std::size_t>(1, each.values.size()));
    if (study_.plan == Plan::grid && number > kMostSamples) {
      refuse(0, "",
             fmt::format("asks for {:.0f} cases, but at most {} are allowed; take fewer values, or plan = "
                         "\"latin-hypercube\"",
                         number, kMostSamples));
    }
  }

  void take_plan() {
    static const std::vector<std::string_view> kPlans = {"grid", "one-at-a-time", "latin-hypercube", "sobol"};
    const std::string word = text_at("plan", "grid");
    const auto found = std::ranges::find(kPlans, std::string_view(word));
    if (found == kPlans.end()) {
      refuse(find("plan")->line, "plan",
             fmt::format("is {}, but must be {}", base::in_quotes(word), base::alternatives(kPlans)));
    }
    study_.plan = static_cast<Plan>(found - kPlans.begin());
  }

  void take_base() {
    const std::string base = text_at("base", "");
    if (base.empty()) refuse(0, "base", "is missing; write for example base = \"case.toml\", the case that is varied");
    study_.base = model::read_case_file(path_.parent_path() / base);
  }

  [[nodiscard]] std::vector<model::TomlItem> list_at(std::string_view key) const {
    const model::TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    const auto* list = std::get_if<std::vector<model::TomlItem>>(&entry->value);
    if (list == nullptr || list->empty()) refuse(entry->line, entry->key, "must be a list with at least one entry");
    return *list;
  }

  void take_strains() {
    study_.strains = study_.base.output.frames_at;
    const std::vector<model::TomlItem> given = list_at("strains");
    if (given.empty()) return;
    study_.strains.clear();
    for (const model::TomlItem& item : given) {
      const auto* whole = std::get_if<std::int64_t>(&item);
      const auto* number = std::get_if<double>(&item);
      const double strain = whole != nullptr ? static_cast<double>(*whole) : number != nullptr ? *number : -1;
      const double before = study_.strains.empty() ? 0 : study_.strains.back();
      if (!(strain > before) || !std::isfinite(strain)) {
        refuse(find("strains")->line, "strains", "must be ascending numbers above 0, for example [0.08, 0.16]");
      }
      study_.strains.push_back(strain);
    }
  }

  /// The texts at a key of [measured]: one, or a list of them.
  [[nodiscard]] std::vector<std::string> texts_at(const std::string& key) const {
    const model::TomlEntry* entry = find(key);
    if (entry == nullptr) return {};
    if (const auto* text = std::get_if<std::string>(&entry->value)) return {*text};
    std::vector<std::string> texts;
    for (const model::TomlItem& item : list_at(key)) {
      const auto* text = std::get_if<std::string>(&item);
      if (text == nullptr) refuse(entry->line, key, "must be texts in quotes");
      texts.push_back(*text);
    }
    return texts;
  }

  [[nodiscard]] std::optional<double> length_at(const std::string& key) const {
    const model::TomlEntry* entry = find(key);
    if (entry == nullptr) return std::nullopt;
    try {
      const double length = base::parse_quantity(text_at(key, ""), base::Dimension::length);
      if (length > 0) return length;
    } catch (const InputError& error) {
      refuse(entry->line, key, error.what());
    }
    refuse(entry->line, key, "must be more than 0 mm");
  }

  void take_measured() {
    if (find("measured") == nullptr) return;
    for (const model::TomlEntry& entry : entries_) (void)takes_measured_entry(entry);
    Measured measured;
    for (const std::string& name : texts_at("measured.files")) {
      const fs::path file = path_.parent_path() / name;
      if (!fs::is_regular_file(file)) {
        refuse(find("measured.files")->line, "measured.files",
               fmt::format("there is no file {}", base::in_quotes(file.string())));
      }
      measured.files.push_back(file.string());
    }
    if (measured.files.empty()) {
      refuse(find("measured")->line, "measured.files", "is missing; write for example files = [\"measured.csv\"]");
    }
    measured.gauge_length = length_at("measured.gauge_length");
    measured.width = length_at("measured.width");
    measured.load_column = text_at("measured.load_column", "");
    measured.extension_column = text_at("measured.extension_column", "");
    measured.samples = texts_at("measured.samples");
    take_offset(measured);
    study_.measured = std::move(measured);
  }

  void take_offset(Measured& measured) const {
    const model::TomlEntry* entry = find("measured.offset");
    if (entry == nullptr) return;
    const auto* word = std::get_if<std::string>(&entry->value);
    const auto* number = std::get_if<double>(&entry->value);
    measured.finds_offset = word != nullptr && *word == "auto";
    if (measured.finds_offset) return;
    if (number == nullptr || !std::isfinite(*number)) {
      refuse(entry->line, entry->key, "must be a strain such as 0.02, or \"auto\"");
    }
    measured.offset = *number;
  }

  [[nodiscard]] bool takes_measured_entry(const model::TomlEntry& entry) const {
    static const std::vector<std::string_view> kNames = {"files",   "gauge_length",     "width", "load_column",
                                                         "samples", "extension_column", "offset"};
    constexpr std::string_view kSection = "measured.";
    if (!entry.key.starts_with(kSection)) return false;
    const std::string name = entry.key.substr(kSection.size());
    if (std::ranges::find(kNames, std::string_view(name)) == kNames.end()) {
      refuse(entry.line, entry.key,
             fmt::format("there is no such key; the keys of [measured] are {}", base::alternatives(kNames)));
    }
    return true;
  }

  /// Keeps an entry of a section [loop.height], and refuses all others that are not known.
  void take_section_entry(const model::TomlEntry& entry) {
    static const std::vector<std::string_view> kTop = {"title", "base", "plan", "samples", "seed", "strains"};
    if (takes_measured_entry(entry)) return;
    const auto n_dots = std::ranges::count(entry.key, '.');
    const bool is_section = std::holds_alternative<model::TomlSection>(entry.value);
    if (n_dots == 0) {
      if (is_section || std::ranges::find(kTop, std::string_view(entry.key)) != kTop.end()) return;
      const auto nearest = base::nearest_word(entry.key, kTop);
      refuse(entry.line, base::in_quotes(entry.key),
             "there is no such key; " + (nearest.empty() ? "the keys are " + base::alternatives(kTop)
                                                         : fmt::format("did you mean {}?", nearest)));
    }
    if (n_dots == 1) {
      if (!is_section) {
        refuse(entry.line, entry.key,
               fmt::format("is a value; write [{}] and below it values = [...] to vary it", entry.key));
      }
      order_.push_back(entry.key);
      sections_[entry.key].line = entry.line;
      return;
    }
    const auto dot = entry.key.rfind('.');
    sections_.at(entry.key.substr(0, dot)).entries.emplace(entry.key.substr(dot + 1), entry);
  }

  [[nodiscard]] const model::Parameter& parameter_of(const std::string& key, int line) const {
    const model::Parameter* parameter = model::find_parameter(key);
    if (parameter == nullptr) {
      std::vector<std::string_view> keys;
      for (const model::Parameter& each : model::parameters()) keys.emplace_back(each.key);
      const auto nearest = base::nearest_word(key, keys);
      refuse(
          line, "",
          fmt::format("there is no parameter {}; {}", key,
                      nearest.empty() ? "`knitmech parameters` lists them" : fmt::format("did you mean {}?", nearest)));
    }
    if (kind_of(*parameter) == model::Kind::list_of_quantities || kind_of(*parameter) == model::Kind::text) {
      refuse(line, key, "cannot be varied, only a number or a choice can");
    }
    return *parameter;
  }

  [[nodiscard]] Variation variation_from(const std::string& key, const Given& given) const {
    static const std::vector<std::string_view> kNames = {"values", "from", "to", "steps", "spacing"};
    Variation variation;
    variation.parameter = &parameter_of(key, given.line);
    for (const auto& [name, entry] : given.entries) {
      if (std::ranges::find(kNames, std::string_view(name)) == kNames.end()) {
        refuse(entry.line, "",
               fmt::format("there is no key {} here; the keys of [{}] are {}", base::in_quotes(name), key,
                           base::alternatives(kNames)));
      }
    }
    const model::TomlEntry* values = given.find("values");
    if (values != nullptr && given.entries.size() > 1) {
      refuse(values->line, key, "has both values and a range; remove one of the two");
    }
    if (values != nullptr && is_sampled()) {
      refuse(values->line, key, "has a list of values, but the plan takes samples of a range; write from and to");
    }
    if (values == nullptr) {
      take_range(variation, given);
    } else {
      take_values(variation, *values);
    }
    return variation;
  }

  [[nodiscard]] model::Value value_from(const model::Parameter& parameter, const model::TomlValue& value,
                                        int line) const {
    try {
      return model::unchecked_value_from(parameter, value);
    } catch (const InputError& error) {
      refuse(line, parameter.key, error.what());
    }
  }

  void take_values(Variation& variation, const model::TomlEntry& entry) const {
    const auto* list = std::get_if<std::vector<model::TomlItem>>(&entry.value);
    if (list == nullptr || list->empty()) refuse(entry.line, entry.key, "must be a list with at least one entry");
    for (const model::TomlItem& item : *list) {
      const model::TomlValue value = std::visit([](const auto& each) -> model::TomlValue { return each; }, item);
      variation.values.push_back(value_from(*variation.parameter, value, entry.line));
    }
  }

  /// One end of a range, as a number in internal units.
  [[nodiscard]] double end_of_range(const model::Parameter& parameter, const Given& given, const char* name) const {
    const model::TomlEntry* entry = given.find(name);
    if (entry == nullptr) {
      refuse(given.line, parameter.key, fmt::format("has no {}; write from and to, or a list of values", name));
    }
    const model::Value value = value_from(parameter, entry->value, entry->line);
    if (const auto* whole = std::get_if<int>(&value)) return *whole;
    if (const auto* number = std::get_if<double>(&value)) return *number;
    refuse(entry->line, parameter.key, "has no range; give a list of values");
  }

  void take_range(Variation& variation, const Given& given) const {
    const model::Parameter& parameter = *variation.parameter;
    variation.from = end_of_range(parameter, given, "from");
    variation.to = end_of_range(parameter, given, "to");
    if (!(variation.from < variation.to)) refuse(given.line, parameter.key, "must have from below to");
    take_spacing(variation, given);
    const model::TomlEntry* steps = given.find("steps");
    if (is_sampled()) {
      if (steps != nullptr) refuse(steps->line, parameter.key, "has steps, but the plan takes samples; remove them");
      return;
    }
    const auto* whole = steps == nullptr ? nullptr : std::get_if<std::int64_t>(&steps->value);
    if (whole == nullptr || *whole < 2 || *whole > kMostSamples) {
      refuse(steps == nullptr ? given.line : steps->line, parameter.key,
             fmt::format("needs steps, the number of values in the range: a whole number from 2 to {}", kMostSamples));
    }
    for (std::int64_t i = 0; i < *whole; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(*whole - 1);
      variation.values.push_back(value_in_range(variation, share));
    }
  }

  void take_spacing(Variation& variation, const Given& given) const {
    const model::TomlEntry* spacing = given.find("spacing");
    if (spacing == nullptr) return;
    const auto* word = std::get_if<std::string>(&spacing->value);
    if (word == nullptr || (*word != "linear" && *word != "logarithmic")) {
      refuse(spacing->line, variation.parameter->key, R"(must have spacing "linear" or "logarithmic")");
    }
    variation.logarithmic = *word == "logarithmic";
    if (variation.logarithmic && !(variation.from > 0)) {
      refuse(spacing->line, variation.parameter->key, "must begin above 0 to be spaced logarithmically");
    }
  }

  fs::path path_;
  Study study_;
  std::vector<model::TomlEntry> entries_;
  std::vector<std::string> order_;  ///< keys of the sections
  std::map<std::string, Given, std::less<>> sections_;
};

}  // namespace

Study parse_study(std::string_view text, const fs::path& path) {
  return Reader(text, path).read();
}

Study read_study_file(const fs::path& path) {
  return parse_study(model::case_file_text(path), path);
}

}  // namespace knitmech::study
