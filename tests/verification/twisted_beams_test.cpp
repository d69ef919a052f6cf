// Two stretched beams twisted about each other press on each other with a line force that their shape demands.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "../support/centrelines.h"
#include "../support/contact_bench.h"
#include "../support/verification.h"
#include "../support/yarn_shape.h"

namespace knitmech {
namespace {

using std::numbers::pi;

constexpr double kRadius = 10;           // mm
constexpr double kModulus = 1000;        // MPa
constexpr double kLength = 5000;         // mm
constexpr double kOffset = 9.5;          // mm, of each axis from the common one: the beams overlap by one millimetre
constexpr double kPulled = 49.6472;      // mm, by which the ends move apart; together with one full turn 1 % strain
constexpr int kElements = 48;            // per beam
constexpr double kMassPerLength = 3e-7;  // t/mm

/// Helix angle and strain after the ends have moved apart by kPulled and turned once.
struct Twisted {
  double pitch = kLength + kPulled;
  double length = std::hypot(pitch, 2 * pi * kOffset);
  double stretch = length / kLength;
  double angle = std::atan2(2 * pi * kOffset, pitch);
};

yarn::Section round_section() {
  const double area = pi * kRadius * kRadius;
  const double inertia = 0.25 * area * kRadius * kRadius;
  return test::section(kModulus * area, 0.45 * kModulus * area, kModulus * inertia, kModulus * inertia, kMassPerLength,
                       2 * kRadius);
}

/// Line force per stress-free length [N/mm] that keeps a beam in the helix, without torque: with tension T, curvature
/// k, torsion t and stretch s, the shear is Q = -B k t s, and p = s (T k - Q t).
double line_force(const Twisted& shape) {
  const yarn::Section section = round_section();
  const double tension = section.axial_stiffness * (shape.stretch - 1);
  const double curvature = std::pow(std::sin(shape.angle), 2) / kOffset;
  const double torsion = std::sin(shape.angle) * std::cos(shape.angle) / kOffset;
  const double shear = -section.bending_stiffness * curvature * torsion * shape.stretch;
  return shape.stretch * (tension * curvature - shear * torsion);
}

/// The two beams in their helices; the second is the first turned by half a turn.
test::ContactBench twisted_beams(const Twisted& shape, double stiffness, model::Centreline centreline) {
  model::Model model = test::empty_model(round_section(), 0, stiffness, centreline);
  for (const double side : {1.0, -1.0}) {
    test::add_yarn(model, test::straight_shape({side * kOffset, 0, 0}, {side * kOffset, 0, kLength}, kElements));
  }
  test::ContactBench bench(model);
  const test::Helix helix{kOffset, shape.angle};
  const Eigen::Matrix3d half_turn = Eigen::AngleAxisd(pi, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  std::vector<test::Place> first = test::along([&](double s) { return helix.at(s); }, shape.length, kElements).places;
  std::vector<test::Place> second;
  second.reserve(first.size());
  for (const test::Place& place : first) second.push_back({half_turn * place.position, half_turn * place.tangent});
  test::bend_to(bench.model, 0, first, bench.state);
  test::bend_to(bench.model, 1, second, bench.state);
  return bench;
}

/// Contact force on the middle half of the first beam per stress-free length [N/mm].
double force_on_middle(test::ContactBench& bench) {
  const model::NodalLoads loads = bench.contact_loads();
  double sum = 0;
  constexpr std::size_t kFirst = kElements / 4;
  constexpr std::size_t kNodes = kElements / 2;
  for (std::size_t node = kFirst; node < kFirst + kNodes; ++node) {
    const Eigen::Vector3d at = test::vector_at(bench.state.position, node);
    const Eigen::Vector3d force = test::vector_at(loads.force, node);
    sum += force.head<2>().dot(at.head<2>().normalized());
  }
  return sum / (kNodes * kLength / kElements);
}

class TwistedBeams : public testing::TestWithParam<model::Centreline> {};
KNITMECH_WITH_EVERY_CENTRELINE(TwistedBeams);

TEST_P(TwistedBeams, GivenOneFullTurnAndOnePercentStrain_ThenTheLineForceIsThatOfTwoHelices) {
  const Twisted shape;
  // Such a stiffness that the force is right at the overlap given: force and stiffness are proportional.
  test::ContactBench trial = twisted_beams(shape, 1.0, GetParam());
  const double stiffness = line_force(shape) / force_on_middle(trial);
  test::ContactBench bench = twisted_beams(shape, stiffness, GetParam());
  const double slowest =
      pi / kLength * std::sqrt(bench.elements.axial[0] * (shape.stretch - 1) / kMassPerLength);  // of a string
  const double left = bench.settle(slowest, [&](const model::State&, model::NodalLoads& loads) {
    for (const std::size_t yarn : {0U, 1U}) {
      test::pin(loads, bench.first_node(yarn));
      test::pin(loads, bench.last_node(yarn));
    }
  });
  EXPECT_LT(left, 1e-5);
  test::verify({.chapter = "twisted beams",
                .of = "one full turn, " + test::name_of(GetParam()),
                .quantity = "line force [N/m]",
                .source = "46.84 N/m",
                .reference = 1e3 * line_force(shape),
                .computed = 1e3 * force_on_middle(bench),
                .tolerance = 0.01});
  const auto middle = static_cast<std::size_t>(kElements / 2);
  test::verify({.chapter = "twisted beams",
                .of = "one full turn, " + test::name_of(GetParam()),
                .quantity = "distance of the axes amid the beams [mm]",
                .source = "given",
                .reference = 2 * kOffset,
                .computed = (test::vector_at(bench.state.position, middle) -
                             test::vector_at(bench.state.position, bench.first_node(1) + middle))
                                .norm(),
                .tolerance = 0.01});
}

TEST(TwistedBeamsReference, GivenTheLiteraturesNumbers_ThenTheFormulaGivesItsLineForce) {
  EXPECT_NEAR(Twisted().stretch, 1.01, 1e-8);
  EXPECT_NEAR(1e3 * line_force(Twisted()), 46.84, 0.01);
}

}  // namespace
}  // namespace knitmech
