#include "contact/strips.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/cell_law.h"
#include "contact/constants.h"

namespace knitmech::contact {

namespace {

/// Share of the curvature of a parabola by which it may rise above the highest of its three values at most.
constexpr double kRiseBetweenPoints = 1.0 / 16;

/// Greatest depth that is computed with, as a share of that at which the centrelines meet: finite numbers for a run
/// that has gone wrong, so that it can say so.
constexpr double kDeepest = 0.999999;

/// What the cells of a strip come to, per k w.
struct StripSum {
  double energy = 0, tangent = 0;
  double weight = 0;             ///< sum of the forces' sizes
  Vector3 force{};               ///< on the other yarn
  Vector3 velocity{};            ///< of the other yarn's points, times their weights
  double greatest_depth = -1e9;  ///< at a point [mm]
  std::size_t nearest = 0;       ///< point with that depth
};

double depth_of(Vector3 between, double radii) {
  return std::min(0.5 * (radii - dot(between, between) / radii), 0.5 * kDeepest * radii);
}

double motion_of_cells(const FollowedContacts& contacts, const Strip& strip, const Motion& motion) {
  double most = 0;
  for (std::size_t s = strip.first_span; s < strip.first_span + strip.n_spans; ++s) {
    most = std::max(most,
                    motion.of(static_cast<std::size_t>(contacts.points.place(contacts.spans[s].first_point).element)));
  }
  return most;
}

/// Force of a point on the other yarn, kept until the friction is known.
struct PointForce {
  std::size_t point;
  double weight;
};

/// Sums up the cells of a strip. \param pressed the points that press, appended
StripSum sum_cells(const FollowedContacts& contacts, const Strip& strip, double radii,
                   std::vector<PointForce>& pressed) {
  const PlacedPoints& points = contacts.points;
  const Vector3 here = points.position(strip.point);
  StripSum sum;
  const auto look_at = [&](std::size_t point) {
    const double depth = depth_of(points.position(point) - here, radii);
    if (depth > sum.greatest_depth) {
      sum.greatest_depth = depth;
      sum.nearest = point;
    }
    return depth;
  };
  const auto press = [&](std::size_t point, double weight) {
    sum.weight += weight;
    sum.force = sum.force + (weight / radii) * (points.position(point) - here);
    sum.velocity = sum.velocity + weight * points.velocity(point);
    pressed.push_back({point, weight});
  };
  for (std::size_t s = strip.first_span; s < strip.first_span + strip.n_spans; ++s) {
    const CellSpan& span = contacts.spans[s];
    double end = look_at(span.first_point);
    for (std::size_t c = 0; c < span.n_cells; ++c) {
      const std::size_t point = span.first_point + 2 * c;
      const double start = end;
      const double middle = look_at(point + 1);
      end = look_at(point + 2);
      const double highest = std::max({start, middle, end});
      if (highest + kRiseBetweenPoints * std::abs(2 * (start + end - 2 * middle)) <= 0) continue;
      const CellLoad cell = integrate_cell(start, middle, end, radii);
      sum.energy += span.cell_length * cell.energy;
      sum.tangent += span.cell_length * cell.tangent;
      for (std::size_t k = 0; k < 3; ++k) {
        if (cell.force[k] != 0) press(point + k, span.cell_length * cell.force[k]);
      }
    }
  }
  return sum;
}

}  // namespace

ContactStep add_strip_forces(const YarnElements& elements, const Centreline& line, const SmoothLaw& law,
                             const Motion& motion, const model::State& state, double step, FollowedContacts& contacts,
                             model::NodalLoads& loads, std::optional<LostCrossing>& lost) {
  ContactStep done;
  if (contacts.strips.empty()) return done;
  PlacedPoints& points = contacts.points;
  points.begin_step();
  std::vector<PointForce> pressed;
  for (Strip& strip : contacts.strips) {
    const auto a = static_cast<std::size_t>(strip.at.element);
    const auto b = static_cast<std::size_t>(strip.other.element);
    const double moved = motion.of(a) + motion_of_cells(contacts, strip, motion);
    if (moved < strip.wake) continue;
    const double radii = elements.radius[a] + elements.radius[b];
    pressed.clear();
    points.bring(strip.block, line, state);
    for (std::size_t s = strip.first_span; s < strip.first_span + strip.n_spans; ++s) {
      points.bring(contacts.spans[s].block, line, state);
    }
    const StripSum sum = sum_cells(contacts, strip, radii, pressed);
    strip.other = points.place(sum.nearest);
    if (sum.weight <= 0) {
      strip.now = {};
      const double gap = std::sqrt(radii * radii - 2 * radii * sum.greatest_depth) - radii;
      strip.wake = moved + std::max(gap - kStripMargin * radii, 0.0);
      continue;
    }
    const double scale = density_factor() * law.stiffness / (radii * radii) * strip.length;
    const double load = scale * length(sum.force);
    const Vector3 normal = (1 / length(sum.force)) * sum.force;
    if (dot(strip.now.stick.normal, normal) < 0 && !lost) {
      lost = LostCrossing{strip.at.element, strip.other.element, line.node_position().at(a)};
    }
    const double stick = kStripStickStiffness * law.stiffness * strip.length / radii;
    const double limit = load * law.friction.between(elements.section[a], elements.section[b]);
    const Vector3 slip = step * ((1 / sum.weight) * sum.velocity - points.velocity(strip.point));
    const FrictionStep friction = friction_step(strip.now.stick, normal, slip, limit, stick);
    done.friction_loss += friction.loss;
    const Vector3 here = points.position(strip.point);
    for (const PointForce& at : pressed) {
      points.add_force(at.point, (scale * at.weight / radii) * (points.position(at.point) - here) +
                                     (at.weight / sum.weight) * friction.force);
    }
    points.add_force(strip.point, -1.0 * (scale * sum.force + friction.force));
    const double penetration = radii - std::sqrt(std::max(radii * radii - 2 * radii * sum.greatest_depth, 0.0));
    strip.now.penetration = std::max(penetration, 0.0);
    strip.now.load = load;
    strip.now.tangent = scale * sum.tangent;
    strip.now.energy = scale * sum.energy;
    strip.now.stick_stiffness = stick;
    done.largest_penetration = std::max(done.largest_penetration, strip.now.penetration);
  }
  points.give_forces(line, loads);
  return done;
}

}  // namespace knitmech::contact
