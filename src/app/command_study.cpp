#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <vector>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/study_progress.h"
#include "results/atomic_file.h"
#include "run/run_start.h"
#include "study/run_study.h"
#include "study/study_file.h"
#include "study/study_report.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;
using study::Standing;

int processors() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// As many runs at a time as there are processors, each with its share of them.
study::StudySettings settings_of(const StudyOptions& options, std::size_t n_variants) {
  study::StudySettings settings;
  settings.folder = options.folder.empty() ? run::default_folder(options.study_file) : fs::path(options.folder);
  settings.jobs = std::min(options.jobs.value_or(processors()), static_cast<int>(n_variants));
  settings.threads = options.threads;
  if (!settings.threads && settings.jobs > 1) settings.threads = std::max(1, processors() / settings.jobs);
  return settings;
}

void print_list(const study::Study& study, const std::vector<study::Variant>& variants) {
  fmt::print("{}: {} runs\n", study.title, variants.size());
  for (const study::Variant& variant : variants) {
    fmt::print("  {}", variant.name);
    for (std::size_t i = 0; i < variant.values.size(); ++i) {
      const model::Parameter& parameter = *study.variations[i].parameter;
      fmt::print("{} {} = {}", i == 0 ? ":" : ",", parameter.key, study::value_text(parameter, variant.values[i]));
    }
    fmt::print("{}\n", variant.complaint.empty() ? "" : "; impossible: " + variant.complaint);
  }
}

std::ptrdiff_t count(const std::vector<study::VariantState>& states, Standing standing) {
  return std::ranges::count(states, standing, &study::VariantState::standing);
}

std::string outcome_text(const std::vector<study::VariantState>& states) {
  std::string text = fmt::format("{} of {} runs completed", count(states, Standing::completed), states.size());
  for (const Standing standing : {Standing::failed, Standing::impossible, Standing::pending}) {
    if (const auto n = count(states, standing); n > 0) text += fmt::format(", {} {}", n, name_of(standing));
  }
  return text;
}

}  // namespace

ExitCode run_command(const StudyOptions& options) {
  const study::Study study = study::read_study_file(options.study_file);
  const std::vector<study::Variant> variants = study::variants_of(study);
  if (options.list) {
    print_list(study, variants);
    return kDone;
  }
  const study::StudySettings settings = settings_of(options, variants.size());
  const bool talks = !options.quiet && !options.json;
  if (talks) {
    fmt::print("{}: {} runs, {} at a time, into {}\n", study.title, variants.size(), settings.jobs,
               settings.folder.string());
    std::fflush(stdout);
  }
  StudyProgress progress(variants.size(), talks);
  const InterruptWatch watch;
  study::StudyListener listener;
  listener.on_change = [&](const study::VariantState& state) { progress.change(state); };
  listener.on_history = [&](const study::VariantState& state, const model::HistoryRow& row) {
    progress.update(state, row);
  };
  listener.keep_going = [] { return !InterruptWatch::requested(); };
  const std::vector<study::VariantState> states = study::run_study(study, settings, listener);
  progress.finish();
  study::write_study_report(settings.folder, study, states);

  if (talks)
    fmt::print("{}\nResults: {}\n  report.html, figures/, table.csv, study.json, runs/\n", outcome_text(states),
               settings.folder.string());
  if (options.json) fmt::print("{}", results::read_file(settings.folder / "study.json"));
  if (count(states, Standing::pending) > 0) {
    fmt::print(stderr, "knitmech: interrupted; the same command goes on with what is left\n");
  }
  return count(states, Standing::completed) == static_cast<std::ptrdiff_t>(states.size()) ? kDone : kNotFinished;
}

}  // namespace knitmech::app
