#include "knit/fabric_builder.h"

#include <cstddef>
#include <vector>

#include "knit/check_fabric.h"
#include "knit/edge_ties.h"
#include "knit/join_courses.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

/// Adds node i of 0 ... N on one half of a stitch; side = -1 is the mirror image, where the yarn runs from foot to
/// head.
void add_node(YarnCurve& yarn, const FabricLayout& layout, const Erc& erc, const CurvePoint& at, int wale, int i,
              int side) {
  const int n = layout.elements_per_erc;
  const Vector3d& position = at.position;
  const auto index = static_cast<double>(yarn.points.size());
  yarn.points.emplace_back(wale * layout.loop.width + side * position.x(), position.y(), position.z());
  yarn.tangents.emplace_back(at.tangent.x(), side * at.tangent.y(), side * at.tangent.z());
  yarn.arc_length.push_back(index * erc.length / n);
  yarn.course.push_back(0);
  yarn.wale.push_back(wale);
  yarn.from_head.push_back(i * erc.length / n);
  yarn.from_foot.push_back((n - i) * erc.length / n);
  yarn.turns.push_back(0);
}

YarnCurve build_lowest_course(const FabricLayout& layout, const Erc& erc) {
  const int n = layout.elements_per_erc;
  const std::vector<CurvePoint> points = equal_arc_points(erc, n);
  YarnCurve yarn;
  const auto add = [&](int wale, int i, int side) {
    add_node(yarn, layout, erc, points[static_cast<std::size_t>(i)], wale, i, side);
  };
  add(0, n, -1);
  for (int wale = 0; wale < layout.wales; ++wale) {
    // The foot on the left is the last node of the stitch before.
    for (int i = n - 1; i > 0; --i) add(wale, i, -1);
    for (int i = 0; i <= n; ++i) add(wale, i, 1);
  }
  return yarn;
}

/// The nodes that a mesh twice as fine has between those of this one.
std::vector<Vector3d> middles_of(FabricLayout layout, const Erc& erc) {
  layout.elements_per_erc *= 2;
  const std::vector<Vector3d> fine = build_lowest_course(layout, erc).points;
  std::vector<Vector3d> middles;
  for (std::size_t i = 1; i < fine.size(); i += 2) middles.push_back(fine[i]);
  middles.push_back(fine.back());
  return middles;
}

YarnCurve raise(YarnCurve yarn, int course, double course_spacing) {
  yarn.course.assign(yarn.points.size(), course);
  for (Vector3d& point : yarn.points) point.y() += course * course_spacing;
  for (Vector3d& middle : yarn.middles) middle.y() += course * course_spacing;
  return yarn;
}

}  // namespace

Fabric build_fabric(const FabricLayout& layout) {
  check_layout(layout);
  return build_fabric(layout, make_erc(layout.loop));
}

Fabric build_fabric(const FabricLayout& layout, const Erc& erc) {
  check_layout(layout);
  Fabric fabric;
  fabric.layout = layout;
  fabric.erc_length = erc.length;
  fabric.yarns.reserve(static_cast<std::size_t>(layout.courses));
  YarnCurve lowest = build_lowest_course(layout, erc);
  lowest.middles = middles_of(layout, erc);
  for (int course = 0; course < layout.courses; ++course) {
    fabric.yarns.push_back(raise(lowest, course, layout.course_spacing));
    fabric.courses.push_back({.yarn = course, .n_nodes = static_cast<int>(lowest.points.size())});
  }
  if (layout.structure == Structure::tied) fabric.ties = edge_ties(erc, layout);
  if (layout.structure == Structure::adjusted) join_courses(fabric);
  return fabric;
}

}  // namespace knitmech::knit
