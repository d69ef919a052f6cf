#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "compare/comparison_files.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/frame.h"
#include "python/mistakes.h"
#include "python/run_watch.h"
#include "report/run_report.h"
#include "results/atomic_file.h"
#include "results/read_frame.h"
#include "results/read_run.h"
#include "results/summary.h"
#include "run/run_case.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;
using results::StoredRun;
using Shared = std::shared_ptr<StoredRun>;

std::shared_ptr<const model::Model> model_in(const Shared& run) {
  return {run, &run->model};
}

/// Reports and comparisons would be taken for those of the run that begins.
void remove_what_shows_an_earlier_run(const run::RunStart& start) {
  if (start.checkpoint || !results::is_summary(start.folder / results::kSummaryFile)) return;
  report::remove_run_report(start.folder);
  compare::remove_comparison(start.folder);
}

void run_from(run::RunStart begun, const py::object& on_frame, std::optional<int> threads, bool pictures) {
  const auto start = std::make_shared<run::RunStart>(std::move(begun));
  RunWatch watch(on_frame, {start, &start->loaded.model});
  {
    const py::gil_scoped_release unlocked;
    remove_what_shows_an_earlier_run(*start);
    const run::RunSettings settings{run::resolved_settings(start->loaded, threads), pictures};
    static_cast<void>(run::run_case(*start, settings, watch.listener()));
  }
  watch.rethrow();
}

void run_case(const std::string& text, const std::string& name, const std::string& folder, const py::object& on_frame,
              std::optional<int> threads, bool pictures) {
  run_from(run::new_run(run::load_case_text(text, name), folder), on_frame, threads, pictures);
}

void resume_run(const std::string& folder, const py::object& on_frame, std::optional<int> threads, bool pictures) {
  run_from(run::earlier_run(folder), on_frame, threads, pictures);
}

std::shared_ptr<StoredRun> read_run(const std::string& folder) {
  return std::make_shared<StoredRun>(results::read_run(folder));
}

HeldFrame read_frame(const Shared& run, int index) {
  const py::gil_scoped_release unlocked;
  return {model_in(run), std::make_shared<const model::Frame>(results::read_frame(*run, index))};
}

py::list frames_of(const StoredRun& run) {
  py::list list;
  for (const results::StoredFrame& frame : run.frames) list.append(py::make_tuple(frame.index, frame.strain));
  return list;
}

}  // namespace

void bind_run(py::module_& module) {
  using Released = py::call_guard<py::gil_scoped_release>;
  module.def("run_case", &run_case);
  module.def("resume_run", &resume_run);
  module.def("read_run", &read_run, Released());
  py::class_<StoredRun, std::shared_ptr<StoredRun>>(module, "StoredRun")
      .def_property_readonly("status", [](const StoredRun& run) { return text_of(run.summary.status); })
      .def_property_readonly("reason", [](const StoredRun& run) { return text_of(run.summary.reason); })
      .def_property_readonly("advice", [](const StoredRun& run) { return text_of(run.summary.advice); })
      .def_property_readonly(
          "summary", [](const StoredRun& run) { return text_of(results::read_file(run.dir / results::kSummaryFile)); })
      .def_property_readonly("history", [](const StoredRun& run) { return history_array(run.history); })
      .def_property_readonly("frames", &frames_of)
      .def_property_readonly("model", [](const Shared& run) { return std::shared_ptr<model::Model>(run, &run->model); })
      .def("frame", &read_frame)
      .def("nearest_frame",
           [](const Shared& run, double strain) { return read_frame(run, results::nearest_frame(*run, strain).index); })
      .def(
          "write_report", [](const StoredRun& run, int threads) { report::write_run_report(run, threads); },
          Released());
}

}  // namespace knitmech::python
