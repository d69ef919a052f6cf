// The contact fields of a frame.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/segment_distance.h"
#include "contact/curve_distance.h"
#include "contact/yarn_contact.h"

namespace knitmech::contact {

namespace {

/// Least distance of two pieces of centreline [mm], or any distance that is not below a limit if it is not.
double distance_below(double limit, const Curve& a, const Curve& b) {
  const Vector3 along_a = a.end - a.start;
  const Vector3 along_b = b.end - b.start;
  const ClosestPoints at = closest_points(a.start, along_a, b.start, along_b);
  const double of_chords = length(b.start + at.t * along_b - a.start - at.s * along_a);
  if (of_chords - bulge(a) - bulge(b) >= limit) return limit;
  return length(closest_on_curves(a, b, at.s, at.t).between);
}

Eigen::Vector3d to_eigen(Vector3 v) {
  return {v.x, v.y, v.z};
}

struct PlaceOnLine {
  Vector3 position, direction;  ///< [mm], unit vector
};

PlaceOnLine on_line(const Centreline& line, YarnPlace place) {
  const auto element = static_cast<std::size_t>(place.element);
  if (line.is_smooth()) {
    const CurvePoint at = point_at(line.curve(element), place.share);
    return {at.position, (1 / length(at.slope)) * at.slope};
  }
  const Vector3 start = line.node_position().at(element);
  const Vector3 along = line.node_position().at(element + 1) - start;
  return {start + place.share * along, (1 / length(along)) * along};
}

model::ContactRecord record_of(const YarnElements& elements, const Centreline& line, const ContactPoint& point) {
  const PlaceOnLine first = on_line(line, point.first);
  const PlaceOnLine second = on_line(line, point.second);
  model::ContactRecord record;
  record.first_yarn = elements.yarn[static_cast<std::size_t>(point.first.element)];
  record.second_yarn = elements.yarn[static_cast<std::size_t>(point.second.element)];
  record.first_place = arc_of(elements, point.first);
  record.second_place = arc_of(elements, point.second);
  record.position = to_eigen(0.5 * (first.position + second.position));
  record.normal = to_eigen(point.normal);
  record.gap = -point.penetration;
  record.normal_force = point.load;
  record.friction_force = to_eigen(point.friction_force());
  record.elastic_slip = length(point.stick.elastic_slip);
  record.slip = point.stick.slid;
  record.slips = point.stick.slips;
  record.angle = std::acos(std::min(1.0, std::abs(dot(first.direction, second.direction))));
  return record;
}

}  // namespace

void YarnContact::set_contact_results(model::Frame& frame) const {
  const std::size_t n = frame.points.size();
  model::NodalLoads loads(n);
  frame.contacts.clear();
  for (const ContactPoint& point : points()) {
    const Vector3 on_second = point.load * point.normal + point.friction_force();
    centreline_.spread(point.second, on_second, loads);
    centreline_.spread(point.first, -1.0 * on_second, loads);
    frame.contacts.push_back(record_of(elements_, centreline_, point));
  }
  frame.contact_force.resize(n);
  for (std::size_t i = 0; i < n; ++i) frame.contact_force[i] = {loads.force.x[i], loads.force.y[i], loads.force.z[i]};

  frame.gap.assign(n, std::numeric_limits<double>::infinity());
  for (const ElementPair pair : watch_.pairs()) {
    const auto first = static_cast<std::size_t>(pieces_->element_of(pair.first));
    const auto second = static_cast<std::size_t>(pieces_->element_of(pair.second));
    const double radii = elements_.radius[first] + elements_.radius[second];
    const std::array<std::size_t, 4> nodes{first, first + 1, second, second + 1};
    double largest = 0;
    for (const std::size_t node : nodes) largest = std::max(largest, frame.gap[node] + radii);
    const double gap = distance_below(largest, centreline_.piece_curve(*pieces_, pair.first),
                                      centreline_.piece_curve(*pieces_, pair.second)) -
                       radii;
    for (const std::size_t node : nodes) frame.gap[node] = std::min(frame.gap[node], gap);
  }
}

}  // namespace knitmech::contact
