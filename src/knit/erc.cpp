#include "knit/erc.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "knit/check_loop.h"
#include "knit/constants.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The flat path at one plan length: place, direction and signed curvature (counter-clockwise positive).
struct PlanPoint {
  Vector2d position;
  Vector2d direction;
  double curvature;
};

/// Gauss-Legendre rule with ten points on [-1, 1] (Abramowitz and Stegun, table 25.4); the rule is symmetric.
constexpr std::array<double, 5> kGaussPoint = {0.1488743389816312108848260, 0.4333953941292471907992659,
                                               0.6794095682990244062343274, 0.8650633666889845107320967,
                                               0.9739065285171717200779640};
constexpr std::array<double, 5> kGaussWeight = {0.2955242247147528701738930, 0.2692667193099963550912269,
                                                0.2190863625159820439955349, 0.1494513491505805931457763,
                                                0.0666713443086881375935688};

/// Each piece is integrated in this many parts, so that the rule is exact to rounding for deep loops as well.
constexpr int kPartsPerPiece = 8;

Vector2d unit_vector(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The piece in which a plan length lies; where pieces meet, the later one.
std::size_t piece_index(const Erc& erc, double plan_length) {
  const auto& starts = erc.plan_start;
  std::size_t piece = 0;
  while (piece + 1 < kErcPieces && starts[piece + 1] <= plan_length) ++piece;
  return piece;
}

PlanPoint on_arc(const Vector2d& middle, double radius, double start_angle, double turn, double length) {
  const double angle = start_angle + turn * length / radius;
  const Vector2d outwards = unit_vector(angle);
  return {middle + radius * outwards, turn * Vector2d(-outwards.y(), outwards.x()), turn / radius};
}

PlanPoint plan_point(const Erc& erc, double plan_length) {
  const auto& point = erc.control_points;
  const std::size_t piece = piece_index(erc, plan_length);
  const double length = plan_length - erc.plan_start[piece];
  constexpr double up = std::numbers::pi / 2;
  switch (static_cast<ErcPiece>(piece)) {
    case ErcPiece::head_flat:
      return {point[0] + length * Vector2d::UnitX(), Vector2d::UnitX(), 0};
    case ErcPiece::head_arc:
      return on_arc(point[6], erc.shape.head_radius, up, -1, length);
    case ErcPiece::leg: {
      const Vector2d direction = unit_vector(-erc.theta1);
      return {point[2] + length * direction, direction, 0};
    }
    case ErcPiece::foot_arc:
      return on_arc(point[7], erc.shape.foot_radius, -up - erc.foot_sweep, 1, length);
    case ErcPiece::foot_flat:
      break;
  }
  return {point[4] + length * Vector2d::UnitX(), Vector2d::UnitX(), 0};
}

/// ds / dw, arc length per plan length [-].
double stretch(const Erc& erc, double plan_length) {
  const PlanPoint at = plan_point(erc, plan_length);
  return std::hypot(1.0, 2 * erc.shape.out_of_plane * at.position.y() * at.direction.y());
}

double integrate_stretch(const Erc& erc, double from, double to) {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t i = 0; i < kGaussPoint.size(); ++i) {
    const double offset = half * kGaussPoint[i];
    sum += kGaussWeight[i] * (stretch(erc, middle - offset) + stretch(erc, middle + offset));
  }
  return half * sum;
}

void fill_plan_starts(Erc& erc) {
  const LoopShape& shape = erc.shape;
  const double leg = (erc.control_points[3] - erc.control_points[2]).norm();
  const std::array<double, kErcPieces> lengths = {shape.head_flat, shape.head_radius * erc.head_sweep, leg,
                                                  shape.foot_radius * erc.foot_sweep, shape.foot_flat};
  erc.plan_start[0] = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) erc.plan_start[i + 1] = erc.plan_start[i] + lengths[i];
}

void fill_arc_table(Erc& erc) {
  erc.table_plan = {0};
  erc.table_arc = {0};
  for (std::size_t piece = 0; piece < kErcPieces; ++piece) {
    const double start = erc.plan_start[piece];
    const double length = erc.plan_start[piece + 1] - start;
    if (length <= 0) continue;
    for (int part = 1; part <= kPartsPerPiece; ++part) {
      const double end = part == kPartsPerPiece ? erc.plan_start[piece + 1] : start + length * part / kPartsPerPiece;
      erc.table_arc.push_back(erc.table_arc.back() + integrate_stretch(erc, erc.table_plan.back(), end));
      erc.table_plan.push_back(end);
    }
  }
  erc.length = erc.table_arc.back();
}

/// Index of the part of a table in which a value lies, 0 to size - 2.
std::size_t part_of(const std::vector<double>& table, double value) {
  const auto after = std::upper_bound(table.begin() + 1, table.end() - 1, value);
  return static_cast<std::size_t>(after - table.begin() - 1);
}

}  // namespace

