#include "yarn/yarn_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TensileCurve sampled(double from, double to, int n_points, const std::function<double(double)>& force) {
  TensileCurve curve{.name = "curve", .strains = {}, .forces = {}};
  for (int i = 0; i < n_points; ++i) {
    const double strain = from + (to - from) * i / (n_points - 1);
    curve.strains.push_back(strain);
    curve.forces.push_back(force(strain));
  }
  return curve;
}

TensileCurve line(double slope, double intercept, double to) {
  return sampled(0, to, 101, [=](double strain) { return intercept + slope * strain; });
}

/// 18 e + 0.4 (1 - exp(-e / 0.05)): slope 26 N at zero, 18 N at large strains.
double polymer(double strain) {
  return 18 * strain + 0.4 * (1 - std::exp(-strain / 0.05));
}

TEST(UpToBreak, EndsAtTheFirstLargestForce) {
  const TensileCurve curve = up_to_break({"curve", {0, 0.1, 0.2, 0.3, 0.4}, {0, 1, 3, 3, 0.1}});
  EXPECT_THAT(curve.strains, ElementsAre(0, 0.1, 0.2));
  EXPECT_EQ(break_of(curve).force, 3);
  EXPECT_EQ(break_of(curve).strain, 0.2);
}

TEST(UpToBreak, LeavesOutPointsWhoseStrainDoesNotAdvance) {
  const TensileCurve curve = up_to_break({"curve", {0, 0.1, 0.1, 0.09, 0.2, 0.2, 0.2}, {0, 1, 1.1, 0.9, 2, 2.1, 2.2}});
  EXPECT_THAT(curve.strains, ElementsAre(0, 0.1, 0.2));
  EXPECT_THAT(curve.forces, ElementsAre(0, 1, 2.2));  // and the largest force is kept
}

TEST(UpToBreak, RefusesAStrainThatRunsBackwardsAndForcesWithoutTension) {
  const auto refused = [](const TensileCurve& curve, const char* complaint) {
    EXPECT_THAT([&] { (void)up_to_break(curve); }, ThrowsMessage<InputError>(HasSubstr(complaint)));
  };
  refused({"curve", {0.3, 0.2, 0.1}, {0, 1, 2}}, "must rise with the test");
  refused({"curve", {0.3, 0.2, 0.1}, {2, 1, 0}}, "must rise with the test");
  refused({"curve", {0.3, 0.31, 0.2, 0.1}, {0, 0.1, 1, 2}}, "must rise with the test");
  refused({"curve", {0.1, 0.1, 0.1}, {0, 1, 2}}, "must rise with the test");
  refused({"curve", {0, 0.1, 0.2}, {0, -1, -2}}, "no force is above 0");
}

TEST(WithoutSlack, CountsTheStrainFromAForceThatStays) {
  // Given 1 N of noise in the slack, when the strain is counted from 0.5 N, then from the rise that lasts.
  const TensileCurve curve = without_slack({"curve", {0, 0.01, 0.02, 0.03, 0.04, 0.05}, {0, 1, 0, 0.5, 2, 0.1}}, 0.5);
  ASSERT_EQ(curve.strains.size(), 3);
  EXPECT_EQ(curve.strains[0], 0);
  EXPECT_NEAR(curve.strains[1], 0.01, 1e-15);
  EXPECT_THAT(curve.forces, ElementsAre(0.5, 2, 0.1));
  EXPECT_THROW((void)without_slack(line(10, 0, 0.1), 2), InputError);
}

TEST(MeanCurve, IsTheMeanOfAllCurvesUpToTheFirstBreak) {
  // Reference: lines of slope 8, 10 and 15 N that break at 20, 30 and 25 %: mean 11 N, range 8 to 15 N, up to 20 %.
  const std::vector<TensileCurve> curves = {line(8, 0, 0.2), line(10, 0, 0.3), line(15, 0, 0.25)};
  const MeanCurve mean = mean_of(curves);
  EXPECT_EQ(mean.n_curves, 3);
  EXPECT_EQ(mean.strains.front(), 0);
  EXPECT_EQ(mean.strains.back(), 0.2);
  for (std::size_t i = 0; i < mean.strains.size(); ++i) {
    EXPECT_NEAR(mean.forces[i], 11 * mean.strains[i], 1e-13);
    EXPECT_NEAR(mean.least[i], 8 * mean.strains[i], 1e-13);
    EXPECT_NEAR(mean.greatest[i], 15 * mean.strains[i], 1e-13);
  }
}

TEST(MeanCurve, DoesNotDependOnHowTheCurvesAreSampled) {
  // Given a straight curve in 3 points and one in 1000.
  const std::vector<TensileCurve> curves = {sampled(0, 0.2, 3, [](double e) { return 10 * e; }),
                                            sampled(-0.01, 0.3, 1000, [](double e) { return 20 * e; })};
  const MeanCurve mean = mean_of(curves);
  EXPECT_NEAR(force_at(mean.strains, mean.forces, 0.137), 15 * 0.137, 1e-13);
  EXPECT_EQ(mean.strains.front(), 0);
}

TEST(MeanCurve, NeedsStrainsInCommon) {
  const std::vector<TensileCurve> curves = {line(10, 0, 0.1), sampled(0.15, 0.3, 10, [](double e) { return e; })};
  EXPECT_THAT([&] { (void)mean_of(curves); }, ThrowsMessage<InputError>(HasSubstr("no strains in common")));
}

