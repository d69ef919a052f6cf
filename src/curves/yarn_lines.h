#pragma once

#include <Eigen/Core>
#include <vector>

namespace knitmech::curves {

/// One yarn of a file: a row of points, in the order of the yarn.
struct YarnLine {
  std::vector<Eigen::Vector3d> points;  ///< [length of the file]; a closed yarn does not repeat its first point
  bool closed = false;                  ///< the yarn goes on from its last point to its first
  double radius = 0;                    ///< [length of the file]; 0: the file does not say
};

/// How the centreline of a yarn follows from its points; every tool has its own way.
enum class LineKind {
  through_points,  ///< smooth through all points: the natural cubic spline over the lengths of the chords
  inner_points,    ///< uniform Catmull-Rom from the second to the last but one; the outer two only shape the ends
  midpoints        ///< quadratic arcs from middle to middle of the chords, a point the corner of each; straight at ends
};

/// The yarns of a file.
struct YarnLines {
  LineKind kind = LineKind::through_points;
  std::vector<YarnLine> yarns;
  bool in_millimetres =
      false;  ///< the file says its unit, and lengths are in mm here; otherwise they are as in the file
};

}  // namespace knitmech::curves
