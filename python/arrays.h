#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::python {

/// Arrays for Python. All are read-only. Those of `shared` numbers are no copies: they keep the owner alive. Others
/// have numbers of their own.
class ArraysOf {
 public:
  /// \param owner of the numbers that are handed out
  explicit ArraysOf(std::shared_ptr<const void> owner) : owner_(std::move(owner)) {}

  [[nodiscard]] pybind11::array shared(const std::vector<double>& numbers) const;             ///< (n,)
  [[nodiscard]] pybind11::array shared(const std::vector<int>& numbers) const;                ///< (n,)
  [[nodiscard]] pybind11::array shared(const std::vector<Eigen::Vector3d>& vectors) const;    ///< (n, 3)
  [[nodiscard]] pybind11::array shared(const std::vector<Eigen::Vector4d>& rotations) const;  ///< (n, 4)

 private:
  std::shared_ptr<const void> owner_;
};

/// The same array, read-only.
[[nodiscard]] pybind11::array frozen(pybind11::array array);

/// The nodes at which elements start, which are all but the last of each yarn: the rows of arrays of elements.
[[nodiscard]] std::vector<int> first_nodes(const model::Model& model);

/// An array (m,) of the elements, from values that have one entry per node.
[[nodiscard]] pybind11::array of_elements(const model::Model& model, const std::vector<double>& values);

/// Rows of the history as a structured array with the columns of history.csv.
[[nodiscard]] pybind11::array history_array(const std::vector<model::HistoryRow>& rows);

}  // namespace knitmech::python
