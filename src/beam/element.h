#pragma once

#include "base/vector3.h"
#include "base/vectorise.h"
#include "beam/rotation.h"

namespace knitmech::beam {

/// A unit quaternion w + (x, y, z).
struct Quaternion {
  double w;
  Vector3 v;
};

/// A rotation matrix by rows.
struct Matrix3 {
  Vector3 row_x, row_y, row_z;
};
KNITMECH_INLINE Vector3 rotate(const Matrix3& r, Vector3 a) {
  return {dot(r.row_x, a), dot(r.row_y, a), dot(r.row_z, a)};
}
KNITMECH_INLINE Vector3 rotate_back(const Matrix3& r, Vector3 a) {
  return a.x * r.row_x + a.y * r.row_y + a.z * r.row_z;
}

KNITMECH_INLINE Matrix3 matrix(Quaternion q) {
  const double x = q.v.x, y = q.v.y, z = q.v.z, w = q.w;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

/// Stiffnesses and stress-free shape of one element; see Elements.
struct ElementProperties {
  Vector3 axis;  ///< e1, unit vector along the stress-free chord
  double inverse_length, axial, shear, torsion, bending;
};

/// Strains and section forces of one element in its mid frame (the stress-free axes turned by the mean of both nodes).
struct ElementState {
  Matrix3 mid;           ///< R_m, from the mid frame to space
  Vector3 chord;         ///< rho = R_m^T (x_b - x_a) [mm]
  double inverse_chord;  ///< 1 / |rho| [1/mm]
  Vector3 relative;      ///< u sin(phi): vector part of the relative rotation
  double cosine;         ///< cos(phi), phi half the relative angle
  HalfAngle half;
  double axial_strain;   ///< epsilon [-]
  Vector3 shear_strain;  ///< gamma, across e1 [-]
  Vector3 rotation;      ///< theta, relative rotation vector [rad]
  Vector3 force;         ///< N [N]
  Vector3 moment;        ///< M [N mm]
};

/// Least cos(phi) that an element works with: at a relative rotation of 360 degrees it would have no mid frame.
inline constexpr double kFullTurn = -0.9999;

/// Geometrically exact shear-flexible beam (Simo and Reissner), linear interpolation, one integration point. With the
/// chord in the mid frame, rho = R_m^T (x_b - x_a), and its part across the axis, rho_across = rho - (e1 . rho) e1:
///
///     R_m = R_a exp(theta / 2),            theta = log(R_a^T R_b)
///     epsilon = |rho| / L0 - 1,            gamma = rho_across / L0
///     N = EA epsilon rho / |rho| + k G A' gamma
///     M = (EI theta + (GJ - EI) (e1 . theta) e1) / L0
///
/// All strains vanish in the stress-free shape, where every R is the identity. Because bending is equal about both axes
/// of the section, the section's own axes drop out and only e1 is needed.
///
/// The axial strain is the stretch of the chord, as in Abaqus' B31, not e1 . rho / L0 - 1 as in the textbook. The two
/// agree while shear is small. But with the textbook's, a chord under tension N that leans out of the mid frame gives
/// energy back, so that the shear stiffness in effect is k G A' - N: with the shear stiffness reduced for slender
/// elements, it would be gone at 2 % axial strain of the usual mesh, and nodes would turn away without resistance.
/// The quaternions of the nodes must have come from one continuous motion: then relative rotations of more than 180
/// degrees inside one element, as in the hairpin of a soft yarn, go on beyond (up to 360) and do not flip over.
KNITMECH_INLINE ElementState element_state(const ElementProperties& element, Vector3 chord_in_space, Quaternion a,
                                           Quaternion b) {
  ElementState state{};
  const double product = a.w * b.w + dot(a.v, b.v);
  const double capped = product < 1 ? product : 1.0;
  state.cosine = capped > kFullTurn ? capped : kFullTurn;
  state.relative = a.w * b.v - b.w * a.v - cross(a.v, b.v);
  state.half = half_angle(state.cosine);

  const double to_unit = 0.5 / state.half.cos_half;  // |q_a + q_b| = 2 cos(phi / 2)
  state.mid = matrix({to_unit * (a.w + b.w), to_unit * (a.v + b.v)});
  state.chord = rotate_back(state.mid, chord_in_space);
  state.rotation = (2 * state.half.ratio) * state.relative;

  constexpr double kNoDivisionByZero = 1e-30;  // [mm]
  const double chord_length = length(state.chord) + kNoDivisionByZero;
  state.axial_strain = chord_length * element.inverse_length - 1;
  state.shear_strain = element.inverse_length * (state.chord - dot(element.axis, state.chord) * element.axis);
  state.inverse_chord = 1 / chord_length;
  state.force =
      (element.axial * state.axial_strain * state.inverse_chord) * state.chord + element.shear * state.shear_strain;
  const double twist = dot(element.axis, state.rotation);
  state.moment = element.inverse_length *
                 (element.bending * state.rotation + ((element.torsion - element.bending) * twist) * element.axis);
  return state;
}

/// Energy of stretch and shear, L0 / 2 (EA epsilon^2 + k G A' gamma . gamma) [mJ].
KNITMECH_INLINE double stretch_energy(const ElementProperties& element, const ElementState& state) {
  const double stretch = element.axial * state.axial_strain * state.axial_strain;
  const double shear = element.shear * dot(state.shear_strain, state.shear_strain);
  return 0.5 * (stretch + shear) / element.inverse_length;
}

/// Strain energy W = L0 / 2 (EA epsilon^2 + k G A' gamma . gamma) + theta . M / 2 [mJ].
KNITMECH_INLINE double strain_energy(const ElementProperties& element, const ElementState& state) {
  return stretch_energy(element, state) + 0.5 * dot(state.rotation, state.moment);
}

/// Force on node a (node b gets the opposite) and moments on both nodes, in space.
struct ElementLoads {
  Vector3 force_a, moment_a, moment_b;
};

/// The exact negative derivative of the strain energy. With small rotations (phi_a, phi_b) of the nodes, in the mid
/// frame,
///
///     d theta = S (phi_b - phi_a),                S = f I + (1 - f) u u^T,  f = phi / sin(phi)
///     R_m turns by (phi_a + phi_b) / 2 - tan(phi / 2) u x (phi_b - phi_a) / 2
///
/// so with c = N x rho the derivatives are  c / 2 +- tan(phi / 2) (c x u) / 2 -+ S M  for nodes a and b.
/// \param force the force of the state, plus a viscous one where there is one, in the mid frame
KNITMECH_INLINE ElementLoads element_loads(const ElementState& state, Vector3 force) {
  const Vector3 couple = cross(force, state.chord);
  const Vector3 turned = (0.5 / (1 + state.cosine)) * cross(couple, state.relative);
  const Vector3 moment =
      state.half.ratio * state.moment + (state.half.ratio_slope * dot(state.relative, state.moment)) * state.relative;
  const Vector3 swing = turned - moment;
  const Vector3 half_couple = 0.5 * couple;
  return {rotate(state.mid, force), rotate(state.mid, -1.0 * (half_couple + swing)),
          rotate(state.mid, swing - half_couple)};
}

}  // namespace knitmech::beam
