#include "python/run_watch.h"

#include <utility>

namespace knitmech::python {
namespace {

namespace py = pybind11;

/// Real time between two looks for a Ctrl-C; usual 50 ms. Each takes the lock of the interpreter, for which other
/// threads may let the run wait.
constexpr std::chrono::milliseconds kLookInterval{50};

}  // namespace

run::RunListener RunWatch::listener() {
  run::RunListener listener;
  listener.keep_going = [this] { return keeps_going(); };
  if (!on_frame_.is_none()) listener.on_frame = [this](const model::Frame& frame) { take_frame(frame); };
  return listener;
}

void RunWatch::take_frame(const model::Frame& frame) {
  if (stopped_) return;  // the last frame of a run that has been ended
  const py::gil_scoped_acquire locked;
  try {
    const py::object answer = on_frame_(HeldFrame{model_, std::make_shared<const model::Frame>(frame)});
    stopped_ = py::isinstance<py::bool_>(answer) && !py::cast<bool>(answer);
  } catch (const py::error_already_set&) {
    stop_with(std::current_exception());
  }
}

bool RunWatch::keeps_going() {
  const auto now = std::chrono::steady_clock::now();
  if (stopped_ || now < next_look_) return !stopped_;
  next_look_ = now + kLookInterval;
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) stop_with(std::make_exception_ptr(py::error_already_set()));
  return !stopped_;
}

void RunWatch::stop_with(std::exception_ptr error) {
  error_ = std::move(error);
  stopped_ = true;
}

}  // namespace knitmech::python
