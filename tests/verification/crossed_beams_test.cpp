// Two beams that lie across each other share a load as their stiffnesses say.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../support/centrelines.h"
#include "../support/contact_bench.h"
#include "../support/verification.h"
#include "../support/yarn_shape.h"

namespace knitmech {
namespace {

constexpr double kSpan = 10;      // mm
constexpr int kElements = 20;     // per beam
constexpr double kLoad = 5e-7;    // N: deflections of 0.6 um, so that stretching plays no part
constexpr double kAtRest = 1e-6;  // speed left, of the largest on the way

/// Deflection under a unit force at a share of the span of a beam on two supports, L^3 a^2 b^2 / (3 EI) [mm/N].
double flexibility(double bending, double share) {
  const double a = share * kSpan;
  const double b = kSpan - a;
  return a * a * b * b / (3 * bending * kSpan);
}

struct Crossing {
  std::string name;
  double stiffer;      ///< bending stiffness of the lower beam over that of the upper one [-]
  double share_lower;  ///< where the upper beam lies on the lower one, as a share of its span [-]
};

/// The share of a load in the middle of the upper beam that the contact hands on to the lower one.
double share_handed_on(const Crossing& crossing, model::Centreline centreline) {
  const yarn::Section upper = test::monofilament();
  yarn::Section lower = upper;
  lower.bending_stiffness *= crossing.stiffer;
  const double stiffness = centreline == model::Centreline::chords ? 16 : 160;  // N/mm, hard beside the beams
  model::Model model = test::empty_model(upper, 0.0, stiffness, centreline);
  model.sections.push_back(lower);
  const double from = -crossing.share_lower * kSpan;
  const double height = upper.diameter;
  test::add_yarn(model, test::straight_shape({from, 0, 0}, {from + kSpan, 0, 0}, kElements), 1);
  test::add_yarn(model, test::straight_shape({0, -kSpan / 2, height}, {0, kSpan / 2, height}, kElements), 0);
  test::ContactBench bench(model);

  const double slowest = M_PI * M_PI * std::sqrt(upper.bending_stiffness / upper.mass_per_length) / (kSpan * kSpan);
  const double left = bench.settle(slowest, [&](const model::State&, model::NodalLoads& loads) {
    for (const std::size_t yarn : {0U, 1U}) {
      test::pin(loads, bench.first_node(yarn));
      test::pin(loads, bench.last_node(yarn));
    }
    loads.force.z[bench.first_node(1) + kElements / 2] -= kLoad;
  });
  EXPECT_LT(left, kAtRest);
  return -bench.contact_force_on(0).z() / kLoad;
}

class CrossedBeams : public testing::TestWithParam<model::Centreline> {};
KNITMECH_WITH_EVERY_CENTRELINE(CrossedBeams);

TEST_P(CrossedBeams, GivenALoadOnTheUpperOne_ThenItIsSharedAsTheStiffnessesSay) {
  const std::vector<Crossing> crossings = {{"equal beams, crossing at their middles (at nodes)", 1, 0.5},
                                           {"lower beam four times stiffer", 4, 0.5},
                                           {"lower beam crossed at 0.3 of its span (at a node)", 1, 0.3},
                                           {"lower beam crossed at 0.325 of its span (amid an element)", 1, 0.325}};
  for (const Crossing& crossing : crossings) {
    const double upper = flexibility(test::monofilament().bending_stiffness, 0.5);
    const double lower = flexibility(crossing.stiffer * test::monofilament().bending_stiffness, crossing.share_lower);
    test::verify({.chapter = "crossed beams",
                  .of = crossing.name + ", " + test::name_of(GetParam()),
                  .quantity = "contact force over load [-]",
                  .source = "beam theory",
                  .reference = upper / (upper + lower),
                  .computed = share_handed_on(crossing, GetParam()),
                  .tolerance = 0.01});
  }
}

}  // namespace
}  // namespace knitmech
