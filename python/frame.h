#pragma once

#include <pybind11/numpy.h>

#include <memory>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::python {

/// A frame with the model that it is of, as Python holds it.
struct HeldFrame {
  std::shared_ptr<const model::Model> model;
  std::shared_ptr<const model::Frame> frame;
};

/// The contacts of a frame as a structured array, a row each, with the columns of contacts_0000.csv; vectors are one
/// field of three numbers, and `slips` stands for the state.
[[nodiscard]] pybind11::array contact_rows(const HeldFrame& held);

/// Tells NumPy of the columns; once, before contact_rows().
void register_contact_columns();

}  // namespace knitmech::python
