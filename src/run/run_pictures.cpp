#include "run/run_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/errors.h"
#include "base/number_text.h"
#include "picture/fabric_picture.h"
#include "picture/force_strain.h"

namespace knitmech::run {
namespace {

namespace fs = std::filesystem;

/// Elements in all pictures of a run together [-]; a picture of a million takes some five seconds and 56 MB until it is
/// drawn.
constexpr std::size_t kMostDrawnElements = 4'000'000;

constexpr const char* kCurveFile = "force-strain.svg";

std::string frame_name(int index) {
  return fmt::format("frame_{:04}.png", index);
}

/// Whether `knitmech render` gave a file of pictures/ its name: frame_0012-contact-front.png, film-turn-...webp.
/// \param n_frames whose pictures stay
bool is_outdated_rendering(const std::string& name, int n_frames) {
  if (name.starts_with("film-") && name.ends_with(".webp")) return true;
  constexpr std::string_view kStart = "frame_";
  if (!name.starts_with(kStart) || !(name.ends_with(".png") || name.ends_with(".svg"))) return false;
  int index = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + kStart.size(), end, index);
  return error == std::errc{} && stop != end && *stop == '-' && index >= n_frames;
}

void remove_older_renderings(const fs::path& folder, int n_frames) {
  if (!fs::is_directory(folder)) return;
  std::vector<fs::path> outdated;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_outdated_rendering(entry.path().filename().string(), n_frames)) outdated.push_back(entry.path());
  }
  for (const fs::path& file : outdated) fs::remove(file);
}

/// \param n_frames that the run has already
void remove_older_pictures(const fs::path& folder, int n_frames) {
  fs::remove(folder / kCurveFile);
  for (int i = n_frames; fs::remove(folder / frame_name(i)); ++i) continue;
  remove_older_renderings(folder, n_frames);
  if (fs::is_directory(folder) && fs::is_empty(folder)) fs::remove(folder);
}

}  // namespace

std::string caption_of(const model::HistoryRow& row) {
  return fmt::format("{} strain, {}", base::percent_text(row.strain), base::force_text(row.force_top));
}

RunPictures::RunPictures(results::RunFolder& folder, const model::Model& model, bool wanted)
    : run_(folder), model_(model), wanted_(wanted), folder_(folder.path() / "pictures") {
  try {
    remove_older_pictures(folder_, static_cast<int>(folder.record().frames.size()));
    if (wanted_) fs::create_directories(folder_);
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("cannot write the folder {}: {}", folder_.string(), error.code().message()));
  }
}

void RunPictures::add_frame(const model::Frame& frame) {
  if (!wanted_) return;
  model::Frame drawn;
  drawn.index = frame.index;
  drawn.history = frame.history;
  drawn.points = frame.points;
  drawn.rotations = frame.rotations;
  drawn.broken = frame.broken;
  frames_.push_back(std::move(drawn));
  if (frames_.size() > std::max<std::size_t>(1, kMostDrawnElements / model_.nodes.size())) {
    frames_.pop_front();
    ++n_dropped_;
  }
}

void RunPictures::draw(const model::Frame& frame) {
  picture::PictureOptions options;
  options.caption = caption_of(frame.history);
  try {
    picture::write_fabric_picture(folder_ / frame_name(frame.index), model_, frame, options);
  } catch (const InputError& error) {
    run_.log(fmt::format("No picture of frame {}: {}", frame.index, error.what()));
  }
}

void RunPictures::finish(const std::vector<model::HistoryRow>& history) {
  if (!wanted_) return;
  picture::write_force_strain_chart(folder_ / kCurveFile, history, model_.title);
  if (n_dropped_ > 0) {
    run_.log(fmt::format("No pictures of {} frames: the fabric is large. frames/ holds them all.", n_dropped_));
  }
  draw(frames_);
}

void RunPictures::draw(const std::deque<model::Frame>& frames) {
  for (const model::Frame& frame : frames) draw(frame);
}

std::function<void()> RunPictures::take_drawing() {
  return [this, frames = std::exchange(frames_, {})] { draw(frames); };
}

}  // namespace knitmech::run
