#include "serve/frame_blob.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "picture/yarn_field.h"
#include "results/node_values.h"
#include "serve/blob.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::ordered_json;
using model::ContactRecord;
using model::Frame;
using model::Model;
using picture::ColourBy;

std::string text_of(const Json& document) {
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<float> floats(const std::vector<double>& values) {
  std::vector<float> all;
  all.reserve(values.size());
  for (const double value : values) all.push_back(static_cast<float>(value));
  return all;
}

void append(std::vector<float>& all, const Eigen::Vector3d& vector) {
  for (const double value : vector) all.push_back(static_cast<float>(value));
}

std::vector<float> floats(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<float> all;
  all.reserve(3 * vectors.size());
  for (const Eigen::Vector3d& vector : vectors) append(all, vector);
  return all;
}

/// A field that the page can show, under the name it has there. Element values, or values at the nodes.
struct ShownField {
  const char* name = "";
  ColourBy colour_by = ColourBy::plain;
  std::vector<double> Frame::*element_values = nullptr;
};

const std::array<ShownField, 8> kShownFields{{{"axial_force", ColourBy::axial_force, &Frame::axial_force},
                                              {"shear_force", ColourBy::shear_force, &Frame::shear_force},
                                              {"bending_moment", ColourBy::bending_moment, &Frame::bending_moment},
                                              {"torque", ColourBy::torque, &Frame::torque},
                                              {"axial_strain", ColourBy::axial_strain, &Frame::axial_strain},
                                              {"curvature", ColourBy::curvature, &Frame::curvature},
                                              {"contact_force", ColourBy::contact_force},
                                              {"out_of_plane", ColourBy::out_of_plane}}};

std::vector<double> node_values(ColourBy colour_by, const Frame& frame) {
  std::vector<double> values;
  values.reserve(frame.points.size());
  if (colour_by == ColourBy::contact_force) {
    for (const Eigen::Vector3d& force : frame.contact_force) values.push_back(force.norm());
  } else {
    for (const Eigen::Vector3d& point : frame.points) values.push_back(point.z());
  }
  return values;
}

/// In the unit of picture::field_name().
std::vector<double> values_of(const ShownField& field, const Frame& frame) {
  if (field.element_values == nullptr) return node_values(field.colour_by, frame);
  std::vector<double> values = frame.*field.element_values;
  if (field.colour_by == ColourBy::axial_strain) {
    for (double& value : values) value *= 100;
  }
  return values;
}

/// Adds the array of a field, and returns its head.
Json add_field(Blob& blob, const ShownField& field, const Model& model, const Frame& frame) {
  const std::vector<double> values = values_of(field, frame);
  const bool of_elements = field.element_values != nullptr;
  picture::ValueRange range;
  range.include({"", of_elements ? results::elements_only(model, values) : values});
  const bool has_range = range.lowest <= range.highest;
  const auto [lowest, highest] =
      has_range ? picture::round_range(field.colour_by, range) : std::pair{0.0, 1.0};  // all scattered
  const picture::FieldName name = picture::field_name(field.colour_by);
  blob.add(field.name, floats(values));
  return {{"name", field.name},         {"label", name.name}, {"unit", name.unit},
          {"of_elements", of_elements}, {"lowest", lowest},   {"highest", highest}};
}

template <typename Number, typename Value>
void add_contact_array(Blob& blob, const char* name, const Frame& frame, Value&& value) {
  std::vector<Number> all;
  all.reserve(frame.contacts.size());
  for (const ContactRecord& contact : frame.contacts) all.push_back(static_cast<Number>(value(contact)));
  blob.add(name, all);
}

void add_contacts(Blob& blob, const Frame& frame) {
  std::vector<float> positions, normals, places;
  std::vector<std::int32_t> yarns;
  for (const ContactRecord& contact : frame.contacts) {
    append(positions, contact.position);
    append(normals, contact.normal);
    yarns.insert(yarns.end(), {contact.first_yarn, contact.second_yarn});
    places.insert(places.end(), {static_cast<float>(contact.first_place), static_cast<float>(contact.second_place)});
  }
  blob.add("contact_positions", positions);
  blob.add("contact_normals", normals);
  add_contact_array<float>(blob, "contact_normal_force", frame,
                           [](const auto& contact) { return contact.normal_force; });
  add_contact_array<float>(blob, "contact_friction", frame,
                           [](const auto& contact) { return contact.friction_force.norm(); });
  add_contact_array<float>(blob, "contact_gap", frame, [](const auto& contact) { return contact.gap; });
  add_contact_array<float>(blob, "contact_slip", frame, [](const auto& contact) { return contact.slip; });
  add_contact_array<std::int32_t>(blob, "contact_slips", frame, [](const auto& contact) { return contact.slips; });
  blob.add("contact_yarns", yarns);
  blob.add("contact_places", places);
}

Json yarn_list(const Model& model) {
  Json list = Json::array();
  for (const model::ModelYarn& yarn : model.yarns) {
    list.push_back({{"first_node", yarn.first_node}, {"nodes", yarn.n_nodes}});
  }
  return list;
}

}  // namespace

std::string model_blob(const Model& model) {
  Blob blob;
  blob.add("positions", floats(model.nodes));
  blob.add("course", model.course);
  blob.add("wale", model.wale);
  blob.add("arc_length", floats(model.arc_length));
  const bool has_edge_yarn = model.sections.size() > 1;
  return blob.bytes(text_of({{"title", model.title},
                             {"nodes", model.n_nodes()},
                             {"yarns", yarn_list(model)},
                             {"diameter", model.sections.front().diameter},
                             {"edge_diameter", has_edge_yarn ? Json(model.sections[1].diameter) : Json(nullptr)},
                             {"gauge_length", model.test.gauge_length}}));
}

std::string frame_blob(const Model& model, const Frame& frame, int live) {
  Blob blob;
  blob.add("positions", floats(frame.points));
  Json fields = Json::array();
  for (const ShownField& field : kShownFields) fields.push_back(add_field(blob, field, model, frame));
  blob.add("broken", frame.broken);
  add_contacts(blob, frame);
  return blob.bytes(text_of({{"index", live > 0 ? Json(nullptr) : Json(frame.index)},
                             {"live", live},
                             {"strain", frame.history.strain},
                             {"force", frame.history.force_top},
                             {"fields", std::move(fields)},
                             {"contacts", frame.contacts.size()}}));
}

}  // namespace knitmech::serve
