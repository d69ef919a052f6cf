#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "python/bindings.h"
#include "python/frame.h"
#include "python/mistakes.h"
#include "results/atomic_file.h"
#include "results/read_run.h"
#include "run/export_case.h"
#include "run/load_case.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;

/// Writes the files of a source in a format; gives their paths.
std::vector<std::filesystem::path> write_export(run::ExportSource source, const std::string& format_name,
                                                const std::string& file) {
  const run::ExportFormat& format = run::export_format(format_name);
  source.stem = run::export_stem(file, format);
  std::vector<std::filesystem::path> paths;
  for (const run::ExportedFile& each : run::exported(source, format)) {
    paths.push_back(run::export_path(file, format, each.ending));
    results::write_file_atomically(paths.back(), each.bytes);
  }
  return paths;
}

py::list texts_of(const std::vector<std::filesystem::path>& paths) {
  py::list list;
  for (const std::filesystem::path& path : paths) list.append(text_of(path.string()));
  return list;
}

py::list export_case(const std::string& text, const std::string& name, const std::string& format,
                     const std::string& file, int sides) {
  std::vector<std::filesystem::path> paths;
  {
    const py::gil_scoped_release unlocked;
    const run::LoadedCase loaded = run::load_case_text(text, name);
    paths = write_export({loaded.input, loaded.model, nullptr, "", sides}, format, file);
  }
  return texts_of(paths);
}

/// \param frame of the run, whose shape is written; none: as at the start
py::list export_run(const results::StoredRun& run, const HeldFrame* frame, const std::string& format,
                    const std::string& file, int sides) {
  std::vector<std::filesystem::path> paths;
  {
    const py::gil_scoped_release unlocked;
    const model::Frame* shape = frame == nullptr ? nullptr : frame->frame.get();
    paths = write_export({run.input, run.model, shape, "", sides}, format, file);
  }
  return texts_of(paths);
}

py::list formats() {
  py::list list;
  for (const run::ExportFormat& format : run::export_formats()) {
    list.append(py::make_tuple(text_of(format.name), text_of(format.label), format.kind == run::ExportKind::geometry));
  }
  return list;
}

}  // namespace

void bind_export(py::module_& module) {
  module.def("export_formats", &formats);
  module.def("export_case", &export_case);
  module.def("export_run", &export_run);
}

}  // namespace knitmech::python