Vector2d head_circle_middle(const LoopShape& shape) {
  return {shape.head_flat, shape.height / 2 - shape.head_radius};
}

Vector2d foot_circle_middle(const LoopShape& shape) {
  return {shape.width / 2 - shape.foot_flat, -shape.height / 2 + shape.foot_radius};
}

Vector2d leg_touch_direction(const LoopShape& shape) {
  const Vector2d d = foot_circle_middle(shape) - head_circle_middle(shape);
  return unit_vector(std::atan2(d.y(), d.x()) + std::acos((shape.head_radius + shape.foot_radius) / d.norm()));
}

Erc make_erc(const LoopShape& shape) {
  check_loop_shape(shape);
  const Vector2d head_middle = head_circle_middle(shape);
  const Vector2d foot_middle = foot_circle_middle(shape);
  const Vector2d touch = leg_touch_direction(shape);

  Erc erc;
  erc.shape = shape;
  erc.control_points = {Vector2d(0, shape.height / 2),
                        Vector2d(shape.head_flat, shape.height / 2),
                        head_middle + shape.head_radius * touch,
                        foot_middle - shape.foot_radius * touch,
                        Vector2d(foot_middle.x(), -shape.height / 2),
                        Vector2d(shape.width / 2, -shape.height / 2),
                        head_middle,
                        foot_middle};
  const double sweep = std::numbers::pi / 2 - std::atan2(touch.y(), touch.x());
  erc.theta1 = sweep;
  erc.theta2 = sweep;
  erc.head_sweep = sweep;
  erc.foot_sweep = sweep;
  fill_plan_starts(erc);
  fill_arc_table(erc);
  return erc;
}

CurvePoint point_at_plan_length(const Erc& erc, double plan_length) {
  const PlanPoint plan = plan_point(erc, std::clamp(plan_length, 0.0, erc.plan_start.back()));
  const double p = erc.shape.out_of_plane;
  const double y = plan.position.y();
  const Vector2d bend = plan.curvature * Vector2d(-plan.direction.y(), plan.direction.x());
  const Vector3d first(plan.direction.x(), plan.direction.y(), -2 * p * y * plan.direction.y());
  const double slope_change = plan.direction.y() * plan.direction.y() + y * bend.y();
  const Vector3d second(bend.x(), bend.y(), -2 * p * slope_change);
  const double speed = first.norm();
  return {Vector3d(plan.position.x(), y, -p * y * y), first / speed,
          first.cross(second).norm() / (speed * speed * speed)};
}

double arc_length_at(const Erc& erc, double plan_length) {
  const double plan = std::clamp(plan_length, 0.0, erc.plan_start.back());
  const std::size_t part = part_of(erc.table_plan, plan);
  return erc.table_arc[part] + integrate_stretch(erc, erc.table_plan[part], plan);
}

double plan_length_at(const Erc& erc, double arc_length) {
  const double wanted = std::clamp(arc_length, 0.0, erc.length);
  const std::size_t part = part_of(erc.table_arc, wanted);
  const double start = erc.table_plan[part];
  double low = start;
  double high = erc.table_plan[part + 1];
  double plan = low + (high - low) * (wanted - erc.table_arc[part]) / (erc.table_arc[part + 1] - erc.table_arc[part]);
  // Newton's step wherever it stays inside the bracket, bisection otherwise; 60 halvings exhaust a double.
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double error = erc.table_arc[part] + integrate_stretch(erc, start, plan) - wanted;
    if (std::abs(error) <= kArcLengthAccuracy * erc.length) break;
    (error > 0 ? high : low) = plan;
    const double next = plan - error / stretch(erc, plan);
    const double kept = next > low && next < high ? next : 0.5 * (low + high);
    if (kept == plan) break;
    plan = kept;
  }
  return plan;
}

CurvePoint point_at_arc_length(const Erc& erc, double arc_length) {
  return point_at_plan_length(erc, plan_length_at(erc, arc_length));
}

ErcPiece piece_at_arc_length(const Erc& erc, double arc_length) {
  return static_cast<ErcPiece>(piece_index(erc, plan_length_at(erc, arc_length)));
}

std::vector<CurvePoint> equal_arc_points(const Erc& erc, int n_pieces) {
  std::vector<CurvePoint> points;
  points.reserve(static_cast<std::size_t>(n_pieces) + 1);
  points.push_back(point_at_plan_length(erc, 0));
  for (int i = 1; i < n_pieces; ++i) points.push_back(point_at_arc_length(erc, erc.length * i / n_pieces));
  points.push_back(point_at_plan_length(erc, erc.plan_start.back()));
  return points;
}

}  // namespace knitmech::knit
