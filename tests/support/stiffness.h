#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "beam_case.h"

namespace knitmech::test {

/// Six values per node: along the axes of space, and about them.
inline Eigen::VectorXd loads_of(const beam::Elements& elements, const model::State& state) {
  const std::size_t n = elements.size();
  beam::ElementWork work(n);
  model::NodalLoads loads(n);
  beam::set_internal_force(elements, state, 0.0, work, loads);
  Eigen::VectorXd all(6 * static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    all.segment<6>(6 * static_cast<Eigen::Index>(i)) << vector_at(loads.force, i), vector_at(loads.moment, i);
  }
  return all;
}

/// Moves and turns every node by its six values.
inline void displace(model::State& state, const Eigen::VectorXd& by) {
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const Eigen::Matrix<double, 6, 1> motion = by.segment<6>(6 * static_cast<Eigen::Index>(i));
    state.position.add(i, {motion[0], motion[1], motion[2]});
    set_rotation(state, i, turn(motion.tail<3>()) * rotation_of(state, i));
  }
}

/// Stiffness matrix of one yarn: the loads of the elements, differentiated numerically. Every third node is moved at a
/// time, as a node loads its neighbours only.
inline Eigen::MatrixXd stiffness_of(const beam::Elements& elements, const model::State& state) {
  const double h = 1e-6;  // [mm] or [rad]
  const auto n = static_cast<Eigen::Index>(elements.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  for (Eigen::Index first = 0; first < 3; ++first) {
    for (Eigen::Index axis = 0; axis < 6; ++axis) {
      Eigen::VectorXd motion = Eigen::VectorXd::Zero(6 * n);
      for (Eigen::Index node = first; node < n; node += 3) motion[6 * node + axis] = h;
      model::State ahead = state, behind = state;
      displace(ahead, motion);
      displace(behind, -motion);
      const Eigen::VectorXd slope = (loads_of(elements, behind) - loads_of(elements, ahead)) / (2 * h);
      for (Eigen::Index node = first; node < n; node += 3) {
        const Eigen::Index top = 6 * std::max<Eigen::Index>(node - 1, 0);
        const Eigen::Index rows = 6 * std::min<Eigen::Index>(node + 2, n) - top;
        stiffness.block(top, 6 * node + axis, rows, 1) = slope.segment(top, rows);
      }
    }
  }
  return stiffness;
}

/// Which motions the supports leave free: all six values of every node = matrix * free values.
struct Freedom {
  Eigen::MatrixXd matrix;

  /// \param held degrees of freedom (6 node + axis) that do not move
  static Freedom without(std::size_t n_nodes, const std::vector<Eigen::Index>& held) {
    const auto n = 6 * static_cast<Eigen::Index>(n_nodes);
    Freedom freedom{Eigen::MatrixXd::Zero(n, n - static_cast<Eigen::Index>(held.size()))};
    Eigen::Index column = 0;
    for (Eigen::Index row = 0; row < n; ++row) {
      if (std::find(held.begin(), held.end(), row) == held.end()) freedom.matrix(row, column++) = 1;
    }
    return freedom;
  }
  /// The last node moves as the first one: a closed yarn.
  static Freedom closed(std::size_t n_nodes) {
    const auto n = 6 * static_cast<Eigen::Index>(n_nodes);
    Freedom freedom{Eigen::MatrixXd::Zero(n, n - 6)};
    freedom.matrix.topRows(n - 6).setIdentity();
    freedom.matrix.bottomLeftCorner(6, 6).setIdentity();
    return freedom;
  }
};

/// Squared angular frequencies [1/s^2] in ascending order, and shapes, of small vibrations about an equilibrium; a
/// negative square is that of a growth rate.
struct Modes {
  Eigen::VectorXd squared;
  Eigen::MatrixXd shapes;  ///< columns, six values per node, of unit modal mass
};

inline Modes modes_of(const beam::Elements& elements, const model::State& state, const Freedom& freedom) {
  const beam::NodalInertia inertia = beam::lump_inertia(elements, 1.0);
  Eigen::VectorXd mass(freedom.matrix.rows());
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    const auto node = static_cast<std::size_t>(i / 6);
    mass[i] = i % 6 < 3 ? inertia.mass[node] : inertia.rotary[node];
  }
  const Eigen::VectorXd free_mass = (freedom.matrix.transpose() * mass.asDiagonal() * freedom.matrix).diagonal();
  const Eigen::MatrixXd to_all = freedom.matrix * free_mass.cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd dynamic = to_all.transpose() * stiffness_of(elements, state) * to_all;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (dynamic + dynamic.transpose()));
  return {solver.eigenvalues(), to_all * solver.eigenvectors()};
}

/// Brings a yarn into equilibrium with dead loads by Newton's method, stable or not, turning no node by more than 0.1
/// at a time.
/// \param external six values per node, in space
/// \return largest load that is left, [N] or [N mm]
inline double find_equilibrium(const beam::Elements& elements, model::State& state, const Freedom& freedom,
                               const Eigen::VectorXd& external) {
  double left = 0;
  for (int i = 0; i < 40; ++i) {
    const Eigen::VectorXd load = freedom.matrix.transpose() * (loads_of(elements, state) + external);
    left = load.cwiseAbs().maxCoeff();
    if (left < 1e-12) break;
    const Eigen::MatrixXd stiffness = freedom.matrix.transpose() * stiffness_of(elements, state) * freedom.matrix;
    const Eigen::VectorXd motion = freedom.matrix * stiffness.partialPivLu().solve(load);
    displace(state, std::min(1.0, 0.1 / motion.cwiseAbs().maxCoeff()) * motion);
  }
  return left;
}

/// The zero of a function by the secant method, from two guesses, to 1e-6 of itself.
template <typename Function>
double root_of(Function function, double first, double second) {
  double value_first = function(first);
  for (int i = 0; i < 10 && std::abs(second - first) > 1e-6 * std::abs(second); ++i) {
    const double value = function(second);
    const double next = second - value * (second - first) / (value - value_first);
    first = second;
    value_first = value;
    second = next;
  }
  return second;
}

}  // namespace knitmech::test
