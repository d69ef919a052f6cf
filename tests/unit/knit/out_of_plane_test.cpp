#include "knit/out_of_plane.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "base/errors.h"
#include "example_loop.h"
#include "knit/check_fabric.h"
#include "knit/constants.h"

namespace knitmech::knit {
namespace {

TEST(OutOfPlane, FirstEstimateIsThatOfACrossingAtTheRim) {
  EXPECT_NEAR(estimated_out_of_plane(example_layout(), kExampleDiameter), 0.12 / (5 * 2), 1e-16);
}

class LeastOutOfPlane : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(StandardMeshes, LeastOutOfPlane, testing::Values(10, 20, 30));

TEST_P(LeastOutOfPlane, IsTheEdgeOfOverlap) {
  FabricLayout layout = example_layout();
  layout.elements_per_erc = GetParam();
  const double least = least_out_of_plane(layout, kExampleDiameter, 0).value();
  EXPECT_GE(gap_between_courses(layout, kExampleDiameter, least), 0);
  EXPECT_LT(gap_between_courses(layout, kExampleDiameter, 0.9999 * least), 0);
  // A crossing lies inwards of the rim, so that the estimate is somewhat low.
  const double estimate = estimated_out_of_plane(layout, kExampleDiameter);
  EXPECT_GT(least, estimate);
  EXPECT_LT(least, 1.5 * estimate);
}

TEST_P(LeastOutOfPlane, OfTheExampleAllowsTheUsualValue) {
  FabricLayout layout = example_layout();
  layout.elements_per_erc = GetParam();
  EXPECT_LT(least_out_of_plane(layout, kExampleDiameter, 0).value(), 0.02);
}

TEST_P(LeastOutOfPlane, AutomaticLeavesTheSmallGapAndPassesTheChecks) {
  FabricLayout layout = example_layout();
  layout.elements_per_erc = GetParam();
  layout.loop.out_of_plane = automatic_out_of_plane(layout, kExampleDiameter);
  const double gap = gap_between_courses(layout, kExampleDiameter, layout.loop.out_of_plane);
  EXPECT_NEAR(gap, kAutomaticGap * kExampleDiameter, 1e-6);
  EXPECT_NO_THROW(check_fabric(layout, kExampleDiameter));
}

TEST(OutOfPlane, GrowsWithTheYarn) {
  const FabricLayout layout = example_layout();
  const double thin = automatic_out_of_plane(layout, 0.06);
  const double usual = automatic_out_of_plane(layout, 0.12);
  const double thick = automatic_out_of_plane(layout, 0.24);
  EXPECT_LT(thin, usual);
  EXPECT_LT(usual, thick);
}

TEST(OutOfPlane, IsTheSameForAPatchAndAHugeFabric) {
  FabricLayout huge = example_layout();
  huge.wales = 300;
  huge.courses = 300;
  EXPECT_EQ(automatic_out_of_plane(huge, kExampleDiameter), automatic_out_of_plane(example_layout(), kExampleDiameter));
}

TEST(OutOfPlane, ASingleCourseStaysFlat) {
  FabricLayout layout = example_layout();
  layout.courses = 1;
  EXPECT_EQ(automatic_out_of_plane(layout, kExampleDiameter), 0);
  EXPECT_EQ(gap_between_courses(layout, kExampleDiameter, 0), std::numeric_limits<double>::infinity());
}

TEST(OutOfPlane, ThereIsNoneForYarnAsThickAsTheLoop) {
  // Given yarn of 1.9 mm in a loop of 7 mm that could be 7 mm deep, the loops stay too narrow for it in plan.
  EXPECT_FALSE(least_out_of_plane(example_layout(), 1.9, 0));
  try {
    (void)required_out_of_plane(example_layout(), 1.9, 0);
    FAIL() << "no complaint";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("fabric.course_spacing"));
    EXPECT_THAT(error.what(), testing::HasSubstr("yarn.diameter"));
  }
}

TEST(OutOfPlane, ThereIsNoneForCoursesThatDoNotInterlock) {
  FabricLayout layout = example_layout();
  layout.course_spacing = 7;
  EXPECT_THROW((void)automatic_out_of_plane(layout, kExampleDiameter), InputError);
}

}  // namespace
}  // namespace knitmech::knit
