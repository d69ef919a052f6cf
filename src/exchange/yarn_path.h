#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "model/model.h"

namespace knitmech::exchange {

/// Which grip of the test a point belongs to.
enum class Grip { none, held, driven };

/// A point of a yarn's centreline: an end or the middle of a quadratic element.
struct PathPoint {
  Eigen::Vector3d point;    ///< [mm]
  Eigen::Vector3d tangent;  ///< unit
  int element = 0;          ///< of the model, by its first node
  double share = 0;         ///< of the way along that element, in [0, 1]; 1 only at the end of the yarn
  Grip grip = Grip::none;
};

/// The centreline of a yarn, cut into quadratic elements that follow each other: element k has the points 2 k,
/// 2 k + 1 (its middle) and 2 k + 2.
struct YarnPath {
  int yarn = 0;                   ///< index into model::Model::yarns
  std::vector<PathPoint> points;  ///< 2 n + 1 of n elements

  [[nodiscard]] std::size_t n_elements() const { return points.size() / 2; }
};

/// How fine a path is.
struct PathOptions {
  static constexpr double kAny = std::numeric_limits<double>::infinity();
  double largest_length = kAny;  ///< of an element, in yarn diameters [-]
  double largest_turn = kAny;    ///< of the centreline over an element [rad]
  double largest_rise = kAny;    ///< of the centreline over an element's chord, in radii of gyration sqrt(EI / EA) [-]
  double shortest = 0;           ///< element that a tie may cut off, in yarn diameters [-]; a nearer end serves the tie
};

/// The yarns of a model as quadratic elements: each element of the model is cut into the fewest equal parts that are
/// within the options. Ends are also laid where a tie is.
///
/// Points lie on the cubic curve through the nodes with their tangents, bent so that it meets Model::middles where the
/// model has them: with u the parameter, 16 u^2 (1 - u)^2 times the distance of the middle is added.
[[nodiscard]] std::vector<YarnPath> yarn_paths(const model::Model& model, const PathOptions& options);

/// A path cut where grips begin and end: pieces that lie wholly in one grip and pieces that are free but for their
/// ends.
[[nodiscard]] std::vector<YarnPath> cut_at_grips(const YarnPath& path);

/// Whether all points of a piece from cut_at_grips() are held.
[[nodiscard]] bool lies_in_grip(const YarnPath& piece);

/// Index of the end point of an element of the path that is nearest to a place of the model.
[[nodiscard]] std::size_t end_at(const YarnPath& path, const model::ElementPlace& place);

/// How far the end point is from the place, in elements of the model.
[[nodiscard]] double distance_of_end(const YarnPath& path, std::size_t end, const model::ElementPlace& place);

}  // namespace knitmech::exchange
