#include "yarn/multifilament.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/errors.h"
#include "yarn/monofilament.h"

namespace knitmech::yarn {
namespace {

/// A drawn filament: G is far below E / (2 (1 + nu)).
Monofilament filament() {
  return {.diameter = 0.016, .youngs_modulus = 3000, .density = 1.38e-9, .shear_modulus = 700};
}

/// 34 such filaments in a yarn of 0.12 mm.
Multifilament yarn_with(double twist) {
  return {.filaments = 34, .filament = filament(), .diameter = 0.12, .twist = twist};
}

TEST(Multifilament, WithoutTwistIsThatManyFilamentsSideBySide) {
  // Reference: B = n E I_f, K = n G J_f, EA = n E A_f with I_f = pi d^4 / 64, J_f = 2 I_f, A_f = pi d^2 / 4.
  const Section section = section_of(yarn_with(0));
  const double area = std::numbers::pi / 4 * 0.016 * 0.016;
  const double second_moment = std::numbers::pi / 64 * std::pow(0.016, 4);
  EXPECT_NEAR(section.axial_stiffness / (34 * 3000 * area), 1, 1e-14);
  EXPECT_NEAR(section.bending_stiffness / (34 * 3000 * second_moment), 1, 1e-14);
  EXPECT_NEAR(section.torsional_stiffness / (34 * 700 * 2 * second_moment), 1, 1e-14);
  EXPECT_NEAR(section.mass_per_length / (34 * 1.38e-9 * area), 1, 1e-14);
  EXPECT_NEAR(section.shear_stiffness / (34 * section_of(filament()).shear_stiffness), 1, 1e-14);
  EXPECT_EQ(section.diameter, 0.12);
}

TEST(Multifilament, OfOneFilamentThatFillsTheYarnIsThatMonofilamentAtAnyTwist) {
  const Section alone = section_of(filament());
  const Section section =
      section_of(Multifilament{.filaments = 1, .filament = filament(), .diameter = 0.016, .twist = 5});
  EXPECT_NEAR(section.axial_stiffness / alone.axial_stiffness, 1, 1e-14);
  EXPECT_NEAR(section.shear_stiffness / alone.shear_stiffness, 1, 1e-14);
  EXPECT_NEAR(section.bending_stiffness / alone.bending_stiffness, 1, 1e-14);
  EXPECT_NEAR(section.torsional_stiffness / alone.torsional_stiffness, 1, 1e-14);
  EXPECT_NEAR(section.mass_per_length / alone.mass_per_length, 1, 1e-14);
}

/// Bending and torsional stiffness of one helical filament from the turning of its end, integrated numerically: a unit
/// moment m at the end of one turn turns it by the integral over the arc of [(m.t) t / GJ + (m - (m.t) t) / EI], whose
/// part along m, per length of the turn along the axis, is 1 / stiffness.
double helix_stiffness(double helix_angle, double bending, double torsional, bool about_axis) {
  constexpr int kSteps = 720;
  const double sine = std::sin(helix_angle);
  const double cosine = std::cos(helix_angle);
  const double arc_per_length = std::sqrt(1 + std::tan(helix_angle) * std::tan(helix_angle));
  double compliance = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.5) / kSteps;
    const double along = about_axis ? cosine : -sine * std::sin(turn);  // of m = e_z or e_x
    compliance += arc_per_length / kSteps * (along * along / torsional + (1 - along * along) / bending);
  }
  return 1 / compliance;
}

TEST(HelicalFilament, BendsAndTwistsLikeASpring) {
  // References: the compliance of the helix, integrated around the turn; and for a close-coiled spring of round wire
  // (Q near 90 degrees) Wahl's EI -> 2 EI GJ / (EI + GJ) a / s in bending and EI a / s in torsion, with a / s the
  // length of the spring per length of wire.
  const Section wire = section_of(filament());
  for (const double angle : {0.0, 0.2, 0.6, 1.0, 1.4}) {
    const HelicalFilament helix = helical_filament(wire, angle);
    EXPECT_NEAR(
        helix.bending_stiffness / helix_stiffness(angle, wire.bending_stiffness, wire.torsional_stiffness, false), 1,
        1e-12);
    EXPECT_NEAR(
        helix.torsional_stiffness / helix_stiffness(angle, wire.bending_stiffness, wire.torsional_stiffness, true), 1,
        1e-12);
  }
  const double close_coiled = std::numbers::pi / 2 - 1e-4;
  const HelicalFilament spring = helical_filament(wire, close_coiled);
  const double length_per_wire = std::cos(close_coiled);
  const double ei = wire.bending_stiffness;
  const double gj = wire.torsional_stiffness;
  EXPECT_NEAR(spring.bending_stiffness / (2 * ei * gj / (ei + gj) * length_per_wire), 1, 1e-6);
  EXPECT_NEAR(spring.torsional_stiffness / (ei * length_per_wire), 1, 1e-6);
}

TEST(HelicalFilament, StretchesByTheShareOfTheYarnsStrainAlongIt) {
  // Reference: the length of one turn of pitch h at the radius r, sqrt(h^2 + (2 pi r)^2), when the pitch grows by a
  // small strain; the work of the filament's force is that of the yarn's.
  const Section wire = section_of(filament());
  const double pitch = 1.5;
  const double radius = 0.1;
  const double strain = 1e-5;
  const auto length = [&](double h) { return std::hypot(h, 2 * std::numbers::pi * radius); };
  const double filament_strain = (length(pitch * (1 + strain)) - length(pitch * (1 - strain))) / 2 / length(pitch);
  const double energy_per_length = wire.axial_stiffness / 2 * filament_strain * filament_strain * length(pitch) / pitch;
  const HelicalFilament helix = helical_filament(wire, std::atan(2 * std::numbers::pi * radius / pitch));
  EXPECT_NEAR(helix.axial_stiffness / (2 * energy_per_length / (strain * strain)), 1, 1e-8);
  EXPECT_NEAR(helix.mass_per_length / (wire.mass_per_length * length(pitch) / pitch), 1, 1e-14);
}

