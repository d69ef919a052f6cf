#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/load_case.h"
#include "model/facts.h"
#include "model/frame.h"
#include "model/run_outcome.h"
#include "results/quality.h"

namespace knitmech::app {

/// "35 s", "2 min 10 s", "1 h 5 min". @param seconds [s]
[[nodiscard]] std::string duration_text(double seconds);

/// "9.6 %". @param ratio [-]
[[nodiscard]] std::string percent_text(double ratio);

/// "1.23 N", below 0.1 N "12.3 mN". @param force [N]
[[nodiscard]] std::string force_text(double force);

/// What `check` prints: the loop, the fabric, the mesh, the least gap, the yarn, the test.
[[nodiscard]] std::string check_text(const LoadedCase& loaded, const model::FabricFacts& facts, double mass_scaling);

/// What `run` prints before it begins. \param resumed_at strain of a run that goes on; empty for a new one
[[nodiscard]] std::string run_head_text(const LoadedCase& loaded, const model::FabricFacts& facts, double mass_scaling,
                                        int threads, const std::filesystem::path& folder,
                                        std::optional<double> resumed_at);

/// What `run` prints of a run that has ended, as it should or not.
[[nodiscard]] std::string run_end_text(const model::Model& model, const model::RunOutcome& outcome,
                                       const model::HistoryRow& last, const results::Quality& quality);

}  // namespace knitmech::app
