#pragma once

#include <Eigen/Dense>
#include <functional>

namespace knitmech::test {

/// A rod in space as a boundary value problem, without elements. With directors R = (d1 d2 d3), d1 along the axis, the
/// internal force n and moment m, arc length s of the stress-free rod (Antman 2005, Nonlinear Problems of Elasticity,
/// chapter 8):
///
///     r' = R (e1 + C_n^-1 R^T n)       R' = R [kappa0 + C_m^-1 R^T m]x       n' = 0       m' = -r' x n
///     C_n = diag(EA, k G A, k G A)     C_m = diag(GJ, EI, EI)
struct ShootingRod {
  double length = 0;                                            ///< [mm]
  double axial = 0, shear = 0;                                  ///< EA, k G A [N]
  double torsion = 0, bending = 0;                              ///< GJ, EI [N mm^2]
  Eigen::Vector3d natural_curvature = Eigen::Vector3d::Zero();  ///< kappa0, about the directors [1/mm]
};

/// A cross section: where it is, how it is turned (columns d1, d2, d3), and the moment in it.
struct RodSection {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [mm]
  Eigen::Matrix3d directors = Eigen::Matrix3d::Identity();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N mm], in space

  [[nodiscard]] RodSection plus(double h, const RodSection& rate) const {
    return {position + h * rate.position, directors + h * rate.directors, moment + h * rate.moment};
  }
};

/// Integrates from one end to the other by the fourth-order Runge-Kutta method.
/// \param force n [N], the same in every section: the dead load at the far end
inline RodSection shoot(const ShootingRod& rod, RodSection at, const Eigen::Vector3d& force) {
  const auto rate = [&](const RodSection& y) -> RodSection {
    const Eigen::Vector3d n = y.directors.transpose() * force;
    const Eigen::Vector3d m = y.directors.transpose() * y.moment;
    const Eigen::Vector3d stretch(1 + n.x() / rod.axial, n.y() / rod.shear, n.z() / rod.shear);
    const Eigen::Vector3d kappa =
        rod.natural_curvature + Eigen::Vector3d(m.x() / rod.torsion, m.y() / rod.bending, m.z() / rod.bending);
    Eigen::Matrix3d turning;
    turning << 0, -kappa.z(), kappa.y(), kappa.z(), 0, -kappa.x(), -kappa.y(), kappa.x(), 0;
    const Eigen::Vector3d along = y.directors * stretch;
    return {along, y.directors * turning, -along.cross(force)};
  };
  const int n_steps = 1000;
  const double h = rod.length / n_steps;
  for (int i = 0; i < n_steps; ++i) {
    const RodSection k1 = rate(at);
    const RodSection k2 = rate(at.plus(h / 2, k1));
    const RodSection k3 = rate(at.plus(h / 2, k2));
    const RodSection k4 = rate(at.plus(h, k3));
    at = at.plus(h / 6, k1).plus(h / 3, k2).plus(h / 3, k3).plus(h / 6, k4);
  }
  return at;
}

/// The zero of three functions of three variables by Newton's method with a numerical Jacobian.
/// \param size of the unknowns, for the step of the differences
inline Eigen::Vector3d newton(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& residual,
                              Eigen::Vector3d at, double size) {
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix3d jacobian;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = 1e-6 * size * Eigen::Vector3d::Unit(k);
      jacobian.col(k) = (residual(at + step) - residual(at - step)) / (2e-6 * size);
    }
    const Eigen::Vector3d change = jacobian.partialPivLu().solve(residual(at));
    at -= change;
    if (change.norm() < 1e-10 * size) break;
  }
  return at;
}

}  // namespace knitmech::test
