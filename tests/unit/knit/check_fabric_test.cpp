#include "knit/check_fabric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>

#include "base/errors.h"
#include "example_loop.h"
#include "knit/out_of_plane.h"

namespace knitmech::knit {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const FabricLayout& layout, double diameter = kExampleDiameter) {
  try {
    check_fabric(layout, diameter);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckFabric, AcceptsTheExampleAtEveryStandardMesh) {
  FabricLayout layout = example_layout();
  for (const int n : {10, 20, 30}) {
    layout.elements_per_erc = n;
    EXPECT_EQ(complaint(layout), "");
  }
}

TEST(CheckFabric, NamesCountsBelowOne) {
  FabricLayout layout = example_layout();
  layout.wales = 0;
  EXPECT_THAT(complaint(layout), HasSubstr("fabric.wales is 0"));
  layout = example_layout();
  layout.courses = -2;
  EXPECT_THAT(complaint(layout), HasSubstr("fabric.courses is -2"));
  layout = example_layout();
  layout.elements_per_erc = 0;
  EXPECT_THAT(complaint(layout), HasSubstr("fabric.elements_per_erc is 0"));
}

TEST(CheckFabric, NamesACourseSpacingThatIsNoLength) {
  FabricLayout layout = example_layout();
  for (const double spacing : {0.0, -5.0, std::numeric_limits<double>::infinity()}) {
    layout.course_spacing = spacing;
    EXPECT_THAT(complaint(layout), HasSubstr("fabric.course_spacing"));
  }
}

TEST(CheckFabric, CoursesThatDoNotInterlockAreReported) {
  FabricLayout layout = example_layout();
  layout.course_spacing = 7;
  EXPECT_THAT(complaint(layout), AllOf(HasSubstr("do not interlock"), HasSubstr("fabric.course_spacing 7 mm")));
}

TEST(CheckFabric, AnOverlapOfCoursesSaysHowMuchWhereAndTheLeastDepth) {
  FabricLayout layout = example_layout();
  layout.loop.out_of_plane = 0.01;
  EXPECT_THAT(complaint(layout),
              AllOf(HasSubstr("overlap by 0.04"), HasSubstr("course 1, wale 1"), HasSubstr("course 2, wale 1"),
                    HasSubstr("mm;"), HasSubstr("make loop.out_of_plane at least"), HasSubstr("instead of 0.01 /mm")));
}

TEST(CheckFabric, TheReportedLeastDepthPasses) {
  FabricLayout layout = example_layout();
  layout.loop.out_of_plane = 0;
  const std::string message = complaint(layout);
  const std::string before = "loop.out_of_plane at least ";
  const std::size_t start = message.find(before);
  ASSERT_NE(start, std::string::npos) << message;
  layout.loop.out_of_plane = std::strtod(message.c_str() + start + before.size(), nullptr);
  EXPECT_EQ(complaint(layout), "");
  layout.loop.out_of_plane *= 0.998;
  EXPECT_NE(complaint(layout), "");
}

TEST(CheckFabric, OverlapOfTheElementsAloneIsReportedAsThat) {
  // Given a depth between that of the true curve and that of ten elements, finer elements help as well.
  FabricLayout fine = example_layout();
  fine.elements_per_erc = 200;
  const double enough_for_curve = least_out_of_plane(fine, kExampleDiameter, 0).value();
  FabricLayout layout = example_layout();
  layout.loop.out_of_plane = 1.001 * enough_for_curve;
  EXPECT_THAT(complaint(layout), AllOf(HasSubstr("straight elements"), HasSubstr("loop.out_of_plane at least"),
                                       HasSubstr("fabric.elements_per_erc larger")));
}

TEST(CheckFabric, LoopsTooWideForTheWaleAreReported) {
  FabricLayout layout = example_layout();
  layout.loop.head_radius = 1.7;
  EXPECT_THAT(complaint(layout), AllOf(HasSubstr("neighbouring wales overlap by 0.02 mm"), HasSubstr("loop.width")));
}

}  // namespace
}  // namespace knitmech::knit
