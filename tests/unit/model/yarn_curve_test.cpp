#include "model/yarn_curve.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "../../support/straight_yarn.h"

namespace knitmech::model {
namespace {

using Eigen::Vector3d;

/// A quarter circle of radius 1 mm in the x-y plane with one element, straight along x at rest.
struct QuarterCircle {
  Model model;
  Frame frame;

  QuarterCircle() {
    const double length = std::numbers::pi / 2;
    model.sections = {yarn::Section{.diameter = 0.1}};
    model.yarns = {{.first_node = 0, .n_nodes = 2}};
    model.element_section = {0, 0};
    model.nodes = {Vector3d::Zero(), Vector3d(length, 0, 0)};
    model.tangents = {Vector3d::UnitX(), Vector3d::UnitX()};
    model.arc_length = {0, length};
    frame = test::undeformed(model);
    frame.points[1] = {1, 1, 0};
    frame.rotations[1] = {std::cos(std::numbers::pi / 4), 0, 0, std::sin(std::numbers::pi / 4)};
  }
};

TEST(YarnCurve, FollowsTheCircleThatTheTurnedTangentsAskFor) {
  const QuarterCircle circle;
  const std::vector<CurvePiece> pieces = yarn_curves(circle.model, circle.frame);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_DOUBLE_EQ(pieces[0].radius, 0.05);
  // A cubic Hermite curve over a quarter circle stays within 2 % of its radius; the chord would be 29 % off.
  for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    EXPECT_NEAR((pieces[0].point(u) - Vector3d(0, 1, 0)).norm(), 1, 0.02) << u;
  }
  EXPECT_TRUE(pieces[0].tangent(0).isApprox(Vector3d::UnitX(), 1e-12));
  EXPECT_TRUE(pieces[0].tangent(1).isApprox(Vector3d::UnitY(), 1e-12));
}

TEST(YarnCurve, TheTangentIsTheDerivativeOfThePoint) {
  const QuarterCircle circle;
  const CurvePiece piece = yarn_curves(circle.model, circle.frame).front();
  constexpr double kStep = 1e-6;
  for (const double u : {0.1, 0.37, 0.8}) {
    const Vector3d difference = (piece.point(u + kStep) - piece.point(u - kStep)).normalized();
    EXPECT_TRUE(piece.tangent(u).isApprox(difference, 1e-8));
  }
}

TEST(YarnCurve, TheSecondDerivativeIsThatOfThePoint) {
  const QuarterCircle circle;
  const CurvePiece piece = yarn_curves(circle.model, circle.frame).front();
  constexpr double kStep = 1e-3;  // a central difference is exact for a cubic, but for rounding
  for (const double u : {0.0, 0.37, 1.0}) {
    const Vector3d difference = piece.point(u + kStep) - 2 * piece.point(u) + piece.point(u - kStep);
    EXPECT_TRUE(piece.second_derivative(u).isApprox(difference / (kStep * kStep), 1e-8)) << u;
  }
}

TEST(YarnCurve, OfTheModelIsThatOfItsUndeformedFrame) {
  const QuarterCircle circle;
  const CurvePiece start = yarn_curves(circle.model).at(0);
  const CurvePiece undeformed = yarn_curves(circle.model, test::undeformed(circle.model)).at(0);
  for (const double u : {0.0, 0.3, 1.0}) EXPECT_TRUE(start.point(u).isApprox(undeformed.point(u), 1e-15)) << u;
  EXPECT_EQ(start.end, Vector3d(std::numbers::pi / 2, 0, 0));
  EXPECT_DOUBLE_EQ(start.radius, 0.05);
}

TEST(YarnCurve, LeavesOutElementsWithoutAKnownPosition) {
  const Model model = test::straight_yarn();
  Frame frame = test::undeformed(model);
  frame.points[5].x() = std::numeric_limits<double>::quiet_NaN();
  const std::vector<CurvePiece> pieces = yarn_curves(model, frame);
  ASSERT_EQ(pieces.size(), 8U) << "ten, less the two at node 5";
  EXPECT_EQ(pieces[3].node, 3);
  EXPECT_TRUE(pieces[3].continues_piece_before);
  EXPECT_EQ(pieces[4].node, 6);
  EXPECT_FALSE(pieces[4].continues_piece_before);
}

TEST(YarnCurve, LeavesOutElementsThatHaveBroken) {
  const Model model = test::straight_yarn();
  Frame frame = test::undeformed(model);
  frame.broken = {3, 7};
  const std::vector<CurvePiece> pieces = yarn_curves(model, frame);
  ASSERT_EQ(pieces.size(), 8U);
  EXPECT_EQ(pieces[2].node, 2);
  EXPECT_EQ(pieces[3].node, 4);
  EXPECT_FALSE(pieces[3].continues_piece_before);
  EXPECT_EQ(pieces[6].node, 8);
  EXPECT_FALSE(pieces[6].continues_piece_before);
}

}  // namespace
}  // namespace knitmech::model
