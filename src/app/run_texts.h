#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/number_text.h"
#include "model/facts.h"
#include "model/frame.h"
#include "model/run_outcome.h"
#include "results/curve_stages.h"
#include "results/quality.h"
#include "run/load_case.h"

namespace knitmech::app {

using base::duration_text;
using base::force_text;
using base::per_width_text;
using base::percent_text;

/// What `check` prints: the loop, the fabric, the mesh, the least gap, the yarn, the test.
[[nodiscard]] std::string check_text(const run::LoadedCase& loaded, const model::FabricFacts& facts,
                                     double mass_scaling);

/// What `run` prints before it begins. \param resumed_at strain of a run that goes on; empty for a new one
[[nodiscard]] std::string run_head_text(const run::LoadedCase& loaded, const model::FabricFacts& facts,
                                        double mass_scaling, int threads, const std::filesystem::path& folder,
                                        std::optional<double> resumed_at);

/// "Stages: toe to 14.4 % strain, slope 0.373 mN/mm; bending to 22 %, slope 15.4 mN/mm; ...", the slopes per width and
/// unit of strain; empty without stages.
[[nodiscard]] std::string stages_text(const results::CurveStages& stages);

/// What `run` prints of a run that has ended, as it should or not.
[[nodiscard]] std::string run_end_text(const model::Model& model, const model::RunOutcome& outcome,
                                       const model::HistoryRow& last, const results::Quality& quality,
                                       const results::CurveStages& stages);

}  // namespace knitmech::app
