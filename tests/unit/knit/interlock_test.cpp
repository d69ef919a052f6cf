#include "knit/interlock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/errors.h"
#include "example_loop.h"

namespace knitmech::knit {
namespace {

using testing::HasSubstr;

Erc example_erc() {
  return make_erc(example_loop());
}

std::string complaint(const FabricLayout& layout) {
  try {
    check_interlock(make_erc(layout.loop), layout);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Interlock, HalfALoopOfJerseyCrossesTheNextCourseTwice) {
  // Given plain jersey, the upper course passes in front of the lower one's head and behind its leg.
  const auto crossings = plan_crossings(example_erc(), 5, kCrossingPieces);
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_LT(crossings[0].lead, 0);
  EXPECT_GT(crossings[1].lead, 0);
  EXPECT_TRUE(courses_interlock(example_erc(), 5));
}

TEST(Interlock, LeadOnTheTrueCurveIsThatOfTwoParabolas) {
  // z = -p y^2 and z = -p (y - T)^2 differ by p T (T - 2 y).
  const Erc erc = example_erc();
  for (const PlanCrossing& crossing : plan_crossings(erc, 5, 1000)) {
    const double y = point_at_arc_length(erc, crossing.arc_length).position.y();
    EXPECT_NEAR(crossing.lead, 5 * (5 - 2 * y), 1e-2);
  }
}

TEST(Interlock, DoesNotDependOnTheDepthOfTheLoop) {
  LoopShape flat = example_loop();
  flat.out_of_plane = 0;
  EXPECT_TRUE(courses_interlock(make_erc(flat), 5));
}

TEST(Interlock, CoursesFurtherApartThanALoopIsHighDoNot) {
  EXPECT_TRUE(plan_crossings(example_erc(), 7.5, kCrossingPieces).empty());
  EXPECT_FALSE(courses_interlock(example_erc(), 7.5));
}

TEST(Interlock, EndsSomewhatBelowTheHeightOfTheLoop) {
  // Given round heads and feet, half a stitch apart, T = 6.9 mm is less than H = 7 mm, yet nothing crosses.
  EXPECT_FALSE(courses_interlock(example_erc(), 6.9));
}

TEST(Interlock, ComplaintNamesASpacingThatWouldDo) {
  FabricLayout layout = example_layout();
  layout.course_spacing = 8;
  EXPECT_THAT(complaint(layout), HasSubstr("fabric.course_spacing 8 mm"));
  EXPECT_THAT(complaint(layout), HasSubstr("loop.height 7 mm"));
  const auto limit = largest_interlocking_spacing(example_erc(), 8);
  ASSERT_TRUE(limit);
  EXPECT_LT(*limit, 7);
  EXPECT_GT(*limit, 5);
  EXPECT_TRUE(courses_interlock(example_erc(), *limit));
}

TEST(Interlock, CoursesThatReachThroughTheOneAfterNextAreNoJersey) {
  // Given T = 3 mm, the loops of 7 mm would hold those of the second course above as well.
  FabricLayout layout = example_layout();
  layout.course_spacing = 3;
  EXPECT_THAT(complaint(layout), HasSubstr("course after next"));
  EXPECT_THAT(complaint(layout), HasSubstr("fabric.course_spacing 3.175 mm or more"));
  layout.course_spacing = 3.175;
  EXPECT_EQ(complaint(layout), "");
  layout.course_spacing = 3;
  layout.courses = 2;
  EXPECT_EQ(complaint(layout), "");
}

TEST(Interlock, ElementsTooCoarseForItAreReported) {
  // Given one element per half loop, the courses are zigzag lines that cross elsewhere.
  FabricLayout layout = example_layout();
  layout.elements_per_erc = 1;
  EXPECT_THAT(complaint(layout), HasSubstr("fabric.elements_per_erc"));
}

TEST(Interlock, StandardMeshesAndASingleCoursePass) {
  FabricLayout layout = example_layout();
  for (const int n : {10, 20, 30}) {
    layout.elements_per_erc = n;
    EXPECT_EQ(complaint(layout), "");
  }
  layout.courses = 1;
  layout.course_spacing = 8;
  EXPECT_EQ(complaint(layout), "");
}

}  // namespace
}  // namespace knitmech::knit