TEST(Multifilament, SpreadsItsFilamentsEvenlyOverTheSection) {
  // Reference: helical filaments at many radii, each as often as its ring has area (midpoint rule in the area, whose
  // error falls with the square of the number of rings), for no, usual and extreme twist, and for G above and below E
  // / 2.
  constexpr int kRings = 20000;
  for (const double shear_modulus : {200.0, 1079.0, 1500.0, 4000.0}) {
    for (const double twist : {0.001, 0.2, 1.0, 5.0, 20.0}) {
      Multifilament yarn = yarn_with(twist);
      yarn.filament.shear_modulus = shear_modulus;
      const Section one = section_of(yarn.filament);
      HelicalFilament sum;
      for (int i = 0; i < kRings; ++i) {
        const double radius = (0.12 - 0.016) / 2 * std::sqrt((i + 0.5) / kRings);
        const HelicalFilament at = helical_filament(one, std::atan(2 * std::numbers::pi * radius * twist));
        sum.axial_stiffness += at.axial_stiffness;
        sum.shear_stiffness += at.shear_stiffness;
        sum.bending_stiffness += at.bending_stiffness;
        sum.torsional_stiffness += at.torsional_stiffness;
        sum.mass_per_length += at.mass_per_length;
      }
      const double share = 34.0 / kRings;
      const Section section = section_of(yarn);
      EXPECT_NEAR(section.axial_stiffness / (share * sum.axial_stiffness), 1, 1e-6) << twist;
      EXPECT_NEAR(section.shear_stiffness / (share * sum.shear_stiffness), 1, 1e-6) << twist;
      EXPECT_NEAR(section.bending_stiffness / (share * sum.bending_stiffness), 1, 1e-6) << twist;
      EXPECT_NEAR(section.torsional_stiffness / (share * sum.torsional_stiffness), 1, 1e-6) << twist;
      EXPECT_NEAR(section.mass_per_length / (share * sum.mass_per_length), 1, 1e-6) << twist;
    }
  }
}

TEST(Multifilament, IsSmoothWhereItsFormulaChangesBranch) {
  // EI = GJ of the filament (G = E / 2) is where the mean turns from atanh to atan; a helix of such a wire has the
  // stiffness EI cos Q in bending and in torsion, and <cos Q> = 2 / (V + 1).
  Multifilament yarn = yarn_with(1);
  yarn.filament.shear_modulus = 1500;
  const Section one = section_of(yarn.filament);
  const double secant = std::hypot(1, 2 * std::numbers::pi * 0.052);
  const double expected = 34 * one.bending_stiffness * 2 / (secant + 1);
  EXPECT_NEAR(section_of(yarn).bending_stiffness / expected, 1, 1e-13);
  EXPECT_NEAR(section_of(yarn).torsional_stiffness / expected, 1, 1e-13);
  for (const double factor : {1 - 1e-9, 1 + 1e-9}) {
    yarn.filament.shear_modulus = 1500 * factor;
    EXPECT_NEAR(section_of(yarn).bending_stiffness / expected, 1, 1e-8);
    EXPECT_NEAR(section_of(yarn).torsional_stiffness / expected, 1, 1e-8);
  }
}

TEST(Multifilament, IsFarSofterInBendingThanASolidYarn) {
  const Section bundle = section_of(yarn_with(0.2));
  const Section solid =
      section_of(Monofilament{.diameter = 0.12, .youngs_modulus = 3000, .density = 1.38e-9, .shear_modulus = 700});
  EXPECT_LT(bundle.bending_stiffness, solid.bending_stiffness / 90);
  EXPECT_GT(bundle.axial_stiffness, solid.axial_stiffness / 2);
}

TEST(Multifilament, ThatDoesNotFitOrHasImpossibleValuesIsRefused) {
  EXPECT_THROW((void)section_of(Multifilament{57, filament(), 0.12, 0.2}), InputError);  // 57 x 0.016^2 > 0.12^2
  EXPECT_NO_THROW((void)section_of(Multifilament{56, filament(), 0.12, 0.2}));
  EXPECT_THROW((void)section_of(Multifilament{0, filament(), 0.12, 0.2}), InputError);
  EXPECT_THROW((void)section_of(Multifilament{-3, filament(), 0.12, 0.2}), InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {0.0, -0.1, nan}) {
    EXPECT_THROW((void)section_of(Multifilament{34, filament(), wrong, 0.2}), InputError);
    for (double Monofilament::*value :
         {&Monofilament::diameter, &Monofilament::youngs_modulus, &Monofilament::density}) {
      Multifilament yarn = yarn_with(0.2);
      yarn.filament.*value = wrong;
      EXPECT_THROW((void)section_of(yarn), InputError);
    }
  }
  EXPECT_THROW((void)section_of(yarn_with(-0.1)), InputError);
  EXPECT_THROW((void)section_of(yarn_with(nan)), InputError);
}

}  // namespace
}  // namespace knitmech::yarn
