#include "picture/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace knitmech::picture {
namespace {

using Eigen::Vector3d;

class EveryView : public testing::TestWithParam<View> {};

TEST_P(EveryView, HasRightHandedUnitAxes) {
  for (const double turn : {0.0, 33.0}) {
    const ViewAxes axes = axes_of(GetParam(), turn);
    EXPECT_NEAR((axes.right.cross(axes.up) - axes.towards_viewer).norm(), 0, 1e-15);
    EXPECT_NEAR(axes.right.norm(), 1, 1e-15);
    EXPECT_NEAR(axes.towards_viewer.norm(), 1, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryView,
                         testing::Values(View::front, View::back, View::side, View::top, View::oblique));

TEST(ViewAxes, ShowTheSideThatTheirNameSays) {
  EXPECT_EQ(axes_of(View::front).right, Vector3d(1, 0, 0));
  EXPECT_EQ(axes_of(View::back).right, Vector3d(-1, 0, 0));
  EXPECT_EQ(axes_of(View::back).up, Vector3d(0, 1, 0));
  EXPECT_EQ(axes_of(View::side).right, Vector3d(0, 0, -1)) << "the front is at the left";
  EXPECT_EQ(axes_of(View::top).right, Vector3d(1, 0, 0));
  EXPECT_EQ(axes_of(View::top).up, Vector3d(0, 0, -1)) << "the front is below";
}

TEST(ViewAxes, ATurnBringsTheFrontToTheRight) {
  // Given a point in front of the fabric.
  const Vector3d point(0, 0, 1);
  // When the fabric has turned by 90 degrees, then the point is at the right; by 180, behind; once round, where it was.
  EXPECT_NEAR(axes_of(View::front, 90).right.dot(point), 1, 1e-15);
  EXPECT_NEAR(axes_of(View::front, 180).towards_viewer.dot(point), -1, 1e-15);
  EXPECT_NEAR(axes_of(View::front, 360).towards_viewer.dot(point), 1, 1e-15);
}

TEST(Extent, AroundTwoEnclosesBoth) {
  const Extent extent = around({{0, 1, 2}, {3, 4, 5}}, {{-1, 2, 0}, {2, 9, 3}});
  EXPECT_EQ(extent.lowest, Vector3d(-1, 1, 0));
  EXPECT_EQ(extent.highest, Vector3d(3, 9, 5));
}

}  // namespace
}  // namespace knitmech::picture
