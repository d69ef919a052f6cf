#include "knit/join_courses.h"

#include <algorithm>
#include <limits>

#include "knit/turning_arc.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

void reverse(YarnCurve& yarn) {
  const double length = yarn.arc_length.back();
  const auto turn = [](auto& values) { std::reverse(values.begin(), values.end()); };
  turn(yarn.points);
  turn(yarn.tangents);
  for (Vector3d& tangent : yarn.tangents) tangent = -tangent;
  turn(yarn.arc_length);
  for (double& place : yarn.arc_length) place = length - place;
  turn(yarn.wale);
  turn(yarn.from_head);
  turn(yarn.from_foot);
  // Middles and turns belong to elements: the last entry is unused and stays last.
  std::reverse(yarn.middles.begin(), yarn.middles.end() - 1);
  yarn.middles.back() = yarn.points.back();
  std::reverse(yarn.turns.begin(), yarn.turns.end() - 1);
}

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void append(YarnCurve& yarn, const YarnCurve& more) {
  const double start = yarn.arc_length.empty() ? 0 : yarn.arc_length.back();
  for (const double place : more.arc_length) yarn.arc_length.push_back(start + place);
  append(yarn.points, more.points);
  append(yarn.tangents, more.tangents);
  append(yarn.middles, more.middles);
  append(yarn.course, more.course);
  append(yarn.wale, more.wale);
  append(yarn.from_head, more.from_head);
  append(yarn.from_foot, more.from_foot);
  append(yarn.turns, more.turns);
}

/// Adds the nodes between both ends of the arc that starts at the yarn's last node, towards side = 1 (right) or -1.
/// \return arc length of the arc's last element, which ends at the first node of the next course [mm]
double add_arc(YarnCurve& yarn, const TurningArc& arc, int n_elements, int side) {
  const Vector3d start = yarn.points.back();
  const double from = yarn.arc_length.back();
  const double piece = arc.length / n_elements;
  const auto place = [&](double s) {
    const Eigen::Vector2d plan = point_on(arc, s).position;
    return Vector3d(start.x() + side * plan.x(), start.y() + plan.y(), start.z());
  };
  yarn.middles.back() = place(piece / 2);
  yarn.turns.back() = 1;
  for (int i = 1; i < n_elements; ++i) {
    const Eigen::Vector2d tangent = point_on(arc, i * piece).tangent;
    yarn.points.push_back(place(i * piece));
    yarn.tangents.emplace_back(side * tangent.x(), tangent.y(), 0);
    yarn.middles.push_back(place((i + 0.5) * piece));
    yarn.arc_length.push_back(from + i * piece);
    yarn.course.push_back(yarn.course.back());
    yarn.wale.push_back(kNoWale);
    yarn.from_head.push_back(std::numeric_limits<double>::infinity());
    yarn.from_foot.push_back(std::numeric_limits<double>::infinity());
    yarn.turns.push_back(1);
  }
  return piece;
}

}  // namespace

void join_courses(Fabric& fabric) {
  const TurningArc arc = make_turning_arc(fabric.layout);
  const int n_elements = count_arc_elements(arc, fabric.erc_length, fabric.layout.elements_per_erc);
  YarnCurve joined;
  double gap = 0;  // from the last node there is to the first of the next course [mm]
  for (std::size_t c = 0; c < fabric.yarns.size(); ++c) {
    YarnCurve& course = fabric.yarns[c];
    const bool runs_left = c % 2 == 1;
    if (runs_left) reverse(course);
    fabric.courses[c] = {0, static_cast<int>(joined.points.size()), static_cast<int>(course.points.size()), runs_left};
    for (double& place : course.arc_length) place += gap;
    append(joined, course);
    if (c + 1 < fabric.yarns.size()) gap = add_arc(joined, arc, n_elements, runs_left ? -1 : 1);
  }
  fabric.yarns = {std::move(joined)};
}

}  // namespace knitmech::knit
