#pragma once

#include <cstddef>
#include <vector>

#include "base/thread_team.h"
#include "beam/nodal_inertia.h"
#include "model/model.h"
#include "model/state.h"

namespace knitmech::solve {

/// Nodes whose motion is given, for each direction; one entry per node.
struct GivenMotion {
  std::vector<char> along, across;  ///< y; x and z

  /// What the grips of the test of a model hold and drive.
  [[nodiscard]] static GivenMotion by_grips(const model::Model& model);
};

/// The mass matrix of yarns with relative mass (beam::NodalInertia::relative_mass), one for each of x, y and z:
///
///     M(i, i) = m_i + b_(i-1) + b_i,   M(i, i + 1) = -b_i,
///
/// so that short waves along a yarn have more inertia than long ones, and a yarn that moves as a whole has none besides
/// its mass (Olovsson, Simonsson, Unosson 2005: selective mass scaling). M is tridiagonal; its factors are found once.
class SelectiveMass {
 public:
  SelectiveMass(const beam::NodalInertia& inertia, const GivenMotion& given);

  /// Replaces the forces F on the nodes by m a, a the accelerations that they give: M a = F where the motion is free;
  /// where it is given, F is m a already. Does nothing without relative mass.
  void share(model::NodalLoads& loads, const base::ThreadTeam& team = base::ThreadTeam(1)) const;

  /// (M a) - m a at a node, for the accelerations a of a direction given as m a [N].
  [[nodiscard]] double from_neighbours(std::size_t node, const std::vector<double>& accelerating) const;

  /// Mass that a force on one free node alone moves, 1 / inverse(M)(i, i) [t].
  [[nodiscard]] const std::vector<double>& felt() const { return felt_; }

  [[nodiscard]] bool is_lumped() const { return relative_.empty(); }

  /// Replaces one component of the forces on all nodes by that of their accelerations, as if no motion were given.
  void accelerate_free(double* component) const;

 private:
  /// M without the rows and columns of given motion, as y_i = F_i + forward_(i-1) y_(i-1), then
  /// a_i = y_i / pivot_i + backward_i a_(i+1).
  struct Factors {
    std::vector<double> forward, backward, inverse_pivot;
    Factors(const beam::NodalInertia& inertia, const std::vector<char>& given);
    void solve(double* values, std::size_t n) const;
  };

  /// Nodes that relative masses hold together.
  struct Chain {
    std::size_t first, n;
  };
  [[nodiscard]] static std::vector<Chain> chains_of(const std::vector<double>& relative_mass);
  template <std::size_t k>
  void share_in(const Chain* chains, model::NodalLoads& loads) const;

  std::vector<double> mass_, relative_, felt_;
  std::vector<Chain> chains_;
  Factors along_, across_, free_;
};

}  // namespace knitmech::solve
