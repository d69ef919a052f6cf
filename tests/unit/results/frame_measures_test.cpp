#include "results/frame_measures.h"

#include <gtest/gtest.h>

#include <limits>

namespace knitmech::results {
namespace {

model::ContactRecord contact_at(double x, double normal_force) {
  model::ContactRecord contact;
  contact.position = {x, 0, 0};
  contact.normal_force = normal_force;
  return contact;
}

/// A frame 9 mm wide, from x = -1 to 8, 0.5 mm behind its plane and 2 mm before it.
model::Frame frame_nine_wide() {
  model::Frame frame;
  frame.index = 3;
  frame.history.strain = 0.16;
  frame.points = {{-1, 0, 2}, {8, 1, 0}, {3, 4, -0.5}};
  return frame;
}

TEST(FrameMeasures, GivenContactsWhenMeasuredThenTheMiddleThirdOfTheWidthHasItsShareOfThem) {
  model::Frame frame = frame_nine_wide();
  frame.contacts = {contact_at(0, 1), contact_at(1.9, 2), contact_at(2.1, 3), contact_at(4.9, 4), contact_at(5.1, 6)};
  const FrameMeasures measures = measure_frame(frame);
  EXPECT_EQ(measures.contacts, 5);
  EXPECT_DOUBLE_EQ(measures.contacts_in_middle.value(), 2.0 / 5);
  EXPECT_DOUBLE_EQ(measures.force_in_middle.value(), (3.0 + 4.0) / 16);
}

TEST(FrameMeasures, GivenNodesOutOfPlaneWhenMeasuredThenTheirRangeIsKeptWithTheStrain) {
  const FrameMeasures measures = measure_frame(frame_nine_wide());
  EXPECT_EQ(measures.index, 3);
  EXPECT_EQ(measures.strain, 0.16);
  EXPECT_EQ(measures.lowest_z, -0.5);
  EXPECT_EQ(measures.highest_z, 2);
  EXPECT_FALSE(measures.contacts_in_middle.has_value());
  EXPECT_FALSE(measures.force_in_middle.has_value());
}

TEST(FrameMeasures, GivenANodeThatIsNotFiniteWhenMeasuredThenItIsLeftOut) {
  model::Frame frame = frame_nine_wide();
  frame.points.emplace_back(1e9, 0, std::numeric_limits<double>::quiet_NaN());
  frame.contacts = {contact_at(3.5, 1)};
  const FrameMeasures measures = measure_frame(frame);
  EXPECT_EQ(measures.highest_z, 2);
  EXPECT_EQ(measures.force_in_middle.value(), 1);
}

TEST(FrameMeasures, GivenNoNodesWhenMeasuredThenAllIsZero) {
  const FrameMeasures measures = measure_frame({});
  EXPECT_EQ(measures.lowest_z, 0);
  EXPECT_EQ(measures.highest_z, 0);
  EXPECT_EQ(measures.contacts, 0);
}

}  // namespace
}  // namespace knitmech::results
