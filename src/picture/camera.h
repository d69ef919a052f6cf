#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/yarn_curve.h"

namespace knitmech::picture {

/// From where the fabric is seen, always in parallel projection, so that lengths can be measured in the picture.
enum class View {
  front,   ///< along -z: the technical face, x to the right, y up
  back,    ///< along z: the technical back, x to the left, y up
  side,    ///< along -x: the front of the fabric to the left, y up
  top,     ///< along -y: x to the right, the front of the fabric below
  oblique  ///< from the front, right and above
};

/// Axes of a view, unit vectors.
struct ViewAxes {
  Eigen::Vector3d right, up, towards_viewer;
};
/// turn: by which the fabric is turned about y before [degrees], its front towards the right.
[[nodiscard]] ViewAxes axes_of(View view, double turn = 0);

/// Extent of the yarns along the axes of a view [mm], the yarn's thickness included.
struct Extent {
  Eigen::Vector3d lowest, highest;

  [[nodiscard]] Eigen::Vector3d size() const { return highest - lowest; }
};
/// pieces must not be empty.
[[nodiscard]] Extent extent_along(const ViewAxes& axes, const std::vector<model::CurvePiece>& pieces);
/// The smallest extent around two, which are along the same axes.
[[nodiscard]] Extent around(const Extent& extent_a, const Extent& extent_b);

/// A part of the fabric as seen: shares of its extent from the left and from the bottom, 0 to 1.
struct Window {
  double left = 0, right = 1, bottom = 0, top = 1;
};
/// The part of an extent that lies in a window; the depth stays.
[[nodiscard]] Extent part_of(const Extent& extent, const Window& window);

/// A rectangle of the picture [px].
struct Area {
  double left = 0, top = 0, width = 0, height = 0;
};

/// Parallel projection that fits an extent into an area of the picture, centred and at true proportions.
class Camera {
 public:
  Camera(ViewAxes axes, const Extent& extent, const Area& area);

  [[nodiscard]] const ViewAxes& axes() const { return axes_; }
  [[nodiscard]] double pixels_per_mm() const { return pixels_per_mm_; }

  /// The point [mm] seen at a place of the picture [px], at a depth along axes().towards_viewer [mm].
  [[nodiscard]] Eigen::Vector3d point_at(double column, double row, double depth) const;
  /// Place of a point in the picture [px]: column and row.
  [[nodiscard]] Eigen::Vector2d place_of(const Eigen::Vector3d& point) const;

 private:
  ViewAxes axes_;
  double pixels_per_mm_ = 1;
  Eigen::Vector2d middle_mm_;
  Eigen::Vector2d middle_px_;
};

}  // namespace knitmech::picture
