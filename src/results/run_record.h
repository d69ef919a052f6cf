#pragma once

#include <optional>
#include <vector>

#include "model/frame.h"
#include "results/collection_file.h"
#include "results/contact_summary.h"
#include "results/frame_measures.h"
#include "results/section_peaks.h"

namespace knitmech::results {

/// What a run folder remembers of the run so far.
struct RunRecord {
  std::vector<model::HistoryRow> history;
  std::vector<FrameEntry> frames;
  std::vector<FrameMeasures> measures;     ///< of the same frames
  std::optional<ContactSummary> contacts;  ///< of the last frame
  SectionPeaks peaks;                      ///< of all frames

  template <class Archive>
  void serialize(Archive& archive) {
    archive(history, frames, measures, contacts, peaks);
  }
};

}  // namespace knitmech::results
