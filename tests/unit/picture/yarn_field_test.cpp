#include "picture/yarn_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "straight_yarn.h"

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

TEST_F(YarnFieldTest, AGivenRangeIsTaken) {
  frame_.points[2].z() = 1.3;
  const YarnField field = yarn_field(ColourBy::out_of_plane, model_, frame_, std::pair{-2.0, 7.5}).value();
  EXPECT_DOUBLE_EQ(field.values[2], 1.3);
  EXPECT_EQ(field.lowest, -2);
  EXPECT_EQ(field.highest, 7.5);
}

}  // namespace
}  // namespace knitmech::picture
