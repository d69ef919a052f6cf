// A yarn around a drum: its tension grows along the wrap by Coulomb friction.

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

constexpr double kDrumRadius = 1;  // mm
constexpr double kPitch = 0.2;     // mm per turn of the helix, so that turns do not touch
constexpr double kTail = 2;        // mm, free on both sides of the wrap
constexpr int kElementsPerTurn = 40;
constexpr double kBending = 1e-5;   // N mm^2: bending forces EI / R^2 are a thousandth of the tension
constexpr double kHeldBack = 0.01;  // N, dead load at the trailing end
constexpr double kSpeed = 5;        // mm/s, of the leading end
constexpr double kDamping = 4e5;    // 1/s, of what is not uniform sliding; critical for the yarn as a spring

/// A helix about the drum that turns the tangent by an angle, with straight tails.
test::YarnShape wrap_of(double turning, double radius) {
  const test::Helix helix{radius, std::atan2(2 * std::numbers::pi * radius, kPitch)};
  const double curvature = std::pow(std::sin(helix.angle), 2) / radius;
  const double wrapped = turning / curvature;
  const double length = wrapped + 2 * kTail;
  const auto curve = [&](double s) {
    const double on_helix = std::clamp(s - kTail, 0.0, wrapped);
    const test::Place place = helix.at(on_helix);
    return test::Place{place.position + (s - kTail - on_helix) * place.tangent, place.tangent};
  };
  const double element = 2 * std::numbers::pi * radius / kElementsPerTurn;
  return test::along(curve, length, static_cast<int>(std::lround(length / element)));
}

/// A drum that stays (yarn 0) and a thread around it (yarn 1).
model::Model drum_and_thread(double friction, double turning, model::Centreline centreline) {
  yarn::Section thread = test::monofilament();
  thread.bending_stiffness = thread.torsional_stiffness = kBending;
  yarn::Section drum = thread;
  drum.diameter = 2 * kDrumRadius;
  model::Model model = test::empty_model(thread, friction, 16, centreline);
  model.sections.push_back(drum);
  const double end = kPitch * turning / (2 * std::numbers::pi) + 1;
  test::add_yarn(model, test::straight_shape({0, 0, -1}, {0, 0, end}, 1), 1);
  test::add_yarn(model, wrap_of(turning, kDrumRadius + 0.5 * thread.diameter), 0);
  return model;
}

/// Damps what is not uniform sliding along the yarn, without which the friction would excite vibrations.
void damp_but_for_sliding(const test::ContactBench& bench, double speed, model::NodalLoads& loads) {
  const std::size_t first = bench.first_node(1);
  const std::size_t last = bench.last_node(1);
  for (std::size_t i = first; i <= last; ++i) {
    const Eigen::Vector3d behind = test::vector_at(bench.state.position, std::max(i, first + 1) - 1);
    const Eigen::Vector3d ahead = test::vector_at(bench.state.position, std::min(i + 1, last));
    const Eigen::Vector3d sliding = speed * (ahead - behind).normalized();
    const Eigen::Vector3d rest = test::vector_at(bench.state.velocity, i) - sliding;
    loads.force.add(i, (-kDamping * bench.inertia.mass[i]) * Vector3{rest.x(), rest.y(), rest.z()});
    loads.moment.add(i, (-kDamping * bench.inertia.rotary[i]) * bench.state.angular_velocity.at(i));
  }
}

/// How far the leading end has to be pulled until the whole wrap slips, and some more [mm]: two thirds of the stretch
/// of a yarn under the tension ahead are more than that of one whose tension grows along the wrap.
double pull_for(const test::ContactBench& bench, double friction, double turning) {
  const double stretch = kHeldBack / bench.elements.axial[bench.first_node(1)] * bench.model.arc_length.back();
  return 0.006 + 0.7 * stretch * (std::exp(friction * turning) - 1);
}

/// Tension at the leading end over that at the trailing end while the yarn slides around the drum.
double tension_ratio(double friction, double turning, model::Centreline centreline) {
  test::ContactBench bench(drum_and_thread(friction, turning, centreline));
  const std::size_t trailing = bench.first_node(1);
  const std::size_t leading = bench.last_node(1);
  const Eigen::Vector3d back = -kHeldBack * bench.model.tangents[trailing];
  const Eigen::Vector3d ahead = kSpeed * bench.model.tangents[leading];
  const long n_steps = std::lround(pull_for(bench, friction, turning) / kSpeed / bench.step);
  for (long i = 0; i < n_steps; ++i) {
    const double share = std::min(1.0, 4.0 * static_cast<double>(i) / static_cast<double>(n_steps));
    bench.advance([&](const model::State&, model::NodalLoads& loads) {
      damp_but_for_sliding(bench, share * kSpeed, loads);
      loads.force.add(trailing, {back.x(), back.y(), back.z()});
      for (const std::size_t node : {bench.first_node(0), bench.last_node(0), leading}) test::clamp(loads, node);
      bench.state.velocity.set(leading, share * Vector3{ahead.x(), ahead.y(), ahead.z()});
    });
  }
  return bench.tension(leading - 1) / kHeldBack;
}

class Capstan : public testing::TestWithParam<model::Centreline> {};
KNITMECH_WITH_EVERY_CENTRELINE(Capstan);

TEST_P(Capstan, GivenAYarnPulledAroundADrum_ThenItsTensionGrowsAsEulerAndEytelweinSay) {
  for (const double friction : {0.1, 0.3}) {
    for (const int half_turns : {1, 2}) {
      const double turning = half_turns * std::numbers::pi;
      test::verify({.chapter = "capstan",
                    .of = "mu = " + std::string(friction < 0.2 ? "0.1" : "0.3") + ", " +
                          (half_turns == 1 ? "half a turn" : "a whole turn") + ", " + test::name_of(GetParam()),
                    .quantity = "tension ahead over tension behind [-]",
                    .source = "e^(mu phi)",
                    .reference = std::exp(friction * turning),
                    .computed = tension_ratio(friction, turning, GetParam()),
                    .tolerance = 0.01});
    }
  }
}

}  // namespace
}  // namespace knitmech
