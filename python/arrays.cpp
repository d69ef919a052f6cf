#include "python/arrays.h"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "python/mistakes.h"
#include "results/csv_text.h"
#include "results/history_file.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;

static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double) && sizeof(Eigen::Vector4d) == 4 * sizeof(double),
              "vectors one after the other are an array of numbers");

using Owner = std::shared_ptr<const void>;

/// Keeps the owner alive as long as an array shows its numbers.
py::capsule keeper(const Owner& owner) {
  auto held = std::make_unique<Owner>(owner);
  py::capsule capsule(held.get(), [](void* kept) { delete static_cast<Owner*>(kept); });
  static_cast<void>(held.release());
  return capsule;
}

template <typename Number>
py::array view(const Owner& owner, const Number* numbers, std::vector<py::ssize_t> shape) {
  return frozen(py::array_t<Number>(std::move(shape), numbers, keeper(owner)));
}

template <typename Item>
py::ssize_t size_of(const std::vector<Item>& items) {
  return static_cast<py::ssize_t>(items.size());
}

template <typename Vector>
const double* numbers_of(const std::vector<Vector>& vectors) {
  return vectors.empty() ? nullptr : vectors.front().data();
}

/// [(name, "f8"), ...]: the columns of history.csv.
py::dtype history_columns() {
  py::list columns;
  for (const std::string_view name : results::csv_cells(results::kHistoryHeader)) {
    columns.append(py::make_tuple(text_of(name), "f8"));
  }
  return py::dtype::from_args(columns);
}

}  // namespace

py::array frozen(py::array array) {
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array ArraysOf::shared(const std::vector<double>& numbers) const {
  return view(owner_, numbers.data(), {size_of(numbers)});
}

py::array ArraysOf::shared(const std::vector<int>& numbers) const {
  return view(owner_, numbers.data(), {size_of(numbers)});
}

py::array ArraysOf::shared(const std::vector<Eigen::Vector3d>& vectors) const {
  return view(owner_, numbers_of(vectors), {size_of(vectors), 3});
}

py::array ArraysOf::shared(const std::vector<Eigen::Vector4d>& rotations) const {
  return view(owner_, numbers_of(rotations), {size_of(rotations), 4});
}

std::vector<int> first_nodes(const model::Model& model) {
  std::vector<int> nodes;
  nodes.reserve(static_cast<std::size_t>(model.n_elements()));
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int i = 0; i + 1 < yarn.n_nodes; ++i) nodes.push_back(yarn.first_node + i);
  }
  return nodes;
}

py::array of_elements(const model::Model& model, const std::vector<double>& values) {
  py::array_t<double> array(model.n_elements());
  double* entry = array.mutable_data();
  for (const int node : first_nodes(model)) *entry++ = values.at(static_cast<std::size_t>(node));
  return frozen(std::move(array));
}

py::array history_array(const std::vector<model::HistoryRow>& rows) {
  py::array_t<double> numbers({size_of(rows), static_cast<py::ssize_t>(results::kHistoryColumns)});
  double* next = numbers.mutable_data();
  for (const model::HistoryRow& row : rows) next = std::ranges::copy(results::history_values(row), next).out;
  return frozen(numbers.attr("view")(history_columns()).attr("reshape")(-1));
}

}  // namespace knitmech::python
