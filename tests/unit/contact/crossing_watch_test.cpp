#include "contact/crossing_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "watched_yarns.h"

namespace knitmech::contact {
namespace {

using Eigen::Vector3d;

constexpr double kD = kDiameter;
constexpr int kCoarse = 3;  // elements of 7 D, as those of the common mesh of a fabric
constexpr int kFine = 40;   // elements of 0.5 D

/// A yarn along x, and one above it at an angle to it [rad], both 20 D long and crossing in the middle.
std::vector<std::vector<Vector3d>> crossing_yarns(double angle, double height, int n) {
  const Vector3d along = 10 * kD * Vector3d(std::cos(angle), std::sin(angle), 0);
  const Vector3d up(0, 0, height);
  return {test::straight({-10 * kD, 0, 0}, {10 * kD, 0, 0}, n), test::straight(up - along, up + along, n)};
}

Vector3d vector(Vector3 v) {
  return {v.x, v.y, v.z};
}

void expect_nothing(const CrossingReport& report) {
  EXPECT_TRUE(report.lost.empty());
  EXPECT_TRUE(report.ravelled.empty());
}

class CrossingWatchOnMeshes : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Elements, CrossingWatchOnMeshes, testing::Values(kCoarse, 10, kFine));

TEST_P(CrossingWatchOnMeshes, GivenAYarnPushedThroughAnother_ThenTheCrossingIsLostThereAndThenAtAnyAngle) {
  for (const double degrees : {90.0, 60.0, 30.0, 10.0, 3.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    WatchedYarns yarns(crossing_yarns(angle, kD, GetParam()));
    expect_nothing(yarns.at_the_start());
    const Vector3d shift(0.7 * kD, 0.3 * kD, 0);
    expect_nothing(yarns.move_along(shift_along(1, shift - Vector3d(0, 0, 0.95 * kD)), 10));
    const CrossingReport report = yarns.move(shift_yarn(1, shift - Vector3d(0, 0, 1.05 * kD)));
    ASSERT_EQ(report.lost.size(), 1U) << degrees;
    EXPECT_TRUE(report.ravelled.empty());
    // The lines cross in plan where 0.7 D + x cos a, 0.3 D + x sin a meets the x axis.
    const Vector3d expected((0.7 - 0.3 / std::tan(angle)) * kD, 0, 0);
    const Vector3d place = vector(report.lost[0].place);
    EXPECT_LT((place - expected).norm(), 0.1 * kD) << degrees;
    const double along = (place.x() + 10 * kD) / (20 * kD) * GetParam();
    EXPECT_NEAR(report.lost[0].first + 0.5, along, 0.6);
    EXPECT_EQ(yarns.elements().yarn[static_cast<std::size_t>(report.lost[0].second)], 1);
    expect_nothing(yarns.move(shift_yarn(1, shift - Vector3d(0, 0, 1.2 * kD))));
  }
}

TEST_P(CrossingWatchOnMeshes, GivenYarnsThatMeetExactlyAtACall_ThenTheLossIsReportedOnce) {
  WatchedYarns yarns(crossing_yarns(std::numbers::pi / 2, 0.125, GetParam()));
  // Steps of 1/64 mm are exact in binary: node upon node, or element upon element, at the eighth call.
  const CrossingReport report = yarns.move_along(shift_along(1, {0, 0, -0.25}), 16);
  EXPECT_EQ(report.lost.size(), 1U);
  EXPECT_TRUE(report.ravelled.empty());
}

TEST_P(CrossingWatchOnMeshes, GivenYarnsMovedApartSlidAndTurned_ThenNothingIsReported) {
  WatchedYarns yarns(crossing_yarns(std::numbers::pi / 2, kD, GetParam()));
  expect_nothing(yarns.move_along(shift_along(1, {5 * kD, 0, 0}), 30));
  expect_nothing(yarns.move_along(shift_along(1, {0, 6 * kD, 0}), 40));
  expect_nothing(yarns.move_along(shift_along(1, {0, 0, 3 * kD}), 20));
}

TEST_P(CrossingWatchOnMeshes, GivenAYarnTurnedOverAnotherNearlyTouchingItsCentre_ThenNothingIsReported) {
  // A full turn about their common normal: they lie side by side twice, and every crossing changes its sign twice.
  WatchedYarns yarns(crossing_yarns(0.3, 0.1 * kD, GetParam()));
  const auto turned = [](double share) {
    return [=](std::size_t yarn, const Vector3d& x) -> Vector3d {
      return yarn == 0 ? x : Eigen::AngleAxisd(2 * std::numbers::pi * share, Vector3d::UnitZ()) * x;
    };
  };
  // The ends move by 0.2 D between two calls.
  expect_nothing(yarns.move_along(turned, 320));
}

TEST_P(CrossingWatchOnMeshes, GivenATangleMovedAsOneBody_ThenNothingIsReported) {
  WatchedYarns yarns(crossing_yarns(0.5, 0.05 * kD, GetParam()));
  const Vector3d axis = Vector3d(1, 2, 3).normalized();
  const auto moved = [&](double share) {
    return [=](std::size_t, const Vector3d& x) -> Vector3d {
      return Eigen::AngleAxisd(6 * share, axis) * x + share * Vector3d(30, -20, 10) * kD;
    };
  };
  expect_nothing(yarns.move_along(moved, 400));
}

TEST_P(CrossingWatchOnMeshes, GivenBothLegsOfALoopPushedThroughAYarnTogether_ThenTwoCrossingsAreLost) {
  // The two passes have opposite signs; any number that counts both together would not change.
  const double leg = 3 * kD;
  const auto loop = [&](double height) {
    return std::vector<Vector3d>{{-leg, -10 * kD, height}, {-leg, -3 * kD, height}, {-leg, 8 * kD, height},
                                 {leg, 8 * kD, height},    {leg, -3 * kD, height},  {leg, -10 * kD, height}};
  };
  WatchedYarns yarns({test::straight({-12 * kD, 0, 0}, {12 * kD, 0, 0}, GetParam()), loop(kD)});
  const CrossingReport report = yarns.move_along(shift_along(1, {0, 0, -1.9 * kD}), 11);
  ASSERT_EQ(report.lost.size(), 2U);
  EXPECT_LT((vector(report.lost[0].place) - Vector3d(leg, 0, 0)).norm(), 0.2 * kD);
  EXPECT_LT((vector(report.lost[1].place) + Vector3d(leg, 0, 0)).norm(), 0.2 * kD);
}

TEST_P(CrossingWatchOnMeshes, GivenALoopPulledOffAYarnSideways_ThenNothingIsReported) {
  // An arc that lies on the yarn, its bight 3 D beyond it: two crossings of opposite sign meet there and are gone.
  const auto arc = [](double p) { return in_diameters(5 * std::cos(p), 5 * std::sin(p) - 2, 1); };
  WatchedYarns yarns({test::straight({-12 * kD, 0, 0}, {12 * kD, 0, 0}, GetParam()),
                      drawn(arc, -0.3, std::numbers::pi + 0.3, 2 * GetParam())});
  expect_nothing(yarns.move_along(shift_along(1, {0, -6 * kD, 0}), 40));
}

TEST(CrossingWatch, GivenAYarnThatPassesThroughItself_ThenTheCrossingIsLost) {
  // A loop whose end lies over its start; the end is pushed down through it.
  const auto loop = [](double p) { return in_diameters(8 * std::cos(p) + 3 * p, 8 * std::sin(p), p > 2 ? 1 : 0); };
  for (const int n : {15, 90}) {
    WatchedYarns yarns({drawn(loop, -1.5, 5, n)});
    const auto down = [](double share) {
      return [=](std::size_t, const Vector3d& x) -> Vector3d {
        return x.z() > 0.5 * kD ? Vector3d(x - Vector3d(0, 0, 2 * share * kD)) : x;
      };
    };
    const CrossingReport report = yarns.move_along(down, 12);
    ASSERT_EQ(report.lost.size(), 1U) << n;
    EXPECT_TRUE(report.ravelled.empty());
  }
}

TEST(CrossingWatch, GivenAPassWithinTheLastRadiusOfAnEnd_ThenItIsRavellingAndFurtherInItIsALoss) {
  for (const double sticks_out : {0.4, 0.6}) {
    // The upper yarn first lies 2 D over the lower one, is drawn back, and then pushed through.
    const Vector3d end(0, 2 * kD, kD);
    WatchedYarns yarns({test::straight({-10 * kD, 0, 0}, {10 * kD, 0, 0}, kFine),
                        test::straight(end - Vector3d(0, 20 * kD, 0), end, kFine)});
    const Vector3d back(0, (sticks_out - 2) * kD, 0);
    expect_nothing(yarns.move_along(shift_along(1, back), 10));
    const auto down = [&](double share) { return shift_yarn(1, back - Vector3d(0, 0, 2 * share * kD)); };
    const CrossingReport report = yarns.move_along(down, 13);
    EXPECT_EQ(report.lost.size(), sticks_out > 0.5 ? 1U : 0U);
    EXPECT_TRUE(sticks_out > 0.5 || report.ravelled.size() == 1);
  }
}

}  // namespace
}  // namespace knitmech::contact
