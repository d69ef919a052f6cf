#include "picture/yarn_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "picture/colour_bar.h"
#include "picture/ticks.h"
#include "results/node_values.h"

namespace knitmech::picture {
namespace {

std::vector<double> magnitudes(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> values;
  values.reserve(vectors.size());
  for (const Eigen::Vector3d& vector : vectors) {
    values.push_back(vector.norm());
  }
  return values;
}

std::vector<double> z_of(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    values.push_back(point.z());
  }
  return values;
}

bool is_magnitude(ColourBy colour_by) {
  return colour_by == ColourBy::contact_force || colour_by == ColourBy::curvature ||
         colour_by == ColourBy::shear_force || colour_by == ColourBy::bending_moment;
}

std::vector<double> in_percent(std::vector<double> values) {
  for (double& value : values) value *= 100;
  return values;
}

/// Values of a field; empty for plain and course.
std::vector<double> field_values(ColourBy colour_by, const model::Model& model, const model::Frame& frame) {
  const auto at_nodes = [&](const std::vector<double>& element_values) {
    return results::average_to_nodes(model, frame.broken, element_values);
  };
  switch (colour_by) {
    case ColourBy::plain:
    case ColourBy::course:
      break;
    case ColourBy::contact_force:
      return magnitudes(frame.contact_force);
    case ColourBy::curvature:
      return at_nodes(frame.curvature);
    case ColourBy::axial_force:
      return at_nodes(frame.axial_force);
    case ColourBy::axial_strain:
      return in_percent(at_nodes(frame.axial_strain));
    case ColourBy::shear_force:
      return at_nodes(frame.shear_force);
    case ColourBy::bending_moment:
      return at_nodes(frame.bending_moment);
    case ColourBy::torque:
      return at_nodes(frame.torque);
    case ColourBy::out_of_plane:
      return z_of(frame.points);
  }
  return {};
}

}  // namespace

FieldName field_name(ColourBy colour_by) {
  switch (colour_by) {
    case ColourBy::plain:
    case ColourBy::course:
      break;
    case ColourBy::contact_force:
      return {"Contact force", "N"};
    case ColourBy::curvature:
      return {"Curvature change", "1/mm"};
    case ColourBy::axial_force:
      return {"Axial force", "N"};
    case ColourBy::axial_strain:
      return {"Axial strain", "%"};
    case ColourBy::shear_force:
      return {"Shear force", "N"};
    case ColourBy::bending_moment:
      return {"Bending moment", "N mm"};
    case ColourBy::torque:
      return {"Torque", "N mm"};
    case ColourBy::out_of_plane:
      return {"Out of plane", "mm"};
  }
  return {"", ""};
}

void ValueRange::include(const YarnField& field) {
  for (const double value : field.values) {
    if (!std::isfinite(value)) continue;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
}

std::pair<double, double> round_range(ColourBy colour_by, const ValueRange& values) {
  const bool from_zero = is_magnitude(colour_by);
  const double lowest = from_zero ? 0 : values.lowest;
  const double highest = from_zero && values.highest <= 0 ? 1 : values.highest;
  const Ticks ticks = nice_ticks(lowest, highest, kColourBarIntervals);
  return {ticks.first(), ticks.last()};
}

std::optional<YarnField> yarn_field(ColourBy colour_by, const model::Model& model, const model::Frame& frame,
                                    const std::optional<std::pair<double, double>>& range) {
  if (colour_by == ColourBy::plain || colour_by == ColourBy::course) return std::nullopt;
  const FieldName name = field_name(colour_by);
  YarnField field{fmt::format("{} [{}]", name.name, name.unit), field_values(colour_by, model, frame)};
  ValueRange values;
  values.include(field);
  std::tie(field.lowest, field.highest) = range ? *range : round_range(colour_by, values);
  return field;
}

}  // namespace knitmech::picture
