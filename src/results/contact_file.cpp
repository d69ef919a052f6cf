#include "results/contact_file.h"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "model/places.h"
#include "results/vtk_xml.h"

namespace knitmech::results {
namespace {

using model::ContactRecord;
using model::Frame;
using model::Model;

int course_of(const Model& model, int yarn, double place) {
  return model.course[model::node_near(model, yarn, place)];
}

double degrees(double angle) {
  return angle * 180 / std::numbers::pi;
}

void check_yarns(const Model& model, const Frame& frame) {
  const int n_yarns = static_cast<int>(model.yarns.size());
  for (const ContactRecord& contact : frame.contacts) {
    for (const int yarn : {contact.first_yarn, contact.second_yarn}) {
      if (yarn < 0 || yarn >= n_yarns) {
        throw std::invalid_argument(
            fmt::format("Frame {} has a contact of yarn {}, but the model has {} yarns.", frame.index, yarn, n_yarns));
      }
    }
  }
}

std::string comma_separated(const Eigen::Vector3d& vector) {
  return fmt::format("{},{},{}", vector.x(), vector.y(), vector.z());
}

std::string table_line(const Model& model, const ContactRecord& contact) {
  std::string line;
  line += fmt::format("{},{},{},", contact.first_yarn, course_of(model, contact.first_yarn, contact.first_place),
                      contact.first_place);
  line += fmt::format("{},{},{},", contact.second_yarn, course_of(model, contact.second_yarn, contact.second_place),
                      contact.second_place);
  line += fmt::format("{},{},", comma_separated(contact.position), comma_separated(contact.normal));
  line += fmt::format("{},{},", contact.gap, contact.normal_force);
  line += fmt::format("{},{},", comma_separated(contact.friction_force), contact.friction_force.norm());
  line += fmt::format("{},{},", contact.slip, contact.elastic_slip);
  line += fmt::format("{},{}\n", contact.slips ? "slip" : "stick", degrees(contact.angle));
  return line;
}

/// One value per contact: value_of(contact), or the member value_of points to.
template <typename ValueOf>
auto column(const Frame& frame, ValueOf value_of) {
  std::vector<std::decay_t<std::invoke_result_t<ValueOf, const ContactRecord&>>> values;
  values.reserve(frame.contacts.size());
  for (const ContactRecord& contact : frame.contacts) {
    values.push_back(std::invoke(value_of, contact));
  }
  return values;
}

/// Where the contact is on one of its two yarns, called "first" or "second".
void add_place_arrays(const Model& model, const Frame& frame, const std::string& which, int ContactRecord::*yarn,
                      double ContactRecord::*place, const TextSink& add) {
  const auto course = [&](const ContactRecord& contact) -> std::int32_t {
    return course_of(model, contact.*yarn, contact.*place);
  };
  add(vtk_array(which + "_yarn", column(frame, yarn)));
  add(vtk_array(which + "_course", column(frame, course)));
  add(vtk_array(which + "_place_mm", column(frame, place)));
}

void add_point_arrays(const Model& model, const Frame& frame, const TextSink& add) {
  const std::vector<Eigen::Vector3d> friction = column(frame, &ContactRecord::friction_force);
  const auto slips = [](const ContactRecord& contact) -> std::int32_t { return contact.slips ? 1 : 0; };
  const auto angle = [](const ContactRecord& contact) { return degrees(contact.angle); };
  add_place_arrays(model, frame, "first", &ContactRecord::first_yarn, &ContactRecord::first_place, add);
  add_place_arrays(model, frame, "second", &ContactRecord::second_yarn, &ContactRecord::second_place, add);
  add(vtk_array("normal", column(frame, &ContactRecord::normal)));
  add(vtk_array("gap_mm", column(frame, &ContactRecord::gap)));
  add(vtk_array("normal_force_N", column(frame, &ContactRecord::normal_force)));
  add(vtk_array("friction_force_N", friction));
  add(vtk_array("friction_force_magnitude_N", magnitudes(friction)));
  add(vtk_array("slip_mm", column(frame, &ContactRecord::slip)));
  add(vtk_array("elastic_slip_mm", column(frame, &ContactRecord::elastic_slip)));
  add(vtk_array("slips", column(frame, slips)));
  add(vtk_array("crossing_angle_deg", column(frame, angle)));
}

/// A cell for each point, without which ParaView shows nothing.
VtkCells single_points(std::size_t count) {
  VtkCells cells;
  for (std::size_t i = 0; i < count; ++i) {
    cells.connectivity.push_back(static_cast<std::int64_t>(i));
    cells.ends.push_back(static_cast<std::int64_t>(i) + 1);
  }
  return cells;
}

}  // namespace

std::string contact_table_file_name(int index) {
  return fmt::format("contacts_{:04d}.csv", index);
}

std::string contact_points_file_name(int index) {
  return fmt::format("contacts_{:04d}.vtp", index);
}

void write_contact_table(const Model& model, const Frame& frame, const TextSink& add) {
  check_yarns(model, frame);
  add(std::string{kContactHeader} + "\n");
  for (const ContactRecord& contact : frame.contacts) add(table_line(model, contact));
}

void write_contact_points(const Model& model, const Frame& frame, const TextSink& add) {
  check_yarns(model, frame);
  const auto field_arrays = [&frame](const TextSink& sink) {
    sink(vtk_field_array("strain", {frame.history.strain}));
    sink(vtk_field_array("time_s", {frame.history.time}));
  };
  write_vtk_poly_data({.field_arrays = field_arrays,
                       .points = column(frame, &ContactRecord::position),
                       .point_arrays = [&](const TextSink& sink) { add_point_arrays(model, frame, sink); },
                       .verts = single_points(frame.contacts.size()),
                       .lines = {},
                       .cell_arrays = {}},
                      add);
}

std::string contact_table_text(const Model& model, const Frame& frame) {
  std::string text;
  write_contact_table(model, frame, [&text](std::string_view piece) { text += piece; });
  return text;
}

std::string contact_points_text(const Model& model, const Frame& frame) {
  std::string text;
  write_contact_points(model, frame, [&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace knitmech::results
