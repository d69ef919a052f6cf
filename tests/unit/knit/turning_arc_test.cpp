#include "knit/turning_arc.h"

#include <gtest/gtest.h>

#include <numbers>

#include "example_loop.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector2d;

/// The example with another course spacing T [mm]; l2 = 0.2 mm and R2 = 1 mm stay.
TurningArc arc_at_spacing(double course_spacing) {
  FabricLayout layout = example_layout();
  layout.course_spacing = course_spacing;
  return make_turning_arc(layout);
}

TEST(TurningArc, GivenTheExample_ThenItIsAsLongAsItsFiveStraightAndRoundPieces) {
  // 2 l2 + 2 (pi / 2) R2 + (T - 2 R2) = 0.4 + pi + 3 mm.
  const TurningArc arc = arc_at_spacing(5);
  EXPECT_NEAR(arc.length, 0.4 + std::numbers::pi + 3, 1e-14);
  EXPECT_EQ(arc.radius, 1);
  EXPECT_EQ(arc.leg, 3);
}

TEST(TurningArc, GivenCoursesCloserThanTwoFootRadii_ThenItsRadiusIsHalfTheSpacingAndItHasNoLeg) {
  const TurningArc arc = arc_at_spacing(1.6);
  EXPECT_EQ(arc.radius, 0.8);
  EXPECT_EQ(arc.leg, 0);
  EXPECT_NEAR(arc.length, 0.4 + std::numbers::pi * 0.8, 1e-14);
}

class TurningArcAt : public testing::TestWithParam<double> {
 protected:
  const double spacing_ = GetParam();
  const TurningArc arc_ = arc_at_spacing(spacing_);
};
INSTANTIATE_TEST_SUITE_P(Spacings, TurningArcAt, testing::Values(0.5, 1.6, 2.0, 3.3, 5.0, 20.0));

TEST_P(TurningArcAt, LeadsFromOneFootToTheFootAboveAndLeavesAndEntersAlongTheCourse) {
  const ArcPoint start = point_on(arc_, 0);
  const ArcPoint end = point_on(arc_, arc_.length);
  EXPECT_LT((start.position - Vector2d(0, 0)).norm(), 1e-14);
  EXPECT_LT((start.tangent - Vector2d(1, 0)).norm(), 1e-14);
  EXPECT_LT((end.position - Vector2d(0, spacing_)).norm(), 1e-14);
  EXPECT_LT((end.tangent - Vector2d(-1, 0)).norm(), 1e-14);
}

TEST_P(TurningArcAt, IsSmoothAndParametrisedByItsLength) {
  // A curve of curvature up to k leaves its tangent by at most k h^2 / 2 over the length h, and turns by at most k h.
  const int n = 5000;
  const double h = arc_.length / n;
  for (int i = 0; i < n; ++i) {
    const ArcPoint here = point_on(arc_, i * h);
    const ArcPoint next = point_on(arc_, (i + 1) * h);
    ASSERT_NEAR(here.tangent.norm(), 1, 1e-14);
    ASSERT_LE((next.position - here.position - h * here.tangent).norm(), h * h / (2 * arc_.radius) + 1e-13) << i;
    ASSERT_LE((next.tangent - here.tangent).norm(), h / arc_.radius + 1e-13) << i;
  }
}

TEST_P(TurningArcAt, LiesOutsideTheFabricAndIsItsOwnMirrorImage) {
  for (int i = 0; i <= 1000; ++i) {
    const double s = arc_.length * i / 1000;
    const ArcPoint here = point_on(arc_, s);
    const ArcPoint mirror = point_on(arc_, arc_.length - s);
    EXPECT_GE(here.position.x(), -1e-14);
    EXPECT_LE(here.position.x(), 0.2 + arc_.radius + 1e-14);
    EXPECT_NEAR(here.position.x(), mirror.position.x(), 1e-13);
    EXPECT_NEAR(here.position.y() + mirror.position.y(), spacing_, 1e-13);
  }
  EXPECT_NEAR(point_on(arc_, arc_.length / 2).position.x(), 0.2 + arc_.radius, 1e-14);
}

TEST(TurningArc, ItsElementsAreAsLongAsThoseOfTheStitchesAsNearlyAsAWholeNumberAllows) {
  const TurningArc arc = arc_at_spacing(5);
  const double erc_length = 8.64887592209499603;
  for (const int n : {10, 20, 30, 40}) {
    const int count = count_arc_elements(arc, erc_length, n);
    EXPECT_LE(std::abs(arc.length / (erc_length / n) - count), 0.5) << "N = " << n;
  }
}

TEST(TurningArc, HasFourElementsAtLeast) {
  EXPECT_EQ(count_arc_elements(arc_at_spacing(0.5), 8.6, 4), 4);
}

}  // namespace
}  // namespace knitmech::knit
