#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/model.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/mistakes.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;
using model::Model;
using Shared = std::shared_ptr<Model>;

/// A property that is an array of the model's own numbers.
template <typename Numbers>
auto member(Numbers Model::*numbers) {
  return [numbers](const Shared& model) { return ArraysOf(model).shared((*model).*numbers); };
}

py::array elements(const Shared& model) {
  py::array_t<int> array({model->n_elements(), 2});
  int* next = array.mutable_data();
  for (const int node : first_nodes(*model)) {
    *next++ = node;
    *next++ = node + 1;
  }
  return frozen(std::move(array));
}

/// The yarn of each of its nodes or, less the last one, of its elements.
py::array yarns(const Model& model, py::ssize_t size, int n_left_out) {
  py::array_t<int> array(size);
  int* next = array.mutable_data();
  for (std::size_t i = 0; i < model.yarns.size(); ++i) {
    next = std::fill_n(next, model.yarns[i].n_nodes - n_left_out, static_cast<int>(i));
  }
  return frozen(std::move(array));
}

py::array radii(const Shared& model) {
  py::array_t<double> array(model->n_elements());
  double* next = array.mutable_data();
  for (const int node : first_nodes(*model)) *next++ = model->section_of(static_cast<std::size_t>(node)).diameter / 2;
  return frozen(std::move(array));
}

py::dict node_sets(const Shared& model) {
  py::dict sets;
  for (const auto& [name, nodes] : model->node_sets) sets[text_of(name)] = ArraysOf(model).shared(nodes);
  return sets;
}

/// The rows of elements in arrays of elements, by the nodes that they start at.
std::vector<int> rows_by_node(const Model& model) {
  std::vector<int> rows(model.nodes.size(), -1);
  int row = 0;
  for (const int node : first_nodes(model)) rows[static_cast<std::size_t>(node)] = row++;
  return rows;
}

py::array tie_elements(const Shared& model) {
  const std::vector<int> rows = rows_by_node(*model);
  py::array_t<int> array({static_cast<py::ssize_t>(model->ties.size()), py::ssize_t{2}});
  int* next = array.mutable_data();
  for (const model::Tie& tie : model->ties) {
    for (const int node : {tie.first.element, tie.second.element}) *next++ = rows.at(static_cast<std::size_t>(node));
  }
  return frozen(std::move(array));
}

py::array tie_shares(const Shared& model) {
  py::array_t<double> array({static_cast<py::ssize_t>(model->ties.size()), py::ssize_t{2}});
  double* next = array.mutable_data();
  for (const model::Tie& tie : model->ties) {
    *next++ = tie.first.share;
    *next++ = tie.second.share;
  }
  return frozen(std::move(array));
}

std::string repr(const Model& model) {
  return "<knitmech.Model of " + std::to_string(model.n_nodes()) + " nodes and " + std::to_string(model.n_elements()) +
         " elements>";
}

}  // namespace

void bind_model(py::module_& module) {
  py::class_<Model, std::shared_ptr<Model>>(module, "Model",
                                            "Nodes, elements and node sets of a fabric; every array is read-only.")
      .def_property_readonly("title", [](const Model& model) { return text_of(model.title); })
      .def_property_readonly("nodes", member(&Model::nodes), "(n, 3), stress-free positions [mm]")
      .def_property_readonly("tangents", member(&Model::tangents), "(n, 3), unit tangents of the yarns")
      .def_property_readonly("arc_length", member(&Model::arc_length), "(n,), from the yarn's first node [mm]")
      .def_property_readonly("course", member(&Model::course), "(n,), counted from 0")
      .def_property_readonly("wale", member(&Model::wale), "(n,), counted from 0; -1 on a turning arc")
      .def_property_readonly(
          "yarn_of_node", [](const Shared& model) { return yarns(*model, model->n_nodes(), 0); }, "(n,)")
      .def_property_readonly("elements", &elements, "(m, 2), the two nodes of each element")
      .def_property_readonly(
          "yarn_of_element", [](const Shared& model) { return yarns(*model, model->n_elements(), 1); }, "(m,)")
      .def_property_readonly("radius", &radii, "(m,), of the yarn at each element [mm]")
      .def_property_readonly("node_sets", &node_sets, "by name; bottom_feet is held and top_heads is driven")
      .def_property_readonly("tie_elements", &tie_elements,
                             "(k, 2), the two elements that a tie joins, rows of elements")
      .def_property_readonly("tie_shares", &tie_shares, "(k, 2), where on them: share of the way from their first node")
      .def_property_readonly(
          "gauge_length", [](const Model& model) { return model.test.gauge_length; }, "[mm]")
      .def_readonly("friction", &Model::friction, "[-]")
      .def_readonly("contact_stiffness", &Model::contact_stiffness, "[N/mm], of one crossing")
      .def("__repr__", &repr);
}

}  // namespace knitmech::python
