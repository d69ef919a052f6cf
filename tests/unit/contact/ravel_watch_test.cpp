#include "contact/ravel_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "watched_yarns.h"

namespace knitmech::contact {
namespace {

using Eigen::Vector3d;

constexpr double kD = kDiameter;
constexpr double kPi = std::numbers::pi;

/// Elements per 20 D of yarn.
class RavelWatchOnMeshes : public testing::TestWithParam<int> {
 protected:
  /// A straight yarn along x, its last node at an x [D].
  static std::vector<Vector3d> yarn_to(double x, double y = 0, double z = 0) {
    return test::straight(in_diameters(x - 20, y, z), in_diameters(x, y, z), GetParam());
  }
  /// A straight yarn along y at an x, a diameter above the first [D].
  static std::vector<Vector3d> across(double x) {
    return test::straight(in_diameters(x, -10, 1), in_diameters(x, 10, 1), GetParam());
  }
  /// A hook about the origin, in the plane x = 0: it comes from z = -10, passes over the yarn and goes back.
  static std::vector<Vector3d> hook() {
    std::vector<Vector3d> nodes = test::straight(in_diameters(0, -1.1, -10), in_diameters(0, -1.1, 0), GetParam() / 2);
    const auto arc = [](double p) { return in_diameters(0, -1.1 * std::cos(p), 1.1 * std::sin(p)); };
    const auto bight = drawn(arc, 0, kPi, GetParam());
    nodes.insert(nodes.end(), bight.begin() + 1, bight.end());
    const auto back = test::straight(in_diameters(0, 1.1, 0), in_diameters(0, 1.1, -10), GetParam() / 2);
    nodes.insert(nodes.end(), back.begin() + 1, back.end());
    return nodes;
  }
};
INSTANTIATE_TEST_SUITE_P(Elements, RavelWatchOnMeshes, testing::Values(4, 12, 40));

void expect_nothing(const CrossingReport& report) {
  EXPECT_TRUE(report.lost.empty());
  EXPECT_TRUE(report.ravelled.empty());
}

TEST_P(RavelWatchOnMeshes, GivenAnEndPulledOutOfAHook_ThenThatIsOneEventAtTheHookAndNoLoss) {
  WatchedYarns yarns({yarn_to(8), hook()});
  const CrossingReport held = yarns.move_along(shift_along(0, in_diameters(-8, 0, 0)), 50);
  expect_nothing(held);
  const auto further = [](double share) { return shift_yarn(0, in_diameters(-8 - 4 * share, 0, 0)); };
  const CrossingReport report = yarns.move_along(further, 25);
  EXPECT_TRUE(report.lost.empty());
  ASSERT_EQ(report.ravelled.size(), 1U);
  const RavelEvent& event = report.ravelled[0];
  EXPECT_EQ(event.yarn, 0);
  EXPECT_EQ(event.end, YarnEnd::last_node);
  EXPECT_EQ(event.other_yarn, 1);
  EXPECT_LT(std::abs(event.place.x), 0.1 * kD);
  EXPECT_LT(std::hypot(event.place.y, event.place.z), 1.2 * kD);
  // The bight's arc, whose every point is equally near.
  EXPECT_GT(event.arc_length, 9.9 * kD);
  EXPECT_LT(event.arc_length, (10.1 + 1.1 * kPi) * kD);
}

TEST_P(RavelWatchOnMeshes, GivenAnEndDrawnUnderAYarnAtARightAngle_ThenTheEventComesWithinADiameterBehindIt) {
  for (const bool first : {false, true}) {
    std::vector<Vector3d> yarn = yarn_to(5);
    if (first) std::reverse(yarn.begin(), yarn.end());
    WatchedYarns yarns({yarn, across(0)});
    for (int i = 1; i <= 50; ++i) {
      const double end = 5 - 0.15 * i;
      const CrossingReport report = yarns.move(shift_yarn(0, in_diameters(end - 5, 0, 0)));
      EXPECT_TRUE(report.lost.empty());
      if (report.ravelled.empty()) continue;
      EXPECT_LT(end, 0);
      EXPECT_GT(end, -1);
      EXPECT_EQ(report.ravelled[0].end, first ? YarnEnd::first_node : YarnEnd::last_node);
      EXPECT_NEAR(report.ravelled[0].arc_length, 10 * kD, 1e-9);
      EXPECT_NEAR(report.ravelled[0].place.z, kD, 1e-9);
      return;
    }
    ADD_FAILURE() << "no event";
  }
}

TEST_P(RavelWatchOnMeshes, GivenAnEndThatSlipsBackAndOffAgain_ThenItIsReportedOnce) {
  WatchedYarns yarns({yarn_to(4), across(0)});
  const auto to_and_fro = [](double share) {
    return shift_yarn(0, in_diameters(-4 + 4 * std::cos(6 * kPi * share), 0, 0));
  };
  EXPECT_EQ(yarns.move_along(to_and_fro, 400).ravelled.size(), 1U);
}

TEST_P(RavelWatchOnMeshes, GivenAnEndDrawnUnderThreeYarnsAndTwoPlacesOfOne_ThenEveryPlaceIsAnEvent) {
  // The last of them turns back and lies over the tail a second time.
  std::vector<Vector3d> twice = across(-8);
  const auto back = across(-12);
  twice.insert(twice.end(), back.rbegin(), back.rend());
  WatchedYarns yarns({yarn_to(4), across(0), across(-4), twice});
  const CrossingReport report = yarns.move_along(shift_along(0, in_diameters(-18, 0, 0)), 100);
  EXPECT_TRUE(report.lost.empty());
  ASSERT_EQ(report.ravelled.size(), 4U);
  const std::vector<int> others{1, 2, 3, 3};
  const std::vector<double> places{10, 10, 10, 34};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(report.ravelled[i].other_yarn, others[i]);
    EXPECT_NEAR(report.ravelled[i].arc_length, places[i] * kD, 1e-6);
  }
}

TEST_P(RavelWatchOnMeshes, GivenATailNearAnotherYarnOverALongStretch_ThenTheirCrossingIsOneEvent) {
  const double angle = 25 * kPi / 180;
  const auto leaning = [&](double s) { return in_diameters(s * std::cos(angle), s * std::sin(angle), 1); };
  WatchedYarns crossing({yarn_to(6), drawn(leaning, -10, 10, GetParam())});
  EXPECT_EQ(crossing.move_along(shift_along(0, in_diameters(-14, 0, 0)), 80).ravelled.size(), 1U);
}

TEST_P(RavelWatchOnMeshes, GivenTwoNearPlacesOfOneCrossingThatBecomeOne_ThenItIsOneEvent) {
  // A yarn along x that comes down on both sides of the crossing and is then straightened.
  const auto wavy = [](double share) -> Motion {
    return [=](std::size_t yarn, const Vector3d& x) -> Vector3d {
      return yarn == 0 ? x : Vector3d(x.x(), 0, kD * (1 + 0.5 * (1 - share) * std::cos(kPi * x.x() / (2 * kD))));
    };
  };
  const Vector3d along = in_diameters(std::cos(kPi / 6), std::sin(kPi / 6), 0);
  std::vector<Vector3d> other = test::straight(in_diameters(-10, 0, 0), in_diameters(10, 0, 0), 80);
  for (Vector3d& node : other) node = wavy(0)(1, node);
  WatchedYarns yarns({test::straight(-16 * along, 4 * along, GetParam()), other});
  expect_nothing(yarns.move_along(wavy, 10));
  const auto drawn_out = [&](double share) -> Motion {
    return [=](std::size_t yarn, const Vector3d& x) -> Vector3d {
      return yarn == 0 ? Vector3d(x - 6 * share * along) : Vector3d(x.x(), 0, kD);
    };
  };
  EXPECT_EQ(yarns.move_along(drawn_out, 40).ravelled.size(), 1U);
}

TEST_P(RavelWatchOnMeshes, GivenALoopPulledOffATailSideways_WhenTheEndIsDrawnPastItAfterwards_ThenThereIsNoEvent) {
  const auto arc = [](double p) { return in_diameters(-3 + 3 * std::cos(p), 3 * std::sin(p), 1); };
  WatchedYarns yarns({yarn_to(3), drawn(arc, -0.3, kPi + 0.3, 40)});
  expect_nothing(yarns.move_along(shift_along(1, in_diameters(0, -2.6, 0)), 20));
  const auto drawn_back = [&](double share) -> Motion {
    return [=](std::size_t yarn, const Vector3d& x) -> Vector3d {
      return x + (yarn == 0 ? in_diameters(-7 * share, 0, 0) : in_diameters(0, -2.6, 0));
    };
  };
  expect_nothing(yarns.move_along(drawn_back, 50));
}

TEST_P(RavelWatchOnMeshes, GivenAnEndThatLiesBesideAYarn_WhenItSlidesAlongIt_ThenThereIsNoEvent) {
  for (const double degrees : {0.0, 5.0}) {
    const double angle = degrees * kPi / 180;
    const auto leaning = [&](double s) { return in_diameters(s * std::cos(angle), s * std::sin(angle), 1); };
    WatchedYarns yarns({yarn_to(5), drawn(leaning, -10, 10, GetParam())});
    expect_nothing(yarns.move_along(shift_along(0, in_diameters(-18, 0, 0)), 100));
  }
}

TEST_P(RavelWatchOnMeshes, GivenAnEndThatJustReachesAYarn_WhenItIsDrawnBack_ThenThereIsNoEvent) {
  WatchedYarns yarns({yarn_to(0.3), across(0)});
  expect_nothing(yarns.move_along(shift_along(0, in_diameters(-3, 0, 0)), 20));
}

TEST_P(RavelWatchOnMeshes, GivenAYarnLiftedOffATail_ThenThereIsNoEvent) {
  WatchedYarns yarns({yarn_to(2), across(0)});
  expect_nothing(yarns.move_along(shift_along(1, in_diameters(0, 0, 6)), 40));
  // Nor is there one when the tail is drawn back under a yarn that it no longer touches.
  WatchedYarns loose({yarn_to(2), across(0)});
  expect_nothing(loose.move_along(shift_along(1, in_diameters(0, 0, 1.5)), 10));
  const auto drawn_back = [](double share) -> Motion {
    return [=](std::size_t yarn, const Vector3d& x) -> Vector3d {
      return x + (yarn == 0 ? in_diameters(-4 * share, 0, 0) : in_diameters(0, 0, 1.5));
    };
  };
  expect_nothing(loose.move_along(drawn_back, 30));
}

TEST_P(RavelWatchOnMeshes, GivenATailDrawnFromUnderItsOwnYarn_ThenItIsAnEventOfThatYarnWithItself) {
  // A loop that crosses over itself at p = 3.754 and -0.612; the yarn is drawn back along itself. It is some 40 D long,
  // or hardly longer than the tail that is watched.
  for (const double size : {1.0, 0.2}) {
    const auto loop = [=](double p) {
      return in_diameters(size * (8 * std::cos(p) + 3 * p), size * 8 * std::sin(p), p > 2 ? 1 : 0);
    };
    const auto at = [&](double back) {
      return drawn(loop, -2.5 - back / size, 3.754 + (0.3 - back) / size, 3 * GetParam());
    };
    const std::vector<Vector3d> start = at(0);
    WatchedYarns yarns({start});
    const auto drawn_back = [&](double share) -> Motion {
      const std::vector<Vector3d> now = at(0.5 * share);
      return [=](std::size_t, const Vector3d& x) -> Vector3d {
        return now[static_cast<std::size_t>(std::find(start.begin(), start.end(), x) - start.begin())];
      };
    };
    const CrossingReport report = yarns.move_along(drawn_back, 50);
    EXPECT_TRUE(report.lost.empty());
    ASSERT_EQ(report.ravelled.size(), 1U);
    EXPECT_EQ(report.ravelled[0].yarn, 0);
    EXPECT_EQ(report.ravelled[0].end, YarnEnd::last_node);
    EXPECT_EQ(report.ravelled[0].other_yarn, 0);
  }
}

}  // namespace
}  // namespace knitmech::contact
