#pragma once

#include <Eigen/Core>
#include <vector>

#include "knit/loop_shape.h"

namespace knitmech::knit {

/// How neighbouring courses are joined at the side edges.
enum class Structure { basic };

/// What a fabric is made of: the loop, how many of it, and how finely it is cut into elements.
struct FabricLayout {
  LoopShape loop;
  int wales = 0;              ///< W, stitches in a course
  int courses = 0;            ///< C
  double course_spacing = 0;  ///< T [mm], along y
  Structure structure = Structure::basic;
  int elements_per_erc = 0;  ///< N, of equal arc length on each half stitch
};

/// The centreline of one yarn, cut into nodes at equal arc length.
///
/// All vectors have one entry per node, in the order of the yarn (+x along a course).
struct YarnCurve {
  int course = 0;                         ///< 0 at the bottom of the fabric
  std::vector<Eigen::Vector3d> points;    ///< [mm]
  std::vector<Eigen::Vector3d> tangents;  ///< unit tangent of the true curve, not of the polyline
  std::vector<Eigen::Vector3d> middles;   ///< [mm] half the arc length on to the next node; the last: the node itself
  std::vector<double> arc_length;         ///< [mm] along the true curve from the yarn's first node
  std::vector<int> wale;                  ///< stitch the node belongs to; a shared foot node belongs to the left one
  std::vector<double> from_head;          ///< [mm] arc length to the nearest middle of a needle-loop head
  std::vector<double> from_foot;          ///< [mm] arc length to the nearest middle of a sinker-loop foot
};

/// A knitted fabric as yarn centrelines with meaning. x along the course, y along the wale, z out of plane; the head
/// middle of the first stitch of course 0 lies at x = 0, and course c is shifted by c T along y.
struct Fabric {
  FabricLayout layout;
  double erc_length = 0;         ///< [mm], arc length of one half stitch
  std::vector<YarnCurve> yarns;  ///< basic: one per course, bottom to top
};

}  // namespace knitmech::knit
