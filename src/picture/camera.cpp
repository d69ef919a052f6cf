#include "picture/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace knitmech::picture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kObliqueAzimuth = 38 * std::numbers::pi / 180;
constexpr double kObliqueElevation = 24 * std::numbers::pi / 180;

Vector3d towards_viewer_of(View view) {
  switch (view) {
    case View::front:
      break;
    case View::back:
      return -Vector3d::UnitZ();
    case View::side:
      return Vector3d::UnitX();
    case View::top:
      return Vector3d::UnitY();
    case View::oblique:
      return {std::sin(kObliqueAzimuth) * std::cos(kObliqueElevation), std::sin(kObliqueElevation),
              std::cos(kObliqueAzimuth) * std::cos(kObliqueElevation)};
  }
  return Vector3d::UnitZ();
}

ViewAxes axes_without_turn(View view) {
  const Vector3d towards_viewer = towards_viewer_of(view);
  const Vector3d across = view == View::top ? Vector3d(0, 0, -1) : Vector3d(0, 1, 0);
  const Vector3d right = across.cross(towards_viewer).normalized();
  return {right, towards_viewer.cross(right), towards_viewer};
}

}  // namespace

ViewAxes axes_of(View view, double turn) {
  ViewAxes axes = axes_without_turn(view);
  // Seen from the fabric, it is the viewer who goes round, the other way.
  const Eigen::AngleAxisd round(-turn * std::numbers::pi / 180, Vector3d::UnitY());
  if (turn != 0) axes = {round * axes.right, round * axes.up, round * axes.towards_viewer};
  return axes;
}

Extent extent_along(const ViewAxes& axes, const std::vector<model::CurvePiece>& pieces) {
  Eigen::Matrix3d rotation;
  rotation << axes.right.transpose(), axes.up.transpose(), axes.towards_viewer.transpose();
  Extent extent{rotation * pieces.front().start, rotation * pieces.front().start};
  for (const model::CurvePiece& piece : pieces) {
    for (const double u : {0.0, 0.5, 1.0}) {
      const Vector3d point = rotation * piece.point(u);
      extent.lowest = extent.lowest.cwiseMin((point.array() - piece.radius).matrix());
      extent.highest = extent.highest.cwiseMax((point.array() + piece.radius).matrix());
    }
  }
  return extent;
}

Extent around(const Extent& extent_a, const Extent& extent_b) {
  return {extent_a.lowest.cwiseMin(extent_b.lowest), extent_a.highest.cwiseMax(extent_b.highest)};
}

Extent part_of(const Extent& extent, const Window& window) {
  const Vector3d size = extent.size();
  Extent part = extent;
  part.lowest.head<2>() += size.head<2>().cwiseProduct(Vector2d(window.left, window.bottom));
  part.highest.head<2>() -= size.head<2>().cwiseProduct(Vector2d(1 - window.right, 1 - window.top));
  return part;
}

Camera::Camera(ViewAxes axes, const Extent& extent, const Area& area)
    : axes_(std::move(axes)),
      pixels_per_mm_(std::min(area.width / extent.size().x(), area.height / extent.size().y())),
      middle_mm_(0.5 * (extent.lowest + extent.highest).head<2>()),
      middle_px_(area.left + 0.5 * area.width, area.top + 0.5 * area.height) {}

Vector3d Camera::point_at(double column, double row, double depth) const {
  const double across = middle_mm_.x() + (column - middle_px_.x()) / pixels_per_mm_;
  const double along = middle_mm_.y() - (row - middle_px_.y()) / pixels_per_mm_;
  return across * axes_.right + along * axes_.up + depth * axes_.towards_viewer;
}

Vector2d Camera::place_of(const Vector3d& point) const {
  return {middle_px_.x() + (point.dot(axes_.right) - middle_mm_.x()) * pixels_per_mm_,
          middle_px_.y() - (point.dot(axes_.up) - middle_mm_.y()) * pixels_per_mm_};
}

}  // namespace knitmech::picture
