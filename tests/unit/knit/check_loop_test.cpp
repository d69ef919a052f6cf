#include "knit/check_loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "base/errors.h"
#include "example_loop.h"
#include "knit/erc.h"

namespace knitmech::knit {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string complaint(const LoopShape& shape, double diameter = kExampleDiameter) {
  return message_of([&] { check_loop(shape, diameter); });
}

LoopShape changed(double LoopShape::*member, double value) {
  LoopShape shape = example_loop();
  shape.*member = value;
  return shape;
}

TEST(CheckLoop, AcceptsTheExample) {
  EXPECT_EQ(complaint(example_loop()), "");
}

TEST(CheckLoop, NamesTheKeyOfALengthThatIsNotPositive) {
  EXPECT_THAT(complaint(changed(&LoopShape::height, 0)), HasSubstr("loop.height is 0 mm"));
  EXPECT_THAT(complaint(changed(&LoopShape::width, -3)), HasSubstr("loop.width is -3 mm"));
  EXPECT_THAT(complaint(changed(&LoopShape::head_radius, 0)), HasSubstr("loop.head_radius"));
  EXPECT_THAT(complaint(changed(&LoopShape::foot_radius, 0)), HasSubstr("loop.foot_radius"));
  EXPECT_THAT(complaint(changed(&LoopShape::head_flat, -0.1)), HasSubstr("loop.head_flat"));
  EXPECT_THAT(complaint(changed(&LoopShape::foot_flat, -0.1)), HasSubstr("loop.foot_flat"));
  EXPECT_THAT(complaint(changed(&LoopShape::out_of_plane, -0.02)), HasSubstr("loop.out_of_plane"));
  EXPECT_THAT(complaint(changed(&LoopShape::height, std::numeric_limits<double>::quiet_NaN())),
              HasSubstr("loop.height"));
  EXPECT_THAT(complaint(example_loop(), 0), HasSubstr("yarn.diameter"));
}

TEST(CheckLoop, SaysByHowMuchTheCirclesLeaveNoRoomForALeg) {
  // Given H = 3, the middles are |(1.55, -0.9)| = 1.792 mm apart, but the radii add up to 2.1 mm. A leg exists above
  // H = 2.1 + sqrt(2.1^2 - 1.55^2) = 3.5168, or below R1 + R2 = (3^2 + 1.55^2) / (2 x 3) = 1.9004.
  const std::string message = complaint(changed(&LoopShape::height, 3));
  EXPECT_THAT(message, AllOf(HasSubstr("1.792 mm apart"), HasSubstr("0.3077 mm too much"),
                             HasSubstr("loop.height more than 3.517 mm"), HasSubstr("less than 1.9 mm"),
                             HasSubstr("loop.head_radius + loop.foot_radius")));
}

TEST(CheckLoop, RoomForALegBeginsWhereTheAdviceSays) {
  EXPECT_EQ(message_of([] { check_loop_shape(changed(&LoopShape::height, 3.517)); }), "");
  EXPECT_NE(message_of([] { check_loop_shape(changed(&LoopShape::height, 3.516)); }), "");
}

TEST(CheckLoop, MakeErcRefusesWhatTheCheckRefuses) {
  EXPECT_THROW((void)make_erc(changed(&LoopShape::height, 3)), InputError);
}

TEST(CheckLoop, FlatsLongerThanTheStitchDoNotFit) {
  EXPECT_THAT(complaint(changed(&LoopShape::head_flat, 1.95)),
              AllOf(HasSubstr("loop.head_flat"), HasSubstr("1.95 mm")));
  EXPECT_THAT(complaint(changed(&LoopShape::foot_flat, 2.5)), AllOf(HasSubstr("loop.foot_flat"), HasSubstr("2.5 mm")));
}

TEST(CheckLoop, HeadsWiderThanTheStitchOverlapByTheDifference) {
  // Given R1 = 1.8, the head is 2 (0.2 + 1.8) + 0.12 = 4.12 mm wide in a stitch of 3.9 mm.
  EXPECT_THAT(complaint(changed(&LoopShape::head_radius, 1.8)),
              AllOf(HasSubstr("heads of neighbouring wales overlap by 0.22 mm"),
                    HasSubstr("loop.width at least 4.12 mm"), HasSubstr("loop.head_radius at most 1.89 mm")));
}

TEST(CheckLoop, FeetWiderThanTheStitchOverlapByTheDifference) {
  EXPECT_THAT(complaint(changed(&LoopShape::foot_radius, 1.8)),
              AllOf(HasSubstr("feet of neighbouring wales overlap by 0.22 mm"),
                    HasSubstr("loop.width at least 4.12 mm"), HasSubstr("loop.foot_radius at most 1.89 mm")));
}

TEST(CheckLoop, ALoopAsWideAsTheStitchJustFits) {
  EXPECT_EQ(complaint(changed(&LoopShape::head_radius, 1.6899)), "");
  EXPECT_NE(complaint(changed(&LoopShape::head_radius, 1.6901)), "");
}

TEST(CheckLoop, LoopsThatExactlyTouchAreNoOverlap) {
  // 2 (0.2 + 1.1) + 1.3 = 3.9, in floating point a little more.
  EXPECT_EQ(complaint(example_loop(), 1.3), "");
}

TEST(CheckLoop, ArcsTighterThanTheYarnAreRefused) {
  EXPECT_THAT(complaint(changed(&LoopShape::head_radius, 0.05)),
              AllOf(HasSubstr("loop.head_radius is 0.05 mm"), HasSubstr("at least 0.06 mm")));
  EXPECT_THAT(complaint(example_loop(), 2.05), HasSubstr("loop.foot_radius"));
}

TEST(CheckLoop, ShallowWavesMayBeWiderThanTheStitch) {
  // Given a leg that runs outwards (theta below 90 degrees), the arcs do not reach their full width and cannot collide.
  const LoopShape wave = {.height = 1.0,
                          .width = 4.0,
                          .head_flat = 0.0,
                          .head_radius = 1.0,
                          .foot_flat = 0.0,
                          .foot_radius = 1.0,
                          .out_of_plane = 0.0};
  EXPECT_EQ(complaint(wave), "");
  EXPECT_LT(make_erc(wave).theta1, 1.5);
}

}  // namespace
}  // namespace knitmech::knit
