#include "contact/cell_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace knitmech::contact {
namespace {

constexpr double kRadii = 0.12;  // mm

/// Cells of all kinds: pressed at one end, at both, amid, everywhere, not at all, flat, straight, and far too deep.
std::vector<std::array<double, 3>> depths() {
  std::vector<std::array<double, 3>> depths = {{0, 0, 0},           {-0.001, -0.001, -0.001}, {0.002, 0.002, 0.002},
                                               {-0.001, 0, 0.001},  {0.001, 0, -0.001},       {0.001, -0.001, 0.001},
                                               {0.05, 0.055, 0.05}, {0.03, -0.01, 0.02}};
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 3001; ++i) {
    const double middle = 0.01 * uniform(random);
    const double slope = 0.008 * uniform(random);
    const double bend = 0.006 * uniform(random);
    depths.push_back({middle - slope + bend, middle, middle + slope + bend});
  }
  return depths;
}

TEST(CellBatch, GivenCellsOfAllKinds_ThenTheyAreIntegratedAsOnTheirOwn) {
  CellBatch batch;
  for (const auto& [start, middle, end] : depths()) batch.add(start, middle, end, kRadii);
  batch.integrate();
  ASSERT_EQ(batch.size(), depths().size());
  int pressed = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const auto [start, middle, end] = depths()[i];
    const CellLoad alone = integrate_cell(start, middle, end, kRadii);
    const CellLoad here = batch.load(i);
    const double size = std::abs(alone.force[0]) + std::abs(alone.force[1]) + std::abs(alone.force[2]);
    EXPECT_NEAR(here.energy, alone.energy, 2e-6 * alone.energy + 1e-20) << i;
    EXPECT_NEAR(here.tangent, alone.tangent, 1e-5 * alone.tangent + 1e-15) << i;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(here.force[k], alone.force[k], 2e-6 * size + 1e-18) << i;
    if (alone.energy > 0) ++pressed;
  }
  EXPECT_GT(pressed, 1500);
}

TEST(CellBatch, GivenThatItIsClearedAndUsedAgain_ThenOnlyTheNewCellsAreThere) {
  CellBatch batch;
  for (int i = 0; i < 20; ++i) batch.add(0.01, 0.01, 0.01, kRadii);
  batch.integrate();
  batch.clear();
  batch.add(-0.01, -0.01, -0.01, kRadii);
  batch.integrate();
  EXPECT_EQ(batch.size(), 1U);
  EXPECT_EQ(batch.load(0).energy, 0);
}

}  // namespace
}  // namespace knitmech::contact
