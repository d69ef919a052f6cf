#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <numbers>
#include <utility>

#include "model/places.h"
#include "python/arrays.h"
#include "python/frame.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;

constexpr double kDegrees = 180 / std::numbers::pi;

using Numbers3 = std::array<double, 3>;

// Named as the columns of the array are.
// NOLINTBEGIN(readability-identifier-naming)
struct ContactRow {
  std::int32_t first_yarn = 0, first_course = 0, second_yarn = 0, second_course = 0;
  double first_place_mm = 0, second_place_mm = 0;
  Numbers3 position_mm{}, normal{};
  double gap_mm = 0, normal_force_N = 0;
  Numbers3 friction_force_N{};
  double slip_mm = 0, elastic_slip_mm = 0;
  bool slips = false;
  double crossing_angle_deg = 0;
};
// NOLINTEND(readability-identifier-naming)

Numbers3 numbers(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

int course_of(const model::Model& model, int yarn, double place) {
  return model.course[model::node_near(model, yarn, place)];
}

ContactRow row_of(const model::Model& model, const model::ContactRecord& contact) {
  ContactRow row;
  row.first_yarn = contact.first_yarn;
  row.first_course = course_of(model, contact.first_yarn, contact.first_place);
  row.second_yarn = contact.second_yarn;
  row.second_course = course_of(model, contact.second_yarn, contact.second_place);
  row.first_place_mm = contact.first_place;
  row.second_place_mm = contact.second_place;
  row.position_mm = numbers(contact.position);
  row.normal = numbers(contact.normal);
  row.gap_mm = contact.gap;
  row.normal_force_N = contact.normal_force;
  row.friction_force_N = numbers(contact.friction_force);
  row.slip_mm = contact.slip;
  row.elastic_slip_mm = contact.elastic_slip;
  row.slips = contact.slips;
  row.crossing_angle_deg = contact.angle * kDegrees;
  return row;
}

}  // namespace

void register_contact_columns() {
  PYBIND11_NUMPY_DTYPE(ContactRow, first_yarn, first_course, first_place_mm, second_yarn, second_course,
                       second_place_mm, position_mm, normal, gap_mm, normal_force_N, friction_force_N, slip_mm,
                       elastic_slip_mm, slips, crossing_angle_deg);
}

py::array contact_rows(const HeldFrame& held) {
  py::array_t<ContactRow> rows(static_cast<py::ssize_t>(held.frame->contacts.size()));
  ContactRow* next = rows.mutable_data();
  for (const model::ContactRecord& contact : held.frame->contacts) *next++ = row_of(*held.model, contact);
  return frozen(std::move(rows));
}

}  // namespace knitmech::python
