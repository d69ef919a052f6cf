#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <memory>

#include "python/frame.h"
#include "run/run_case.h"

namespace knitmech::python {

/// Listens to a run for Python: gives each frame to a callback, and ends the run where that returns False or raises, or
/// where the user presses Ctrl-C. The run goes on without the lock of the interpreter, which is taken for that only.
class RunWatch {
 public:
  /// \param on_frame what Python calls with each frame, or None \param model that is run
  RunWatch(pybind11::object on_frame, std::shared_ptr<const model::Model> model)
      : on_frame_(std::move(on_frame)), model_(std::move(model)) {}

  /// What the run is to call, as long as this object lives.
  [[nodiscard]] run::RunListener listener();

  /// Throws what has ended the run, if an exception has.
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void take_frame(const model::Frame& frame);
  bool keeps_going();
  void stop_with(std::exception_ptr error);

  pybind11::object on_frame_;
  std::shared_ptr<const model::Model> model_;
  std::chrono::steady_clock::time_point next_look_ = std::chrono::steady_clock::now();
  bool stopped_ = false;
  std::exception_ptr error_;
};

}  // namespace knitmech::python
