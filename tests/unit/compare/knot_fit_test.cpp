#include "compare/knot_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace knitmech::compare {
namespace {

KnotFit fit_of(double from, double to, const std::function<double(double)>& force) {
  std::vector<double> strains;
  std::vector<double> forces;
  constexpr int kPoints = 500;
  for (int i = 0; i <= kPoints; ++i) {
    strains.push_back(from + (to - from) * i / kPoints);
    forces.push_back(force(strains.back()));
  }
  return fit_knot(strains, forces);
}

TEST(KnotFit, GivenTwoLinesThatMeet_ThenTheirSlopesAndTheirKnotAreFound) {
  // Given 0.01 + 0.2 e up to 0.1234, and 3 N/mm from there on.
  const KnotFit fit = fit_of(0.02, 0.22, [](double e) { return 0.01 + 0.2 * e + 2.8 * std::max(0.0, e - 0.1234); });
  EXPECT_NEAR(fit.knot, 0.1234, 1e-7);
  EXPECT_NEAR(fit.initial_slope, 0.2, 1e-6);
  EXPECT_NEAR(fit.locked_slope, 3, 1e-5);
  ASSERT_TRUE(fit.locking_strain);
  EXPECT_EQ(*fit.locking_strain, fit.knot);
  EXPECT_LT(fit.rms, 1e-7);
}

TEST(KnotFit, GivenAParabola_ThenTheKnotIsInTheMiddleAndTheSlopesAreSymmetric) {
  // Reference: e^2 on 0 to 1 less its slope 1 is symmetric about 1/2, and so is the best fit: slopes 1 - s and 1 + s.
  // With u = |e - 1/2| the even fit of u^2 by a line is the least-squares line of u^2 on 0 to 1/2, whose slope is 1/2.
  const KnotFit fit = fit_of(0, 1, [](double e) { return e * e; });
  EXPECT_NEAR(fit.knot, 0.5, 1e-3);
  EXPECT_NEAR(fit.initial_slope, 0.5, 5e-3);
  EXPECT_NEAR(fit.locked_slope, 1.5, 5e-3);
}

TEST(KnotFit, GivenAStraightLineOrOneThatFlattens_ThenNothingLocks) {
  const KnotFit straight = fit_of(0, 0.2, [](double e) { return 0.3 + 2 * e; });
  EXPECT_FALSE(straight.locking_strain);
  EXPECT_NEAR(straight.initial_slope, 2, 1e-6);
  EXPECT_NEAR(straight.locked_slope, 2, 1e-6);
  const KnotFit flattens = fit_of(0, 0.2, [](double e) { return e < 0.1 ? 2 * e : 0.2 + 0.1 * (e - 0.1); });
  EXPECT_FALSE(flattens.locking_strain);
  EXPECT_NEAR(flattens.knot, 0.1, 1e-6);
}

}  // namespace
}  // namespace knitmech::compare
