#include "exchange/yarn_path.h"

#include <algorithm>
#include <cmath>

#include "model/places.h"
#include "model/yarn_curve.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using model::CurvePiece;

/// One element of the model with the curve through it.
struct Bend {
  const CurvePiece& piece;
  Vector3d middle_offset;  ///< from the middle of the cubic to that of the true centreline [mm]

  [[nodiscard]] Vector3d point(double u) const {
    const double v = 1 - u;
    return piece.point(u) + (16 * u * u * v * v) * middle_offset;
  }
  [[nodiscard]] Vector3d tangent(double u) const {
    const double v = 1 - u;
    const Vector3d along = piece.tangent(u) * length() + (32 * u * v * (v - u)) * middle_offset;
    return along.normalized();
  }
  [[nodiscard]] double length() const { return piece.start_tangent.norm(); }
  [[nodiscard]] double turn_between(double u, double v) const {
    return std::acos(std::clamp(tangent(u).dot(tangent(v)), -1.0, 1.0));
  }
  [[nodiscard]] double turn() const { return turn_between(0, 0.5) + turn_between(0.5, 1); }
  /// The turn, were it all bent as at its sharpest eighth.
  [[nodiscard]] double sharpest_turn() const {
    double sharpest = 0;
    for (int i = 0; i < 8; ++i) sharpest = std::max(sharpest, 8 * turn_between(i / 8.0, (i + 1) / 8.0));
    return sharpest;
  }
};

Bend bend_of(const model::Model& model, const CurvePiece& piece) {
  const auto node = static_cast<std::size_t>(piece.node);
  const bool straightforward = model.middles.empty();
  return {piece, straightforward ? Vector3d(0, 0, 0) : Vector3d(model.middles[node] - piece.point(0.5))};
}

Grip grip_of_node(const model::Model& model, int node) {
  const auto in = [&](const std::string& set) {
    const auto found = model.node_sets.find(set);
    return found != model.node_sets.end() && std::ranges::binary_search(found->second, node);
  };
  if (in(model.test.held_set)) return Grip::held;
  return in(model.test.driven_set) ? Grip::driven : Grip::none;
}

Grip grip_of_place(const model::Model& model, int element, double share) {
  if (share == 0) return grip_of_node(model, element);
  const Grip behind = grip_of_node(model, element + 1);
  return share == 1 || behind == grip_of_node(model, element) ? behind : Grip::none;
}

/// Shares at which an element must be cut: its ends and ties.
std::vector<double> needed_cuts(const model::Model& model, const Bend& bend, double shortest) {
  std::vector<double> cuts{0, 1};
  const auto add = [&](double share) {
    const double nearest = std::ranges::min(cuts, {}, [&](double cut) { return std::abs(cut - share); });
    if (std::abs(nearest - share) * bend.length() > shortest) cuts.push_back(share);
  };
  for (const model::Tie& tie : model.ties) {
    for (const model::ElementPlace& place : {tie.first, tie.second}) {
      if (place.element == bend.piece.node) add(place.share);
    }
  }
  std::ranges::sort(cuts);
  return cuts;
}

PathPoint path_point(const model::Model& model, const Bend& bend, double share) {
  const int element = bend.piece.node;
  return {bend.point(share), bend.tangent(share), element, share, grip_of_place(model, element, share)};
}

/// How many equal parts of an element are within the options.
double parts_of(const yarn::Section& section, const Bend& bend, const PathOptions& options) {
  const double gyration = std::sqrt(section.bending_stiffness / section.axial_stiffness);
  const double rise = bend.length() * bend.sharpest_turn() / 8;  // of an arc; falls with the square of the parts
  return std::max({bend.length() / (options.largest_length * section.diameter), bend.turn() / options.largest_turn,
                   std::sqrt(rise / (options.largest_rise * gyration))});
}

/// Adds the points of an element of the model, without its last one.
void add_element(YarnPath& path, const model::Model& model, const Bend& bend, const PathOptions& options) {
  const std::vector<double> cuts = needed_cuts(model, bend, options.shortest * 2 * bend.piece.radius);
  const double parts = parts_of(model.section_of(static_cast<std::size_t>(bend.piece.node)), bend, options);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double width = cuts[i + 1] - cuts[i];
    const int n = std::max(1, static_cast<int>(std::ceil(parts * width - 1e-6)));
    for (int k = 0; k < 2 * n; ++k) path.points.push_back(path_point(model, bend, cuts[i] + width * k / (2 * n)));
  }
}

}  // namespace

std::vector<YarnPath> yarn_paths(const model::Model& model, const PathOptions& options) {
  std::vector<YarnPath> paths;
  const std::vector<CurvePiece> pieces = model::yarn_curves(model);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const CurvePiece& piece = pieces[i];
    if (!piece.continues_piece_before) paths.push_back({piece.yarn, {}});
    const Bend bend = bend_of(model, piece);
    add_element(paths.back(), model, bend, options);
    const bool last = i + 1 == pieces.size() || !pieces[i + 1].continues_piece_before;
    if (last) paths.back().points.push_back(path_point(model, bend, 1));
  }
  return paths;
}

std::vector<YarnPath> cut_at_grips(const YarnPath& path) {
  const auto held = [&](std::size_t element) {
    const Grip grip = path.points[2 * element].grip;
    return grip != Grip::none && path.points[2 * element + 1].grip == grip && path.points[2 * element + 2].grip == grip;
  };
  std::vector<YarnPath> pieces;
  for (std::size_t element = 0; element < path.n_elements(); ++element) {
    const auto first = path.points.begin() + static_cast<std::ptrdiff_t>(2 * element);
    const bool border =
        element == 0 || held(element) != held(element - 1) || (first->grip != Grip::none && !held(element));
    if (border) pieces.push_back({path.yarn, {*first}});
    pieces.back().points.insert(pieces.back().points.end(), first + 1, first + 3);
  }
  return pieces;
}

bool lies_in_grip(const YarnPath& piece) {
  return std::ranges::all_of(piece.points, [](const PathPoint& point) { return point.grip != Grip::none; });
}

double distance_of_end(const YarnPath& path, std::size_t end, const model::ElementPlace& place) {
  return std::abs(path.points[end].element + path.points[end].share - place.element - place.share);
}

std::size_t end_at(const YarnPath& path, const model::ElementPlace& place) {
  std::size_t nearest = 0;
  for (std::size_t i = 2; i < path.points.size(); i += 2) {
    if (distance_of_end(path, i, place) < distance_of_end(path, nearest, place)) nearest = i;
  }
  return nearest;
}

}  // namespace knitmech::exchange
