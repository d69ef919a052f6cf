#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <functional>
#include <vector>

namespace knitmech::test {

/// Nodes of a 20-node hexahedron in its own coordinates, in the order of CalculiX ("CalculiX CrunchiX User's Manual",
/// 6.2.5): the corners of one face, of the other, the edges of one face, of the other, and those between them.
inline const std::array<Eigen::Vector3d, 20>& hexahedron_nodes() {
  static const std::array<Eigen::Vector3d, 20> nodes{{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1},
                                                      {1, -1, 1},   {1, 1, 1},   {-1, 1, 1}, {0, -1, -1}, {1, 0, -1},
                                                      {0, 1, -1},   {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},   {0, 1, 1},
                                                      {-1, 0, 1},   {-1, -1, 0}, {1, -1, 0}, {1, 1, 0},   {-1, 1, 0}}};
  return nodes;
}

/// The serendipity functions of the 20 nodes at a point (Zienkiewicz, Taylor, The Finite Element Method, 8.7).
inline std::array<double, 20> hexahedron_functions(const Eigen::Vector3d& at) {
  std::array<double, 20> values{};
  for (std::size_t i = 0; i < 20; ++i) {
    const Eigen::Vector3d& node = hexahedron_nodes()[i];
    double product = 1, sum = -2;
    for (int k = 0; k < 3; ++k) {
      product *= node[k] == 0 ? 1 - at[k] * at[k] : 1 + node[k] * at[k];
      sum += node[k] * at[k];
    }
    values[i] = i < 8 ? product * sum / 8 : product / 4;
  }
  return values;
}

inline Eigen::Vector3d hexahedron_point(const std::array<Eigen::Vector3d, 20>& corners, const Eigen::Vector3d& at) {
  Eigen::Vector3d point(0, 0, 0);
  const std::array<double, 20> values = hexahedron_functions(at);
  for (std::size_t i = 0; i < 20; ++i) point += values[i] * corners[i];
  return point;
}

/// Derivatives of the point by the coordinates; exact, since the functions are quadratic in each of them.
inline Eigen::Matrix3d hexahedron_jacobian(const std::array<Eigen::Vector3d, 20>& corners, const Eigen::Vector3d& at) {
  Eigen::Matrix3d jacobian;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = 0.5 * Eigen::Vector3d::Unit(k);
    jacobian.col(k) = hexahedron_point(corners, at + step) - hexahedron_point(corners, at - step);
  }
  return jacobian;
}

/// The integral of a function of the point over a hexahedron, by n points of Gauss in each direction, n = 2 or 3. With
/// 2 they are those of C3D20R. \param least the smallest determinant so far, which is lowered
inline double integrate_over(const std::array<Eigen::Vector3d, 20>& corners, int n, double& least,
                             const std::function<double(const Eigen::Vector3d&)>& function) {
  const double two = std::sqrt(1.0 / 3), three = std::sqrt(0.6);
  const std::vector<std::pair<double, double>> points =
      n == 2 ? std::vector<std::pair<double, double>>{{-two, 1}, {two, 1}}
             : std::vector<std::pair<double, double>>{{-three, 5.0 / 9}, {0, 8.0 / 9}, {three, 5.0 / 9}};
  double sum = 0;
  for (const auto& [x, weight_x] : points) {
    for (const auto& [y, weight_y] : points) {
      for (const auto& [z, weight_z] : points) {
        const double determinant = hexahedron_jacobian(corners, {x, y, z}).determinant();
        least = std::min(least, determinant);
        sum += weight_x * weight_y * weight_z * determinant * function(hexahedron_point(corners, {x, y, z}));
      }
    }
  }
  return sum;
}

}  // namespace knitmech::test
