#include "knit/erc.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "example_loop.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Erc erc_with_out_of_plane(double p) {
  LoopShape shape = example_loop();
  shape.out_of_plane = p;
  return make_erc(shape);
}

void expect_near(const Vector2d& point, double x, double y) {
  EXPECT_NEAR(point.x(), x, 1e-14);
  EXPECT_NEAR(point.y(), y, 1e-14);
}

TEST(Erc, ControlPointsOfTheExampleAreThoseOfTheInnerCommonTangent) {
  // Given the example loop, whose tangent points were computed from the same geometry with 30 digits,
  const Erc erc = make_erc(example_loop());
  const auto& p = erc.control_points;
  // then P1 to P8 are:
  expect_near(p[0], 0, 3.5);
  expect_near(p[1], 0.2, 3.5);
  expect_near(p[2], 1.29278854120091245, 2.27424943650232945);
  expect_near(p[3], 0.75655587163553414, -2.38568130591120859);
  expect_near(p[4], 1.75, -3.5);
  expect_near(p[5], 1.95, -3.5);
  expect_near(p[6], 0.2, 2.4);
  expect_near(p[7], 1.75, -2.5);
  EXPECT_NEAR(erc.theta1, 1.68536549740503407, 1e-14);
  EXPECT_EQ(erc.theta2, erc.theta1);
}

TEST(Erc, LegTouchesBothCirclesAtRightAnglesToTheirRadii) {
  const Erc erc = make_erc(example_loop());
  const auto& p = erc.control_points;
  const Vector2d leg = (p[3] - p[2]).normalized();
  EXPECT_NEAR((p[2] - p[6]).norm(), erc.shape.head_radius, 1e-14);
  EXPECT_NEAR((p[3] - p[7]).norm(), erc.shape.foot_radius, 1e-14);
  EXPECT_NEAR((p[2] - p[6]).dot(leg), 0, 1e-14);
  EXPECT_NEAR((p[3] - p[7]).dot(leg), 0, 1e-14);
  EXPECT_NEAR(std::atan2(-leg.y(), leg.x()), erc.theta1, 1e-14);
}

TEST(Erc, FlatLoopHasTheLengthOfItsFivePieces) {
  // Given p = 0, the length is l1 + R1 theta + sqrt(|d|^2 - (R1 + R2)^2) + R2 theta + l2.
  const Erc erc = erc_with_out_of_plane(0);
  const double d_squared = 1.55 * 1.55 + 4.9 * 4.9;
  const double leg = std::sqrt(d_squared - 2.1 * 2.1);
  EXPECT_NEAR(erc.length, 0.4 + 2.1 * erc.theta1 + leg, 1e-13);
  EXPECT_NEAR(erc.plan_start.back(), erc.length, 1e-13);
}

TEST(Erc, SpaceCurveHasTheLengthOfIndependentQuadrature) {
  // Reference: adaptive quadrature of sqrt(1 + (2 p y y')^2) over the pieces with 30 digits.
  EXPECT_NEAR(erc_with_out_of_plane(0.02).length, 8.64887592209499603, 2e-14);
  EXPECT_NEAR(erc_with_out_of_plane(0.2).length, 10.2639268456679096, 4e-14);
}

class ErcPoints : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(OutOfPlane, ErcPoints, testing::Values(0.0, 0.02, 0.3));

TEST_P(ErcPoints, StartAtTheHeadMiddleAndEndAtTheFootMiddle) {
  const Erc erc = erc_with_out_of_plane(GetParam());
  const double back = -GetParam() * 3.5 * 3.5;
  EXPECT_LT((point_at_arc_length(erc, 0).position - Vector3d(0, 3.5, back)).norm(), 1e-14);
  EXPECT_LT((point_at_arc_length(erc, erc.length).position - Vector3d(1.95, -3.5, back)).norm(), 1e-14);
  EXPECT_LT((point_at_arc_length(erc, 0).tangent - Vector3d::UnitX()).norm(), 1e-14);
  EXPECT_LT((point_at_arc_length(erc, erc.length).tangent - Vector3d::UnitX()).norm(), 1e-14);
}

TEST_P(ErcPoints, ArcLengthOutsideIsMovedToTheNearerEnd) {
  const Erc erc = erc_with_out_of_plane(GetParam());
  EXPECT_EQ(point_at_arc_length(erc, -1).position, point_at_arc_length(erc, 0).position);
  EXPECT_EQ(point_at_arc_length(erc, erc.length + 1).position, point_at_arc_length(erc, erc.length).position);
}

TEST_P(ErcPoints, ArcLengthAndPlanLengthAreInverseToRounding) {
  const Erc erc = erc_with_out_of_plane(GetParam());
  for (int i = 0; i <= 1000; ++i) {
    const double arc = erc.length * i / 1000;
    EXPECT_NEAR(arc_length_at(erc, plan_length_at(erc, arc)), arc, 1e-14);
  }
}

