#include "results/read_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "base/errors.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "results/atomic_file.h"
#include "results/frame_file.h"
#include "results/history_file.h"
#include "results/run_folder.h"
#include "results/summary.h"
#include "results/vtk_reader.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;

void check_is_run_folder(const fs::path& dir) {
  if (!fs::exists(dir)) throw InputError(fmt::format("There is no folder {}.", dir.string()));
  if (!fs::is_directory(dir)) {
    throw InputError(fmt::format("{} is a file; give the folder of a run.", dir.string()));
  }
  if (!fs::exists(dir / kSummaryFile)) {
    throw InputError(fmt::format("{} is not the folder of a run: it has no {}.", dir.string(), kSummaryFile));
  }
}

template <typename Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size() ? std::optional{value} : std::nullopt;
}

/// A frame from its line <DataSet timestep="0.022" ... file="frame_0001.vtp"/>.
std::optional<FrameEntry> frame_entry(std::string_view tag) {
  const std::optional<double> strain = number<double>(xml_attribute(tag, "timestep"));
  std::string_view digits = xml_attribute(tag, "file");
  const std::string_view name = digits;
  digits.remove_prefix(std::min(digits.find('_') + 1, digits.size()));
  digits = digits.substr(0, digits.find('.'));
  const std::optional<int> index = number<int>(digits);
  if (!strain || !std::isfinite(*strain) || !index || *index < 0 || frame_file_name(*index) != name) {
    return std::nullopt;
  }
  return FrameEntry{*index, *strain};
}

/// Reads what collection_text() wrote.
std::vector<FrameEntry> read_frames_collection(const fs::path& path) {
  const std::string content = read_file(path);
  std::string_view text = content;
  const auto fail = [&path] {
    return InputError(fmt::format("{} is damaged, or not the list of frames that KnitMech wrote.", path.string()));
  };
  if (text.find("<VTKFile type=\"Collection\"") == std::string_view::npos || !text.ends_with("</VTKFile>\n")) {
    throw fail();
  }
  std::vector<FrameEntry> entries;
  constexpr std::string_view kStart = "<DataSet ";
  for (std::size_t at = text.find(kStart); at != std::string_view::npos; at = text.find(kStart)) {
    text.remove_prefix(at);
    const std::optional<FrameEntry> entry = frame_entry(text.substr(0, text.find('>')));
    if (!entry || (!entries.empty() && entry->index <= entries.back().index)) throw fail();
    entries.push_back(*entry);
    text.remove_prefix(kStart.size());
  }
  return entries;
}

void check_has_frames(const StoredRun& run) {
  if (!run.frames.empty()) return;
  const char* const advice = run.summary.status == "running" ? "it is under way, or was killed before its first frame"
                                                             : "it ended before its first frame";
  throw InputError(fmt::format("The run in {} has stored no frame: {}.", run.dir.string(), advice));
}

model::Model model_of(const model::Case& input, const fs::path& file) {
  try {
    return model::build_model(input);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void check_is_same_model(const StoredRun& run) {
  if (run.model.n_nodes() == run.summary.model.nodes &&
      static_cast<int>(run.model.yarns.size()) == run.summary.model.yarns) {
    return;
  }
  throw InputError(fmt::format(
      "{} makes a model of {} nodes, but the run had {}: the case was changed since, or the run is of "
      "another version of KnitMech ({}).",
      (run.dir / kCaseFile).string(), run.model.n_nodes(), run.summary.model.nodes, run.summary.program_version));
}

}  // namespace

StoredRun read_run(const fs::path& dir) {
  check_is_run_folder(dir);
  StoredRun run;
  run.dir = dir;
  run.summary = read_summary(dir / kSummaryFile);
  run.frames = read_frames_collection(dir / kFramesFolder / kFramesCollection);
  check_has_frames(run);
  run.history = read_history(dir / kHistoryFile);
  run.input = model::read_case_file(dir / kCaseFile);
  run.model = model_of(run.input, dir / kCaseFile);
  check_is_same_model(run);
  return run;
}

const FrameEntry& nearest_frame(const StoredRun& run, double strain) {
  return *std::min_element(run.frames.begin(), run.frames.end(), [strain](const FrameEntry& a, const FrameEntry& b) {
    return std::abs(a.strain - strain) < std::abs(b.strain - strain);
  });
}

}  // namespace knitmech::results
