#include "picture/yarn_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../../support/straight_yarn.h"

namespace knitmech::picture {
namespace {

class YarnFieldTest : public testing::Test {
 protected:
  const model::Model model_ = test::straight_yarn();
  model::Frame frame_ = test::undeformed(model_);
};

TEST_F(YarnFieldTest, PlainAndCourseHaveNone) {
  EXPECT_FALSE(yarn_field(ColourBy::plain, model_, frame_, {}).has_value());
  EXPECT_FALSE(yarn_field(ColourBy::course, model_, frame_, {}).has_value());
}

TEST_F(YarnFieldTest, ContactForceIsAMagnitudeFromZero) {
  frame_.contact_force[3] = {0.03, 0, -0.04};
  const YarnField field = yarn_field(ColourBy::contact_force, model_, frame_, {}).value();
  EXPECT_DOUBLE_EQ(field.values[3], 0.05);
  EXPECT_EQ(field.lowest, 0);
  EXPECT_NEAR(field.highest, 0.05, 1e-12);
  EXPECT_EQ(field.label, "Contact force [N]");
}

TEST_F(YarnFieldTest, AMagnitudeThatIsZeroEverywhereStillHasARange) {
  const YarnField field = yarn_field(ColourBy::curvature, model_, frame_, {}).value();
  EXPECT_EQ(field.lowest, 0);
  EXPECT_GT(field.highest, 0);
}

TEST_F(YarnFieldTest, ElementQuantitiesAreAveragedToTheNodes) {
  frame_.axial_force[0] = -1;
  frame_.axial_force[1] = 3;
  const YarnField field = yarn_field(ColourBy::axial_force, model_, frame_, {}).value();
  EXPECT_DOUBLE_EQ(field.values[0], -1);
  EXPECT_DOUBLE_EQ(field.values[1], 1);
  EXPECT_DOUBLE_EQ(field.values[2], 1.5);
  EXPECT_LE(field.lowest, -1);
  EXPECT_GE(field.highest, 1.5);
}

TEST_F(YarnFieldTest, AxialStrainIsInPercent) {
  frame_.axial_strain.assign(frame_.axial_strain.size(), 0.02);
  const YarnField field = yarn_field(ColourBy::axial_strain, model_, frame_, {}).value();
  EXPECT_EQ(field.label, "Axial strain [%]");
  EXPECT_DOUBLE_EQ(field.values[1], 2);
}

TEST_F(YarnFieldTest, TheRangeOfSeveralFramesSpansThemAll) {
  // Given a frame without forces, and one with a little of them.
  ValueRange values;
  values.include(yarn_field(ColourBy::bending_moment, model_, frame_, {}).value());
  frame_.bending_moment[0] = 0.018;
  values.include(yarn_field(ColourBy::bending_moment, model_, frame_, {}).value());
  // Then the first does not widen the range.
  const auto [lowest, highest] = round_range(ColourBy::bending_moment, values);
  EXPECT_EQ(lowest, 0);
  EXPECT_NEAR(highest, 0.02, 1e-12);
}

TEST_F(YarnFieldTest, AGivenRangeIsTaken) {
  frame_.points[2].z() = 1.3;
  const YarnField field = yarn_field(ColourBy::out_of_plane, model_, frame_, std::pair{-2.0, 7.5}).value();
  EXPECT_DOUBLE_EQ(field.values[2], 1.3);
  EXPECT_EQ(field.lowest, -2);
  EXPECT_EQ(field.highest, 7.5);
}

}  // namespace
}  // namespace knitmech::picture
