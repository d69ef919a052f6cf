#include "picture/frame_between.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../../support/straight_yarn.h"

namespace knitmech::picture {
namespace {

TEST(FrameBetween, LiesOnTheStraightLineBetweenTwo) {
  const model::Model model = test::straight_yarn();
  model::Frame first = test::undeformed(model);
  model::Frame second = first;
  second.points[3] += Eigen::Vector3d(4, 8, -2);
  second.axial_force[3] = 2;
  second.history.strain = 0.2;
  second.broken = {5};
  const model::Frame frame = frame_between(first, second, 0.25);
  EXPECT_TRUE(frame.points[3].isApprox(first.points[3] + Eigen::Vector3d(1, 2, -0.5), 1e-14));
  EXPECT_DOUBLE_EQ(frame.axial_force[3], 0.5);
  EXPECT_DOUBLE_EQ(frame.history.strain, 0.05);
  EXPECT_EQ(frame.broken, second.broken);
  EXPECT_EQ(frame_between(first, second, 0).broken, first.broken);
}

TEST(FrameBetween, TurnsTheShortestWayAlsoBetweenOppositeQuaternions) {
  const model::Model model = test::straight_yarn();
  model::Frame first = test::undeformed(model);
  model::Frame second = first;
  // Given a turn by 60 degrees about x, written as the quaternion of the opposite sign.
  const double half = std::numbers::pi / 6;
  second.rotations[2] = -Eigen::Vector4d(std::cos(half), std::sin(half), 0, 0);
  // Then half way it is a turn by 30 degrees.
  const Eigen::Vector4d expected(std::cos(half / 2), std::sin(half / 2), 0, 0);
  EXPECT_NEAR((frame_between(first, second, 0.5).rotations[2] - expected).norm(), 0, 1e-15);
}

TEST(RowAtStrain, LiesBetweenTheRowsOfTheHistory) {
  std::vector<model::HistoryRow> history(3);
  for (std::size_t i = 0; i < 3; ++i) {
    history[i].strain = 0.1 * static_cast<double>(i);
    history[i].force_top = static_cast<double>(i * i);
  }
  EXPECT_NEAR(row_at_strain(history, 0.125).force_top, 1.75, 1e-14);
  EXPECT_EQ(row_at_strain(history, -1).force_top, 0);
  EXPECT_EQ(row_at_strain(history, 0.1).force_top, 1);
  EXPECT_EQ(row_at_strain(history, 7).force_top, 4);
}

}  // namespace
}  // namespace knitmech::picture
