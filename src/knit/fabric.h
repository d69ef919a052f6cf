#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "knit/loop_shape.h"

namespace knitmech::knit {

/// How neighbouring courses are joined at the side edges.
enum class Structure {
  basic,    ///< not at all: every course is a yarn of its own with two free ends
  tied,     ///< as basic, and the yarns that cross in the stitches at the edges are tied to each other
  adjusted  ///< by turning arcs, in turn at the right and at the left: the whole fabric is one yarn
};

/// What a fabric is made of: the loop, how many of it, and how finely it is cut into elements.
struct FabricLayout {
  LoopShape loop;
  int wales = 0;              ///< W, stitches in a course
  int courses = 0;            ///< C
  double course_spacing = 0;  ///< T [mm], along y
  Structure structure = Structure::basic;
  int elements_per_erc = 0;  ///< N, of equal arc length on each half stitch
};

/// The wale of nodes on a turning arc.
inline constexpr int kNoWale = -1;

/// The centreline of one yarn, cut into nodes at equal arc length on every course.
///
/// All vectors have one entry per node, in the order of the yarn.
struct YarnCurve {
  std::vector<Eigen::Vector3d> points;    ///< [mm]
  std::vector<Eigen::Vector3d> tangents;  ///< unit tangent of the true curve, not of the polyline
  std::vector<Eigen::Vector3d> middles;   ///< [mm] half the arc length on to the next node; the last: the node itself
  std::vector<double> arc_length;         ///< [mm] along the true curve from the yarn's first node
  std::vector<int> course;                ///< 0 at the bottom of the fabric; on a turning arc the lower of the two
  std::vector<int> wale;            ///< stitch the node belongs to; a shared foot node belongs to the left one; kNoWale
  std::vector<double> from_head;    ///< [mm] arc length to the nearest middle of a needle-loop head
  std::vector<double> from_foot;    ///< [mm] arc length to the nearest middle of a sinker-loop foot
  std::vector<std::uint8_t> turns;  ///< 1 where the element from this node to the next is part of a turning arc
};

/// Where a course lies in the yarns of a fabric.
struct CourseNodes {
  int yarn = 0;
  int first_node = 0;  ///< of the course, counted from the yarn's first node
  int n_nodes = 0;
  bool runs_left = false;  ///< the yarn runs through it from right to left
};

/// A place on a yarn.
struct PlaceOnYarn {
  int yarn = 0;
  double arc_length = 0;  ///< [mm], from the yarn's first node
};

/// Two yarns that keep their relative position where they cross.
struct YarnTie {
  PlaceOnYarn lower, upper;  ///< on the lower and on the upper course
};

/// A knitted fabric as yarn centrelines with meaning. x along the course, y along the wale, z out of plane; the head
/// middle of the first stitch of course 0 lies at x = 0, and course c is shifted by c T along y.
struct Fabric {
  FabricLayout layout;
  double erc_length = 0;             ///< [mm], arc length of one half stitch
  std::vector<YarnCurve> yarns;      ///< one per course, bottom to top; adjusted: one in all
  std::vector<CourseNodes> courses;  ///< bottom to top
  std::vector<YarnTie> ties;         ///< tied only
};

}  // namespace knitmech::knit
