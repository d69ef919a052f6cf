#include "compare/simulated_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace knitmech::compare {
namespace {

using testing::ElementsAre;

model::HistoryRow row(double strain, double top, double bottom, double width, double break_loss) {
  model::HistoryRow row;
  row.strain = strain;
  row.force_top = top;
  row.force_bottom = bottom;
  row.width = width;
  row.break_loss = break_loss;
  return row;
}

TEST(SimulatedCurve, GivenAHistory_ThenItIsTheMeanOfTheGripsOverRisingStrainsUpToTheFirstBreak) {
  SimulatedCurve curve;
  set_curve(curve, {row(0, 0, 0, 30, 0), row(0.1, 2, 1, 28, 0), row(0.1, 5, 5, 28, 0), row(0.2, 4, 4, 25, 0),
                    row(0.3, 1, 1, 25, 0.5), row(0.4, 9, 9, 25, 0.5)});
  EXPECT_EQ(curve.width, 30);
  EXPECT_THAT(curve.strains, ElementsAre(0, 0.1, 0.2));
  EXPECT_THAT(curve.forces, ElementsAre(0, 1.5, 4));
}

}  // namespace
}  // namespace knitmech::compare