TEST(LineFit, FindsALineExactly) {
  const TensileCurve curve = line(19, 0.3, 0.2);
  const LineFit fit = fit_line(curve.strains, curve.forces, {0, 0.1});
  EXPECT_NEAR(fit.slope, 19, 1e-11);
  EXPECT_NEAR(fit.intercept, 0.3, 1e-13);
  EXPECT_NEAR(fit.r_squared, 1, 1e-13);
  EXPECT_NEAR(fit.rms_ratio, 0, 1e-12);
  EXPECT_TRUE(fit.covers);
}

TEST(LineFit, OfAParabolaIsItsBestLine) {
  // Reference, by hand: over [0, h] the line nearest to c e^2 is c h e - c h^2 / 6; the residual's mean square is
  // c^2 h^4 / 180 of a variance 4 c^2 h^4 / 45, so R^2 = 15/16 and the root mean square is 1 / sqrt(180) of the largest
  // force.
  const TensileCurve curve = sampled(0, 0.1, 5001, [](double e) { return 50 * e * e; });
  const LineFit fit = fit_line(curve.strains, curve.forces, {0, 0.1});
  EXPECT_NEAR(fit.slope, 5, 1e-3);
  EXPECT_NEAR(fit.intercept, -50 * 0.01 / 6, 2e-3);
  EXPECT_NEAR(fit.r_squared, 15.0 / 16, 1e-3);
  EXPECT_NEAR(fit.rms_ratio, 1 / std::sqrt(180), 1e-3);
}

TEST(LineFit, OfTheMeanIsTheMeanOfTheFits) {
  // Least squares at the same strains is linear in the forces.
  const std::vector<TensileCurve> curves = {sampled(0, 0.3, 301, polymer),
                                            sampled(0, 0.3, 301, [](double e) { return 30 * e - 20 * e * e; })};
  const MeanCurve mean = mean_of(curves);
  const double sum = fit_line(curves[0].strains, curves[0].forces, {0.02, 0.1}).slope +
                     fit_line(curves[1].strains, curves[1].forces, {0.02, 0.1}).slope;
  EXPECT_NEAR(fit_line(mean.strains, mean.forces, {0.02, 0.1}).slope, sum / 2, 1e-3);
}

TEST(LineFit, SaysWhenTheCurveDoesNotCoverTheRange) {
  const TensileCurve curve = line(19, 0, 0.06);
  const LineFit fit = fit_line(curve.strains, curve.forces, {0, 0.1});
  EXPECT_FALSE(fit.covers);
  EXPECT_NEAR(fit.range.to, 0.06, 1e-15);
  EXPECT_TRUE(fit_line(curve.strains, curve.forces, {0, 0.0604}).covers);
  EXPECT_THROW((void)fit_line(curve.strains, curve.forces, {0.07, 0.1}), InputError);
  const TensileCurve flat = sampled(0, 0.2, 21, [](double) { return 1; });
  EXPECT_THAT(
      [&] {
        (void)fit_line(flat.strains, flat.forces, {0, 0.1});
      },
      ThrowsMessage<InputError>(HasSubstr("does not rise")));
}

MeanCurve mean_of_one(const TensileCurve& curve) {
  const std::vector<TensileCurve> curves = {up_to_break(curve)};
  return mean_of(curves);
}

TEST(LawPoints, FollowTheMeanCurve) {
  const AxialLaw law(law_points(mean_of_one(sampled(0, 0.35, 1001, polymer))));
  EXPECT_NEAR(law.slope_at_zero(), 26, 0.3);
  EXPECT_NEAR(law.last_strain(), 0.35, 1e-12);
  for (double strain = 0; strain <= 0.35; strain += 0.001) EXPECT_NEAR(law.force(strain), polymer(strain), 2e-3);
}

TEST(LawPoints, BeginWithoutForceWhereTheTestHadAPreTension) {
  const AxialLaw law(law_points(mean_of_one(line(20, 0.5, 0.3))));
  EXPECT_NEAR(law.slope_at_zero(), 20, 1e-3);
  EXPECT_NEAR(law.force(0.3), 6, 1e-4);
}

TEST(LawPoints, RiseThroughNoise) {
  // Given noise of 1 % of the largest force, reproducible, when the points become a law, then that is possible (no
  // force falls) and it is within the noise of the curve without it.
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, 0.06);
  const AxialLaw law(law_points(
      mean_of_one(sampled(0, 0.35, 2001, [&](double e) { return e == 0 ? 0 : polymer(e) + noise(random); }))));
  for (double strain = 0; strain <= 0.35; strain += 0.005) EXPECT_NEAR(law.force(strain), polymer(strain), 0.12);
}

TEST(LawPoints, PoolForcesThatFall) {
  // Given a yield point, 2 N at 10 %, then 1 N at 15 %, then rising again: the falling part becomes a plateau between.
  const MeanCurve mean = mean_of_one({"curve", {0, 0.1, 0.15, 0.3}, {0, 2, 1, 4}});
  const std::vector<AxialPoint> points = law_points(mean);
  EXPECT_TRUE(std::ranges::is_sorted(points, {}, &AxialPoint::force));
  const AxialLaw law(points);
  EXPECT_GT(law.force(0.12), 1);
  EXPECT_LT(law.force(0.12), 2);
}

TEST(LawPoints, NeedAForceThatRisesFromTheStart) {
  const MeanCurve mean = mean_of_one({"curve", {0, 0.1, 0.2}, {0, 0, 4}});
  EXPECT_THAT([&] { (void)law_points(mean); }, ThrowsMessage<InputError>(HasSubstr("does not rise from strain 0")));
}

}  // namespace
}  // namespace knitmech::yarn
