#include "yarn/monofilament.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

/// Polyamide-like filament of the example, 1140 kg/m^3 = 1.14e-9 t/mm^3.
Monofilament example() {
  return {.diameter = 0.12, .youngs_modulus = 1700, .poissons_ratio = 0.39, .density = 1.14e-9};
}

TEST(Monofilament, HasTheStiffnessOfTheReferenceSection) {
  // Reference values of the section: EA = 19.2265 N, EI = 0.0173039 N mm^2, GJ = 0.0124488 N mm^2.
  const Section section = section_of(example());
  EXPECT_NEAR(section.axial_stiffness, 19.2265, 5e-5);
  EXPECT_NEAR(section.bending_stiffness, 0.0173039, 5e-8);
  EXPECT_NEAR(section.torsional_stiffness, 0.0124488, 5e-8);
  EXPECT_EQ(section.diameter, 0.12);
}

TEST(Monofilament, WeighsItsVolume) {
  EXPECT_NEAR(section_of(example()).mass_per_length, 1.14e-9 * std::numbers::pi * 0.06 * 0.06, 1e-24);
}

TEST(Monofilament, ShearStiffnessHasCowpersFactor) {
  // Given nu = 0.3, Cowper (1966) tabulates 0.886 for the circle; nu = 0 gives 6/7.
  EXPECT_NEAR(circle_shear_factor(0.3), 0.886, 5e-4);
  EXPECT_NEAR(circle_shear_factor(0), 6.0 / 7.0, 1e-15);
  const Section section = section_of(example());
  EXPECT_NEAR(section.shear_stiffness, circle_shear_factor(0.39) * section.axial_stiffness / (2 * 1.39), 1e-12);
}

TEST(Monofilament, TakesAMeasuredShearModulusInPlaceOfPoissonsRatio) {
  // Given G = 400 MPa, GJ = G pi D^4 / 32; E and A stay, and k is that of the nearest believed nu: E / 2G - 1 = 1.1 >
  // 0.5.
  Monofilament drawn = example();
  drawn.shear_modulus = 400;
  const Section section = section_of(drawn);
  const Section isotropic = section_of(example());
  EXPECT_NEAR(section.torsional_stiffness, 400 * std::numbers::pi * std::pow(0.12, 4) / 32, 1e-15);
  EXPECT_NEAR(section.shear_stiffness, circle_shear_factor(0.5) * 400 * std::numbers::pi * 0.06 * 0.06, 1e-13);
  EXPECT_EQ(section.bending_stiffness, isotropic.bending_stiffness);
  EXPECT_EQ(section.axial_stiffness, isotropic.axial_stiffness);

  // Given the G of isotropic theory, it is the same section as with nu.
  drawn.shear_modulus = 1700 / (2 * 1.39);
  EXPECT_NEAR(section_of(drawn).shear_stiffness, isotropic.shear_stiffness, 1e-13);
  EXPECT_NEAR(section_of(drawn).torsional_stiffness, isotropic.torsional_stiffness, 1e-16);
  drawn.shear_modulus = 0;
  EXPECT_THROW((void)section_of(drawn), InputError);
}

class ImpossibleMonofilament : public testing::TestWithParam<Monofilament> {};
INSTANTIATE_TEST_SUITE_P(Values, ImpossibleMonofilament,
                         testing::Values(Monofilament{0, 1700, 0.39, 1e-9}, Monofilament{-0.12, 1700, 0.39, 1e-9},
                                         Monofilament{0.12, 0, 0.39, 1e-9}, Monofilament{0.12, 1700, -1, 1e-9},
                                         Monofilament{0.12, 1700, 0.51, 1e-9}, Monofilament{0.12, 1700, 0.39, 0},
                                         Monofilament{0.12, std::numeric_limits<double>::quiet_NaN(), 0.39, 1e-9}));

TEST_P(ImpossibleMonofilament, IsRefused) {
  EXPECT_THROW((void)section_of(GetParam()), InputError);
}

TEST(MeasuredYarn, KeepsTheGivenStiffnessAndWeighsAFullCircle) {
  const MeasuredYarn yarn = {
      .diameter = 0.2, .density = 1e-9, .axial_stiffness = 3, .bending_stiffness = 5e-6, .torsional_stiffness = 4e-6};
  const Section section = section_of(yarn);
  EXPECT_EQ(section.axial_stiffness, 3);
  EXPECT_EQ(section.bending_stiffness, 5e-6);
  EXPECT_EQ(section.torsional_stiffness, 4e-6);
  EXPECT_NEAR(section.mass_per_length, 1e-9 * std::numbers::pi * 0.01, 1e-24);
}

TEST(MeasuredYarn, WithTheStiffnessOfAMonofilamentIsThatMonofilament) {
  const Section filament = section_of(example());
  const Section measured = section_of(MeasuredYarn{.diameter = 0.12,
                                                   .density = 1.14e-9,
                                                   .axial_stiffness = filament.axial_stiffness,
                                                   .bending_stiffness = filament.bending_stiffness,
                                                   .torsional_stiffness = filament.torsional_stiffness});
  EXPECT_NEAR(measured.shear_stiffness, filament.shear_stiffness, 1e-12);
  EXPECT_NEAR(measured.mass_per_length, filament.mass_per_length, 1e-24);
}

TEST(MeasuredYarn, TakesPoissonsRatioForShearFromZeroToOneHalf) {
  // Given EI / GJ outside 1 to 1.5, as in bundles of filaments, the nearer end decides: EA k / 2 or EA k / 3.
  const auto shear = [](double bending, double torsional) {
    return section_of(MeasuredYarn{.diameter = 0.2,
                                   .density = 1e-9,
                                   .axial_stiffness = 6,
                                   .bending_stiffness = bending,
                                   .torsional_stiffness = torsional})
        .shear_stiffness;
  };
  EXPECT_NEAR(shear(1, 9), 3 * circle_shear_factor(0), 1e-14);
  EXPECT_NEAR(shear(9, 1), 2 * circle_shear_factor(0.5), 1e-14);
}

TEST(MeasuredYarn, WithoutOneOfItsStiffnessesIsRefused) {
  const MeasuredYarn good = {
      .diameter = 0.2, .density = 1e-9, .axial_stiffness = 3, .bending_stiffness = 5e-6, .torsional_stiffness = 4e-6};
  for (double MeasuredYarn::*value : {&MeasuredYarn::diameter, &MeasuredYarn::density, &MeasuredYarn::axial_stiffness,
                                      &MeasuredYarn::bending_stiffness, &MeasuredYarn::torsional_stiffness}) {
    MeasuredYarn yarn = good;
    yarn.*value = 0;
    EXPECT_THROW((void)section_of(yarn), InputError);
  }
}

}  // namespace
}  // namespace knitmech::yarn
