#pragma once

#include <cstddef>
#include <vector>

#include "base/vector3.h"

namespace knitmech::model {

/// n vectors in space as a struct of arrays, so that consecutive nodes of a yarn are consecutive in memory.
struct VectorArray {
  std::vector<double> x, y, z;

  VectorArray() = default;
  explicit VectorArray(std::size_t n) : x(n, 0.0), y(n, 0.0), z(n, 0.0) {}
  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Vector3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, Vector3 v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
  void add(std::size_t i, Vector3 v) {
    x[i] += v.x;
    y[i] += v.y;
    z[i] += v.z;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(x, y, z);
  }
};

/// n unit quaternions (w, x, y, z) as a struct of arrays; all identity at first.
struct RotationArray {
  std::vector<double> w, x, y, z;

  RotationArray() = default;
  explicit RotationArray(std::size_t n) : w(n, 1.0), x(n, 0.0), y(n, 0.0), z(n, 0.0) {}

  template <class Archive>
  void serialize(Archive& archive) {
    archive(w, x, y, z);
  }
};

/// Where every node is and how it moves. One entry per node, numbered as in Model.
struct State {
  double time = 0;               ///< [s], of positions and rotations
  VectorArray position;          ///< [mm]
  RotationArray rotation;        ///< since the stress-free shape
  VectorArray velocity;          ///< [mm/s], half a step before `time` (leapfrog)
  VectorArray angular_velocity;  ///< [1/s], in space axes, half a step before `time`

  State() = default;
  explicit State(std::size_t n) : position(n), rotation(n), velocity(n), angular_velocity(n) {}

  template <class Archive>
  void serialize(Archive& archive) {
    archive(time, position, rotation, velocity, angular_velocity);
  }
};

/// Forces and moments on the nodes, in space axes.
struct NodalLoads {
  VectorArray force;   ///< [N]
  VectorArray moment;  ///< [N mm]

  NodalLoads() = default;
  explicit NodalLoads(std::size_t n) : force(n), moment(n) {}

  template <class Archive>
  void serialize(Archive& archive) {
    archive(force, moment);
  }
};

}  // namespace knitmech::model
