#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/comparison.h"
#include "model/frame.h"
#include "results/read_run.h"
#include "study/run_study.h"
#include "study/study.h"

namespace knitmech::study {

// The tables of a study's report, HTML (report::table()), and what they are made of.

[[nodiscard]] inline bool is_completed(const VariantState& state) {
  return state.standing == Standing::completed;
}

/// "elements_per_erc = 10, friction = 0.1"; "base" where nothing is varied.
[[nodiscard]] std::string title_of(const Study& study, const Variant& variant);

/// A measure of a run by its name; empty if it has none.
[[nodiscard]] std::optional<double> measure(const VariantState& state, const std::string& name);

/// The name of a measure at a strain: "work_mJ_at_22_percent".
[[nodiscard]] std::string at(const char* name, double strain);

/// All runs with their outcome, work and quality.
[[nodiscard]] std::string table_of_runs(const Study& study, const std::vector<VariantState>& states);

/// Work, force and width of the completed runs at the strains of the study, and how far each is from those of the
/// finest mesh, or else of the first run; empty if there is nothing to tell.
[[nodiscard]] std::string tables_at_strains(const Study& study, const std::vector<VariantState>& states);

/// Out-of-plane range and place of the contacts of the completed runs, at the stored frames nearest to the strains.
[[nodiscard]] std::string table_of_shapes(const Study& study, const std::vector<VariantState>& states);

/// A run, and how it compares with measured curves.
using ComparedState = std::pair<const VariantState*, compare::Comparison>;
[[nodiscard]] std::string table_of_comparisons(const Study& study, const std::vector<ComparedState>& compared);

/// The stored frames of a run nearest to the strains of the study, each once.
[[nodiscard]] std::vector<model::Frame> frames_of(const Study& study, const results::StoredRun& run);

}  // namespace knitmech::study
