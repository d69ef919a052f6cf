#include "results/run_summary.h"

#include <fmt/core.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/summary.h"

namespace knitmech::results {
namespace {

using Json = nlohmann::json;

/// An object of the summary, with its name and its file for messages. One that is missing has no entries.
class Block {
 public:
  Block(const std::filesystem::path& path, std::string name, const Json& json)
      : path_(path), name_(std::move(name)), json_(json) {
    if (!json_.is_null() && !json_.is_object()) fail("", "an object");
  }

  [[nodiscard]] bool is_missing() const { return json_.is_null(); }

  [[nodiscard]] Block block(const char* key) const { return {path_, name_of(key), entry(key)}; }

  /// The objects of a list.
  [[nodiscard]] std::vector<Block> list(const char* key) const {
    const Json& json = entry(key);
    if (!json.is_null() && !json.is_array()) fail(key, "a list");
    std::vector<Block> blocks;
    for (const Json& one : json) blocks.emplace_back(path_, name_of(key), one);
    return blocks;
  }

  [[nodiscard]] std::optional<double> number(const char* key) const {
    const Json& json = entry(key);
    if (json.is_null()) return std::nullopt;
    if (!json.is_number()) fail(key, "a number");
    return json.get<double>();
  }

  [[nodiscard]] std::optional<long> whole(const char* key) const {
    const Json& json = entry(key);
    if (json.is_null()) return std::nullopt;
    if (!json.is_number_integer()) fail(key, "a whole number");
    return json.get<long>();
  }

  [[nodiscard]] std::optional<int> small_whole(const char* key) const {
    const std::optional<long> value = whole(key);
    if (!value) return std::nullopt;
    if (*value < 0 || *value > std::numeric_limits<int>::max()) fail(key, "a count");
    return static_cast<int>(*value);
  }

  [[nodiscard]] std::string text(const char* key) const {
    const Json& json = entry(key);
    if (json.is_null()) return "";
    if (!json.is_string()) fail(key, "a text");
    return json.get<std::string>();
  }

  [[nodiscard]] bool truth(const char* key) const {
    const Json& json = entry(key);
    if (json.is_null()) return false;
    if (!json.is_boolean()) fail(key, "true or false");
    return json.get<bool>();
  }

  [[nodiscard]] Eigen::Vector3d vector(const char* key) const {
    const Json& json = entry(key);
    if (json.is_null()) return Eigen::Vector3d::Zero();
    Eigen::Vector3d vector;
    if (!json.is_array() || json.size() != 3) fail(key, "three numbers");
    for (std::size_t i = 0; i < 3; ++i) {
      if (!json[i].is_number()) fail(key, "three numbers");
      vector[static_cast<Eigen::Index>(i)] = json[i].get<double>();
    }
    return vector;
  }

 private:
  [[nodiscard]] std::string name_of(const std::string& key) const {
    return name_.empty() || key.empty() ? name_ + key : name_ + "." + key;
  }

  [[nodiscard]] const Json& entry(const char* key) const {
    static const Json kMissing;
    const auto found = json_.find(key);
    return found == json_.end() ? kMissing : *found;
  }

  [[noreturn]] void fail(const std::string& key, const char* expected) const {
    throw InputError(fmt::format("{} is damaged: {} should be {}.", path_.string(), name_of(key), expected));
  }

