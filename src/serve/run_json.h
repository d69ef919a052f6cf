#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/frame.h"
#include "results/collection_file.h"
#include "results/curve_stages.h"
#include "results/run_summary.h"

namespace knitmech::serve {

/// RunHead of web/src/api/types.ts.
struct RunHead {
  std::string id{}, title{};
  std::string status{};  ///< a RunStatus of types.ts
  bool active = false, can_go_on = false;
  double strain = 0, target_strain = 0;  ///< [-]
  std::size_t rows = 0, frames = 0;
  int live = 0;
  double seconds = 0;                    ///< [s]
  std::optional<double> seconds_left{};  ///< [s]
  std::string message{};
  double modified = 0;  ///< [s] since 1970
};

/// RunDetail of types.ts.
struct RunDetail {
  RunHead head;
  std::string case_text;
  std::vector<results::FrameEntry> frames;
  double width = 0, gauge_length = 0;  ///< [mm]
  int nodes = 0, elements = 0;
  std::optional<results::RunSummary> summary{};  ///< of a run that has ended
  std::vector<results::CurveStage> stages{};
  bool report = false;
  std::optional<double> mass_scaling{};
  std::optional<int> threads{};
};

[[nodiscard]] std::string head_json(const RunHead& head);
[[nodiscard]] std::string list_json(const std::vector<RunHead>& heads);
[[nodiscard]] std::string detail_json(const RunDetail& detail);

/// History of types.ts. \param rows those from the row `from` on
[[nodiscard]] std::string history_json(const std::vector<model::HistoryRow>& rows, std::size_t from);

}  // namespace knitmech::serve
