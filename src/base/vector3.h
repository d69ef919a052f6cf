#pragma once

#include <cmath>

#include "base/vectorise.h"

namespace knitmech {

/// A vector that lives in registers, for hot loops; every operation is inlined so that such loops vectorise.
struct Vector3 {
  double x, y, z;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(x, y, z);
  }
};
KNITMECH_INLINE Vector3 operator+(Vector3 a, Vector3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
KNITMECH_INLINE Vector3 operator-(Vector3 a, Vector3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
KNITMECH_INLINE Vector3 operator*(double s, Vector3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
KNITMECH_INLINE double dot(Vector3 a, Vector3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
KNITMECH_INLINE Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
KNITMECH_INLINE double length(Vector3 a) {
  return std::sqrt(dot(a, a));
}

}  // namespace knitmech
