#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "python/arrays.h"
#include "python/bindings.h"
#include "python/frame.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;
using model::Frame;

/// A property that is an array of the frame's own numbers, one entry per node.
template <typename Numbers>
auto of_nodes(Numbers Frame::*numbers) {
  return [numbers](const HeldFrame& held) { return ArraysOf(held.frame).shared((*held.frame).*numbers); };
}

/// A property that is an array with one entry per element.
auto of_elements(std::vector<double> Frame::*values) {
  return [values](const HeldFrame& held) { return python::of_elements(*held.model, (*held.frame).*values); };
}

py::object row(const HeldFrame& held) {
  return history_array({held.frame->history})[py::int_(0)];
}

py::array broken(const HeldFrame& held) {
  const std::vector<int> nodes = first_nodes(*held.model);
  py::array_t<int> rows(static_cast<py::ssize_t>(held.frame->broken.size()));
  int* next = rows.mutable_data();
  for (const int node : held.frame->broken) {
    *next++ = static_cast<int>(std::ranges::lower_bound(nodes, node) - nodes.begin());
  }
  return frozen(std::move(rows));
}

std::string repr(const HeldFrame& held) {
  return fmt::format("<knitmech.Frame {} at a strain of {:.4g}>", held.frame->index, held.frame->history.strain);
}

}  // namespace

void bind_frame(py::module_& module) {
  register_contact_columns();
  py::class_<HeldFrame>(module, "Frame", "The fabric at one instant with its fields; every array is read-only.")
      .def_property_readonly(
          "index", [](const HeldFrame& held) { return held.frame->index; }, "0, 1, 2, ...")
      .def_property_readonly(
          "strain", [](const HeldFrame& held) { return held.frame->history.strain; }, "[-]")
      .def_property_readonly(
          "time", [](const HeldFrame& held) { return held.frame->history.time; }, "[s]")
      .def_property_readonly("row", &row, "its row of the history")
      .def_property_readonly("positions", of_nodes(&Frame::points), "(n, 3), of the nodes [mm]")
      .def_property_readonly("rotations", of_nodes(&Frame::rotations),
                             "(n, 4), of the nodes since the start: unit quaternions w, x, y, z")
      .def_property_readonly("contact_force", of_nodes(&Frame::contact_force), "(n, 3), on the nodes [N]")
      .def_property_readonly("tie_force", of_nodes(&Frame::tie_force), "(n, 3), by ties on the nodes [N]")
      .def_property_readonly("gap", of_nodes(&Frame::gap),
                             "(n,), least distance to another piece of yarn [mm]; inf where none is near")
      .def_property_readonly("axial_force", of_elements(&Frame::axial_force), "(m,) [N], pull positive")
      .def_property_readonly("shear_force", of_elements(&Frame::shear_force), "(m,) [N], magnitude")
      .def_property_readonly("bending_moment", of_elements(&Frame::bending_moment), "(m,) [N mm], magnitude")
      .def_property_readonly("torque", of_elements(&Frame::torque), "(m,) [N mm]")
      .def_property_readonly("axial_strain", of_elements(&Frame::axial_strain), "(m,) [-], stretch positive")
      .def_property_readonly("curvature", of_elements(&Frame::curvature),
                             "(m,) [1/mm], magnitude of the change since the start")
      .def_property_readonly("stretch_energy", of_elements(&Frame::stretch_energy), "(m,) [mJ]")
      .def_property_readonly("bending_energy", of_elements(&Frame::bending_energy), "(m,) [mJ]")
      .def_property_readonly("twist_energy", of_elements(&Frame::twist_energy), "(m,) [mJ]")
      .def_property_readonly("broken", &broken, "(k,), broken elements, rows of Model.elements")
      .def_property_readonly("contacts", &contact_rows, "structured array, a row per contact with a force")
      .def("__repr__", &repr);
}

}  // namespace knitmech::python
