#include "exchange/abaqus_section.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "yarn/monofilament.h"

namespace knitmech::exchange {
namespace {

// Given the monofilament of the main example, then Abaqus gets the very numbers of the case file, and the radius.
TEST(AbaqusSection, OfAMonofilamentIsTheCircleItWasMadeOf) {
  const yarn::Section yarn = yarn::section_of(yarn::Monofilament{0.12, 1700, 0.39, 1.14e-9});
  const AbaqusSection section = abaqus_section(yarn);
  EXPECT_TRUE(section.circle);
  EXPECT_EQ(section.radius, 0.06);
  EXPECT_EQ(section.youngs_modulus, 1700);
  EXPECT_EQ(section.poissons_ratio, 0.39);
  EXPECT_EQ(section.density, 1.14e-9);
  EXPECT_EQ(section.shear_stiffness, yarn.shear_stiffness);
}

void expect_products(const AbaqusSection& section, const yarn::Section& yarn) {
  EXPECT_DOUBLE_EQ(section.youngs_modulus * section.area, yarn.axial_stiffness);
  EXPECT_DOUBLE_EQ(section.youngs_modulus * section.inertia, yarn.bending_stiffness);
  EXPECT_DOUBLE_EQ(section.shear_modulus * section.torsion_constant, yarn.torsional_stiffness);
  EXPECT_DOUBLE_EQ(section.density * section.area, yarn.mass_per_length);
}

TEST(AbaqusSection, OfAYarnSofterThanItsCircleIsGeneralAndKeepsEveryStiffness) {
  const yarn::Section yarn = yarn::section_of(yarn::MeasuredYarn{0.12, 1.14e-9, 19.0, 5e-6, 4e-6});
  const AbaqusSection section = abaqus_section(yarn);
  EXPECT_FALSE(section.circle);
  EXPECT_DOUBLE_EQ(section.area, std::numbers::pi * 0.12 * 0.12 / 4);
  expect_products(section, yarn);
}

// Given EI of a solid circle, but GJ so small that nu would be 1, then no isotropic circle can stand for it.
TEST(AbaqusSection, IsGeneralIfNoPoissonsRatioGivesTheTorsion) {
  yarn::Section yarn = yarn::section_of(yarn::Monofilament{0.12, 1700, 0.39, 1.14e-9});
  yarn.torsional_stiffness = yarn.bending_stiffness / 2;
  const AbaqusSection section = abaqus_section(yarn);
  EXPECT_FALSE(section.circle);
  expect_products(section, yarn);
}

TEST(FirstAxis, IsNormalToTheFabricForElementsInItsPlane) {
  EXPECT_EQ(first_axis({1, 0, 0}), 2);
  EXPECT_EQ(first_axis({-3, 2, 0.4}), 2);
}

TEST(FirstAxis, IsAnotherForElementsThatStandOnTheFabric) {
  EXPECT_EQ(first_axis({0.1, 0, 1}), 1);
  EXPECT_EQ(first_axis({0, -0.1, -1}), 0);
}

TEST(FirstAxis, IsAtLeast45DegreesFromAnyElement) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector3d direction(normal(random), normal(random), normal(random));
    ASSERT_LE(std::abs(direction.normalized()[first_axis(direction)]), std::numbers::sqrt2 / 2 + 1e-12);
  }
}

}  // namespace
}  // namespace knitmech::exchange
