#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "serve/request_words.h"

namespace knitmech::serve {

/// A change that the page is told of: `run` with the head of a run as JSON, `gone` with its id.
struct RunEvent {
  std::string name, data;
};

/// How runs are run.
struct RunsOptions {
  int at_once = 0;       ///< so many at the same time at most; 0: as many as the computer has processors
  bool pictures = true;  ///< of the frames and of the curve, and the report
};

/// The runs in a folder: those that this program runs, each on a thread of its own, and those that are only stored
/// there. A run is named by its folder, its id. JSON and blobs are as web/src/api/types.ts tells.
///
/// All members may be called from any thread. They throw Refusal with 404 for an id that is no run, 409 for a command
/// that the state of the run does not admit, InputError and FileError like the functions that read and write runs.
class Runs {
 public:
  /// \param folder of the run folders; need not be there yet
  explicit Runs(std::filesystem::path folder, RunsOptions options = {});

  /// Interrupts what still runs, so that it can be gone on with, and waits for it. No other member may be under way.
  ~Runs();
  Runs(const Runs&) = delete;
  Runs& operator=(const Runs&) = delete;
  Runs(Runs&&) = delete;
  Runs& operator=(Runs&&) = delete;

  [[nodiscard]] std::string list_json();
  [[nodiscard]] std::string detail_json(const std::string& id);
  /// An interrupted run that goes on has one row less at first, that of the instant of the interruption.
  [[nodiscard]] std::string history_json(const std::string& id, std::size_t from);
  [[nodiscard]] std::string model_blob(const std::string& id);
  [[nodiscard]] std::string frame_blob(const std::string& id, int index);
  /// The newest state of an active run; 404 if there is none. Views are made while someone asks for them or for the
  /// detail, and whenever the run pauses; the head counts them.
  [[nodiscard]] std::string live_blob(const std::string& id);

  /// Runs a case in a new folder called name as folder_name() makes it fit, or name-2, name-3, ... if that is taken.
  /// More than run at once wait in order. Returns the id. Throws model::CaseFileError of a file "case.toml" for a
  /// mistake in the text, and leaves nothing then.
  std::string start(std::string_view case_text, std::string_view name);
  void pause(const std::string& id);
  /// Lets a paused run go on, or an interrupted one from its checkpoint.
  void resume(const std::string& id);
  /// Interrupts a run; it keeps its checkpoint. One that has not begun goes without a trace.
  void stop(const std::string& id);
  void write_report(const std::string& id);

  /// A picture of a stored frame as `knitmech render` makes it. \param words frame, colour, view, width, height
  [[nodiscard]] std::string picture_png(const std::string& id, const RequestWords& words);

  /// A file of `knitmech export` of a stored frame. \param words format, frame, ending
  [[nodiscard]] std::string geometry(const std::string& id, const RequestWords& words);

  /// The folder of a run, for its files.
  [[nodiscard]] std::filesystem::path folder_of(const std::string& id);

  /// What has changed since a call that returned `seen`, at most one event per run; waits for something to change, but
  /// not longer than is said. Sets `seen` for the next call. 0: the state now.
  [[nodiscard]] std::vector<RunEvent> wait_for_changes(std::uint64_t& seen, std::chrono::milliseconds longest);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace knitmech::serve