  const std::filesystem::path& path_;
  std::string name_;
  const Json& json_;
};

YarnPlace place_in(const Block& block) {
  return {.yarn = block.small_whole("yarn").value_or(0),
          .course = block.small_whole("course").value_or(0),
          .wale = block.small_whole("wale"),
          .part = block.text("part"),
          .arc_length = block.number("place_mm").value_or(0)};
}

RunSummary::Model model_in(const Block& block) {
  return {.yarns = block.small_whole("yarns").value_or(0),
          .nodes = block.small_whole("nodes").value_or(0),
          .elements = block.small_whole("elements").value_or(0),
          .gauge_length = block.number("gauge_length_mm"),
          .friction = block.number("friction"),
          .contact_stiffness = block.number("contact_stiffness_N_per_mm")};
}

void read_solver(const Block& block, RunSummary& summary) {
  summary.mass_scaling = block.number("mass_scaling");
  summary.threads = block.small_whole("threads");
  summary.steps = block.whole("steps");
  summary.smallest_step = block.number("smallest_step_s");
  summary.simulated_time = block.number("simulated_time_s");
  summary.wall_seconds = block.number("wall_s");
  summary.element_steps_per_s = block.number("element_steps_per_s");
}

std::optional<ContactSummary> contacts_in(const Block& block) {
  const std::optional<int> count = block.small_whole("contacts");
  if (!count) return std::nullopt;
  return ContactSummary{.contacts = *count,
                        .normal_force = block.number("normal_force_N").value_or(0),
                        .slipping_share = block.number("slipping_share"),
                        .elastic_slip = block.number("elastic_slip_mm").value_or(0),
                        .elastic_slip_ratio = block.number("elastic_slip_ratio").value_or(0)};
}

std::optional<StoredPeak> peak_in(const Block& block) {
  if (block.is_missing()) return std::nullopt;
  return StoredPeak{.value = block.number("value").value_or(0),
                    .frame = block.small_whole("frame").value_or(0),
                    .strain = block.number("strain").value_or(0),
                    .place = place_in(block)};
}

std::optional<Quality> quality_in(const Block& block) {
  if (block.is_missing()) return std::nullopt;
  return Quality{.toe_strain = block.number("toe_strain"),
                 .kinetic_ratio = block.number("kinetic_ratio"),
                 .kinetic_ratio_strain = block.number("kinetic_ratio_strain"),
                 .energy_balance_end = block.number("energy_balance_end"),
                 .energy_balance = block.number("energy_balance"),
                 .energy_balance_strain = block.number("energy_balance_strain"),
                 .grip_difference = block.number("grip_difference"),
                 .grip_difference_strain = block.number("grip_difference_strain"),
                 .penetration = block.number("penetration_mm").value_or(0),
                 .penetration_ratio = block.number("penetration_ratio").value_or(0),
                 .elastic_slip = block.number("elastic_slip_mm").value_or(0),
                 .elastic_slip_ratio = block.number("elastic_slip_ratio").value_or(0),
                 .lost_crossings = block.small_whole("lost_crossings").value_or(0),
                 .crossing_checks = block.whole("crossing_checks").value_or(0),
                 .quasi_static = block.truth("quasi_static"),
                 .verdict = block.text("verdict")};
}

StoredRavelling ravelling_in(const Block& block) {
  return {.strain = block.number("strain").value_or(0),
          .place = {.course = block.small_whole("course").value_or(0),
                    .side = block.text("end"),
                    .other_course = block.small_whole("over_course").value_or(0),
                    .other_wale = block.small_whole("over_wale").value_or(0),
                    .yarn = block.small_whole("yarn").value_or(-1) + 1,
                    .other_yarn = block.small_whole("over_yarn").value_or(-1) + 1},
          .position = block.vector("position_mm")};
}

StoredBreak break_in(const Block& block) {
  return {.strain = block.number("strain").value_or(0),
          .axial_force = block.number("axial_force_N").value_or(0),
          .axial_strain = block.number("axial_strain").value_or(0),
          .place = place_in(block),
          .position = block.vector("position_mm")};
}

RunSummary summary_in(const Block& top) {
  RunSummary summary;
  summary.program_version = top.text("program_version");
  summary.title = top.text("title");
  summary.status = top.text("status");
  summary.reason = top.text("reason");
  summary.advice = top.text("advice");
  summary.model = model_in(top.block("model"));
  read_solver(top.block("solver"), summary);
  summary.history_rows = top.block("output").whole("history_rows");
  summary.n_frames = top.block("output").whole("frames");
  summary.strain = top.block("final").number("strain");
  const Block largest = top.block("largest");
  summary.largest_penetration = largest.number("penetration_mm");
  summary.tie_stretch = largest.number("tie_stretch_mm");
  summary.contacts = contacts_in(top.block("contact"));
  summary.quality = quality_in(top.block("quality"));
  const Block peaks = top.block("largest_in_yarns");
  for (std::size_t i = 0; i < kPeakFields.size(); ++i) {
    summary.largest_in_yarns[i] = peak_in(peaks.block(kPeakFields[i].key));
  }
  for (const Block& event : top.list("ravelled")) summary.ravelled.push_back(ravelling_in(event));
  for (const Block& event : top.list("breaks")) summary.breaks.push_back(break_in(event));
  return summary;
}

}  // namespace

RunSummary read_summary(const std::filesystem::path& path) {
  const Json document = Json::parse(read_file(path), nullptr, /*allow_exceptions=*/false);
  if (!document.is_object() || document.value("format", Json{}) != kSummaryFormat) {
    throw InputError(fmt::format("{} is not the summary of a KnitMech run, or it is damaged.", path.string()));
  }
  const Block top(path, "", document);
  if (top.whole("schema") != kSummarySchema) {
    throw InputError(fmt::format("{} was written by another version of KnitMech ({}), which this one cannot read.",
                                 path.string(), top.text("program_version")));
  }
  return summary_in(top);
}

}  // namespace knitmech::results