TEST_P(ErcPoints, LieOnTheParabolicCylinder) {
  const Erc erc = erc_with_out_of_plane(GetParam());
  for (const CurvePoint& at : equal_arc_points(erc, 37)) {
    EXPECT_NEAR(at.position.z(), -GetParam() * at.position.y() * at.position.y(), 1e-15);
    EXPECT_NEAR(at.tangent.norm(), 1, 1e-14);
  }
}

TEST_P(ErcPoints, TangentIsTheDerivativeAndCurvatureThatOfTheTangent) {
  // Central differences over 2e-5 mm, away from the ends of the pieces, are exact to about 1e-9 and 1e-8.
  const Erc erc = erc_with_out_of_plane(GetParam());
  const double h = 1e-5;
  for (const double share : {0.01, 0.1, 0.15, 0.4, 0.6, 0.85, 0.9, 0.99}) {
    const double arc = share * erc.length;
    const CurvePoint before = point_at_arc_length(erc, arc - h);
    const CurvePoint at = point_at_arc_length(erc, arc);
    const CurvePoint after = point_at_arc_length(erc, arc + h);
    EXPECT_LT(((after.position - before.position) / (2 * h) - at.tangent).norm(), 1e-8) << share;
    EXPECT_NEAR(((after.tangent - before.tangent) / (2 * h)).norm(), at.curvature, 1e-8) << share;
  }
}

TEST(Erc, CurvatureInPlanIsThatOfFlatsCirclesAndLeg) {
  const Erc erc = erc_with_out_of_plane(0);
  EXPECT_NEAR(point_at_arc_length(erc, 0.1).curvature, 0, 1e-15);
  EXPECT_NEAR(point_at_arc_length(erc, 1.0).curvature, 1 / 1.1, 1e-14);
  EXPECT_NEAR(point_at_arc_length(erc, 4.0).curvature, 0, 1e-14);
  EXPECT_NEAR(point_at_arc_length(erc, erc.length - 1.0).curvature, 1 / 1.0, 1e-14);
}

TEST(Erc, PointsOfEqualArcCutItIntoEqualPieces) {
  const Erc erc = make_erc(example_loop());
  const auto points = equal_arc_points(erc, 10);
  ASSERT_EQ(points.size(), 11U);
  for (int i = 0; i <= 10; ++i) {
    const Vector3d expected = point_at_arc_length(erc, erc.length * i / 10).position;
    EXPECT_LT((points[static_cast<std::size_t>(i)].position - expected).norm(), 1e-14);
  }
}

TEST(Erc, PiecesFollowEachOtherInTheOrderOfTheYarn) {
  const Erc erc = make_erc(example_loop());
  EXPECT_EQ(piece_at_arc_length(erc, 0.1), ErcPiece::head_flat);
  EXPECT_EQ(piece_at_arc_length(erc, 1.0), ErcPiece::head_arc);
  EXPECT_EQ(piece_at_arc_length(erc, 4.0), ErcPiece::leg);
  EXPECT_EQ(piece_at_arc_length(erc, erc.length - 1), ErcPiece::foot_arc);
  EXPECT_EQ(piece_at_arc_length(erc, erc.length - 0.1), ErcPiece::foot_flat);
}

TEST(Erc, LoopWithoutFlatsIsTwoArcsAndALeg) {
  LoopShape shape = example_loop();
  shape.head_flat = 0;
  shape.foot_flat = 0;
  shape.out_of_plane = 0;
  const Erc erc = make_erc(shape);
  const double d_squared = 1.95 * 1.95 + 4.9 * 4.9;
  EXPECT_NEAR(erc.length, 2.1 * erc.theta1 + std::sqrt(d_squared - 2.1 * 2.1), 1e-13);
  EXPECT_LT((point_at_arc_length(erc, erc.length).position - Vector3d(1.95, -3.5, 0)).norm(), 1e-14);
}

TEST(Erc, EqualCirclesOneAboveTheOtherGiveAPointSymmetricLoop) {
  // Given R1 = R2 and l1 = l2, the ERC turned by 180 degrees about its middle is itself.
  LoopShape shape = example_loop();
  shape.foot_radius = shape.head_radius;
  const Erc erc = make_erc(shape);
  for (int i = 0; i <= 20; ++i) {
    const Vector3d a = point_at_arc_length(erc, erc.length * i / 20).position;
    const Vector3d b = point_at_arc_length(erc, erc.length * (20 - i) / 20).position;
    EXPECT_NEAR(a.x() + b.x(), shape.width / 2, 1e-13);
    EXPECT_NEAR(a.y() + b.y(), 0, 1e-13);
    EXPECT_NEAR(a.z(), b.z(), 1e-13);
  }
}

}  // namespace
}  // namespace knitmech::knit
