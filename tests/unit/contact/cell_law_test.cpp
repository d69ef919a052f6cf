#include "contact/cell_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/normal_law.h"

namespace knitmech::contact {
namespace {

constexpr double kRadii = 0.12;  // mm

double depth_at(double distance) {
  return (kRadii * kRadii - distance * distance) / (2 * kRadii);
}

TEST(LawByDepth, GivenAnyDistance_ThenTheEnergyIsThatOfTheNormalLaw) {
  for (const double share : {1e-4, 1e-3, 0.01, 0.04, 0.0512, 0.0514, 0.1, 0.3, 0.7, 0.95}) {
    const double penetration = share * kRadii;
    const double expected = normal_energy(penetration, kRadii);
    // Closed forms lose digits where the energy is small beside 1; the series takes over there.
    EXPECT_NEAR(law_by_depth(depth_at(kRadii - penetration), kRadii).energy, expected, 1e-6 * expected) << share;
  }
}

TEST(LawByDepth, GivenAnyDepth_ThenForceAndTangentAreTheDerivativesOfTheEnergy) {
  for (double depth = 0.0005; depth < 0.055; depth += 0.0007) {
    const double h = 1e-7;
    const LawByDepth less = law_by_depth(depth - h, kRadii);
    const LawByDepth more = law_by_depth(depth + h, kRadii);
    const LawByDepth law = law_by_depth(depth, kRadii);
    EXPECT_NEAR(law.force, (more.energy - less.energy) / (2 * h), 1e-5 * law.force) << depth;
    EXPECT_NEAR(law.tangent, (more.force - less.force) / (2 * h), 1e-6 * law.tangent) << depth;
  }
}

/// Depth along a cell through its three values.
double parabola(double start, double middle, double end, double x) {
  return start * (1 - x) * (1 - 2 * x) + middle * 4 * x * (1 - x) + end * x * (2 * x - 1);
}

double plain_energy(double start, double middle, double end) {
  constexpr int kParts = 20000;
  double energy = 0;
  for (int i = 0; i < kParts; ++i) {
    const double depth = parabola(start, middle, end, (i + 0.5) / kParts);
    if (depth > 0) energy += law_by_depth(depth, kRadii).energy / kParts;
  }
  return energy;
}

/// Depths of both signs: cells that press all along, at one end, amid, and at both ends; up to a fifth of D.
struct Depths {
  double start, middle, end;
};
Depths random_depths(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double middle = 0.01 * uniform(random);
  const double slope = 0.008 * uniform(random);
  const double bend = 0.006 * uniform(random);
  return {middle - slope + bend, middle, middle + slope + bend};
}

TEST(IntegrateCell, GivenAnyParabola_ThenTheEnergyIsItsPlainIntegral) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const Depths d = random_depths(random);
    const double expected = plain_energy(d.start, d.middle, d.end);
    EXPECT_NEAR(integrate_cell(d.start, d.middle, d.end, kRadii).energy, expected, 3e-4 * expected + 1e-12);
  }
}

TEST(IntegrateCell, GivenAnyParabola_ThenTheForcesAreTheDerivativesOfTheEnergy) {
  std::mt19937 random(5);
  int pressed = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Depths d = random_depths(random);
    const CellLoad cell = integrate_cell(d.start, d.middle, d.end, kRadii);
    if (cell.energy < 1e-8) continue;
    ++pressed;
    constexpr double h = 1e-7;
    const auto energy = [&](double start, double middle, double end) {
      return integrate_cell(d.start + start, d.middle + middle, d.end + end, kRadii).energy;
    };
    const double size = std::abs(cell.force[0]) + std::abs(cell.force[1]) + std::abs(cell.force[2]);
    EXPECT_NEAR(cell.force[0], (energy(h, 0, 0) - energy(-h, 0, 0)) / (2 * h), 5e-4 * size);
    EXPECT_NEAR(cell.force[1], (energy(0, h, 0) - energy(0, -h, 0)) / (2 * h), 5e-4 * size);
    EXPECT_NEAR(cell.force[2], (energy(0, 0, h) - energy(0, 0, -h)) / (2 * h), 5e-4 * size);
    EXPECT_NEAR(cell.tangent, (integrate_cell(d.start + h, d.middle + h, d.end + h, kRadii).total() - cell.total()) / h,
                0.01 * cell.tangent);
  }
  EXPECT_GT(pressed, 1000);
}

TEST(IntegrateCell, GivenFlatAndStraightDepths_ThenThereIsNothingSingular) {
  const double flat = law_by_depth(0.004, kRadii).energy;
  EXPECT_NEAR(integrate_cell(0.004, 0.004, 0.004, kRadii).energy, flat, 1e-12 * flat);
  EXPECT_EQ(integrate_cell(-0.004, -0.004, -0.004, kRadii).energy, 0);
  EXPECT_EQ(integrate_cell(0, 0, 0, kRadii).energy, 0);
  EXPECT_EQ(integrate_cell(-0.002, -0.001, 0, kRadii).energy, 0);
  for (const double slope : {-0.002, 0.002}) {
    const double expected = plain_energy(0.0005 - slope, 0.0005, 0.0005 + slope);
    EXPECT_NEAR(integrate_cell(0.0005 - slope, 0.0005, 0.0005 + slope, kRadii).energy, expected, 1e-5 * expected);
  }
}

}  // namespace
}  // namespace knitmech::contact
