#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "model/yarn_curve.h"

namespace knitmech::picture {

/// Where a ray meets a yarn.
struct TubeHit {
  Eigen::Vector3d point;   ///< [mm]
  Eigen::Vector3d normal;  ///< unit, outward, of the smooth tube
  int piece = 0;           ///< index into the pieces of the scene
  double parameter = 0;    ///< along the piece, 0 to 1
};

/// Yarns as tubes that rays can be shot at (Embree's round linear curves, each element cut finely along its smooth
/// curve).
///
/// Rays may be shot from several threads at once.
class TubeScene {
 public:
  explicit TubeScene(std::vector<model::CurvePiece> pieces);
  ~TubeScene();
  TubeScene(const TubeScene&) = delete;
  TubeScene& operator=(const TubeScene&) = delete;
  TubeScene(TubeScene&&) = delete;
  TubeScene& operator=(TubeScene&&) = delete;

  [[nodiscard]] const std::vector<model::CurvePiece>& pieces() const { return pieces_; }

  /// First yarn that a ray meets; direction is a unit vector.
  [[nodiscard]] std::optional<TubeHit> first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

  /// Whether a yarn lies on the first `distance` mm of a ray.
  [[nodiscard]] bool is_blocked(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double distance) const;

 private:
  struct Handles;
  std::vector<model::CurvePiece> pieces_;
  std::unique_ptr<Handles> handles_;
};

/// Straight pieces into which an element is cut [-]; usual 8. More make the outline of strongly bent elements rounder.
inline constexpr int kStraightPiecesPerElement = 8;

}  // namespace knitmech::picture
