#include "picture/yarn_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// from_zero: the field is a magnitude, and zero is the natural start of its colours.
void set_range(YarnField& field, bool from_zero) {
  double lowest = from_zero ? 0 : std::numeric_limits<double>::infinity();
  double highest = from_zero ? 0 : -std::numeric_limits<double>::infinity();
  for (const double value : field.values) {
    if (std::isfinite(value)) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  if (from_zero && highest == 0) {
    highest = 1;
  }
  const Ticks ticks = nice_ticks(lowest, highest, kColourBarIntervals);
  field.lowest = ticks.first();
  field.highest = ticks.last();
}

}  // namespace

std::optional<YarnField> yarn_field(ColourBy colour_by, const model::Model& model, const model::Frame& frame,
                                    const std::optional<std::pair<double, double>>& range) {
  YarnField field;
  switch (colour_by) {
    case ColourBy::plain:
    case ColourBy::course:
      return std::nullopt;
    case ColourBy::contact_force:
      field = {"Contact force [N]", magnitudes(frame.contact_force)};
      break;
    case ColourBy::curvature:
      field = {"Curvature change [1/mm]", results::average_to_nodes(model, frame.broken, frame.curvature)};
      break;
    case ColourBy::axial_force:
      field = {"Axial force [N]", results::average_to_nodes(model, frame.broken, frame.axial_force)};
      break;
    case ColourBy::out_of_plane:
      field = {"Out of plane [mm]", z_of(frame.points)};
      break;
  }
  if (range) {
    field.lowest = range->first;
    field.highest = range->second;
  } else {
    set_range(field, colour_by == ColourBy::contact_force || colour_by == ColourBy::curvature);
  }
  return field;
}

}  // namespace knitmech::picture
