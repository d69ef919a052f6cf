#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/frame.h"
#include "model/model.h"
#include "results/run_folder.h"

namespace knitmech::run {

/// "22 % strain, 19.6 mN": the caption of the picture of an instant.
[[nodiscard]] std::string caption_of(const model::HistoryRow& row);

/// The pictures of a run, in the folder pictures/ of its run folder: frame_0000.png and so on, and force-strain.svg.
class RunPictures {
 public:
  /// Takes away the pictures of an earlier run, also if no new ones are wanted; those of frames that the folder has
  /// already stay where a run goes on.
  /// @throws FileError if the folder cannot be written
  RunPictures(results::RunFolder& folder, const model::Model& model, bool wanted);

  /// Keeps what is to be drawn of a frame; pictures take longer than many steps, so they are drawn beside the
  /// run with its checkpoints, or when the simulation is over. Of a large fabric only the latest frames are kept until
  /// then: as many as have kMostDrawnElements elements together, but at least one.
  void add_frame(const model::Frame& frame);

  /// The drawing of all frames kept so far, to be done on any thread, but not after this object or during finish().
  /// They are not kept any longer.
  [[nodiscard]] std::function<void()> take_drawing();

  /// Draws the frames that are left and the force-strain curve. A frame that cannot be drawn, because a run has failed
  /// and its yarns are scattered, is noted in the log of the run instead.
  void finish(const std::vector<model::HistoryRow>& history);

 private:
  void draw(const std::deque<model::Frame>& frames);
  void draw(const model::Frame& frame);

  results::RunFolder& run_;
  const model::Model& model_;
  bool wanted_;
  std::filesystem::path folder_;
  std::deque<model::Frame> frames_;
  int n_dropped_ = 0;
};

}  // namespace knitmech::run
