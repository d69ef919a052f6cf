// Waves and vibrations of beams without contact.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "../support/beam_case.h"
#include "../support/monofilament.h"
#include "../support/verification.h"
#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "solve/integrate.h"

namespace knitmech {
namespace {

using std::numbers::pi;

constexpr double kLength = 10;  // [mm]

/// A straight yarn along x that moves without damping.
struct Yarn {
  model::Model model;
  beam::Elements elements;
  beam::NodalInertia inertia;
  model::State state;
  model::NodalLoads loads;
  beam::ElementWork work;
  double step;

  Yarn(int n_elements, double share_of_limit)
      : model(test::yarns_through({test::straight({0, 0, 0}, {kLength, 0, 0}, n_elements)}, test::monofilament())),
        elements(beam::make_elements(model, 1.0, 0.0)),
        inertia(beam::lump_inertia(elements, 1.0)),
        state(test::state_of(model)),
        loads(model.nodes.size()),
        work(model.nodes.size()),
        step(share_of_limit * 2 / std::sqrt(inertia.highest_frequency_squared)) {}

  [[nodiscard]] std::size_t tip() const { return model.nodes.size() - 1; }
  void advance(const std::function<void(model::NodalLoads&)>& supports) {
    beam::set_internal_force(elements, state, step, work, loads);
    supports(loads);
    solve::integrate(inertia, loads, {step, step}, 0.0, state);
  }
};

void clamp_start(model::NodalLoads& loads) {
  loads.force.set(0, {0, 0, 0});
  loads.moment.set(0, {0, 0, 0});
}

TEST(Vibration, GivenAYarnHeldAtOneEnd_ThenItsLowestAxialPeriodIsFourCrossingsOfTheWave) {
  Yarn yarn(20, 0.5);
  for (std::size_t i = 0; i <= yarn.tip(); ++i) {
    yarn.state.velocity.x[i] = std::sin(pi / 2 * static_cast<double>(i) / static_cast<double>(yarn.tip()));
  }
  // From rest length with this velocity, the tip comes back through zero after half a period: 2 L / c.
  const double expected = 2 * kLength / std::sqrt(test::kAxial / test::kMassPerLength);
  double before = 0;
  double crossing = 0;
  for (int i = 0; i < 100000 && crossing == 0; ++i) {
    yarn.advance(clamp_start);
    const double moved = yarn.state.position.x[yarn.tip()] - kLength;
    if (before > 0 && moved <= 0) crossing = yarn.state.time + yarn.step * moved / (before - moved);
    before = moved;
  }
  test::verify({.chapter = "vibration",
                .of = "20 elements",
                .quantity = "half the lowest axial period [us]",
                .source = "2 L / c",
                .reference = 1e6 * expected,
                .computed = 1e6 * crossing,
                .tolerance = 0.002});
}

/// A free yarn is pulled at one end by a sudden constant load P. The front of the wave runs at c = sqrt(EA / rho A),
/// and behind it the yarn moves at P / (rho A c).
TEST(Vibration, GivenASuddenPullAtOneEnd_ThenAFrontRunsThroughTheYarnAtTheSpeedOfSound) {
  Yarn yarn(200, 0.9);
  const double speed_of_sound = std::sqrt(test::kAxial / test::kMassPerLength);
  const double load = 1e-3;  // [N]
  const double behind = load / (test::kMassPerLength * speed_of_sound);
  const std::size_t near = yarn.tip() - 40;
  const std::size_t far = 40;
  double passed_near = 0, passed_far = 0;
  double near_before = 0, far_before = 0;
  while (passed_far == 0 && yarn.state.time < 2 * kLength / speed_of_sound) {
    yarn.advance([&](model::NodalLoads& loads) { loads.force.x[yarn.tip()] += load; });
    const auto half_risen = [&](std::size_t node, double& before, double& passed) {
      const double speed = yarn.state.velocity.x[node];
      if (passed == 0 && speed >= 0.5 * behind) {
        passed = yarn.state.time - yarn.step * (speed - 0.5 * behind) / (speed - before);
      }
      before = speed;
    };
    half_risen(near, near_before, passed_near);
    half_risen(far, far_before, passed_far);
  }
  test::verify({.chapter = "vibration",
                .of = "200 elements, sudden pull at one end",
                .quantity = "speed of the front [km/s]",
                .source = "c = sqrt(EA / (rho A))",
                .reference = 1e-6 * speed_of_sound,
                .computed = 1e-6 * static_cast<double>(near - far) * kLength / 200 / (passed_far - passed_near),
                .tolerance = 0.005});
  test::verify({.chapter = "vibration",
                .of = "200 elements, sudden pull at one end",
                .quantity = "mean speed of the pulled end [mm/s]",
                .source = "P / (rho A c)",
                .reference = behind,
                .computed = (yarn.state.position.x[yarn.tip()] - kLength) / yarn.state.time,
                .tolerance = 0.01});
}

/// A shape of bending vibration and its wave number times the length.
struct Shape {
  double wave_number;
  std::function<double(double)> deflection;  ///< of the share of the length
};

/// The zeros of cosh(u) cos(u) + sign: where the determinant of the support conditions vanishes. One lies between each
/// two neighbouring multiples of pi, whose cosines have opposite signs.
double wave_number(int mode, double sign) {
  const auto determinant = [&](double u) { return std::cos(u) + sign / std::cosh(u); };
  double low = mode * pi, high = (mode + 1) * pi;
  const bool rises = determinant(high) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((determinant(middle) > 0) == rises ? high : low) = middle;
  }
  return low;
}

/// Euler and Bernoulli's cantilever: cosh(u) cos(u) = -1.
Shape cantilever_shape(int mode) {
  const double u = wave_number(mode, 1);
  const double mix = (std::cosh(u) + std::cos(u)) / (std::sinh(u) + std::sin(u));
  return {u, [u, mix](double s) {
            return std::cosh(u * s) - std::cos(u * s) - mix * (std::sinh(u * s) - std::sin(u * s));
          }};
}

/// A beam with free ends: cosh(u) cos(u) = 1.
Shape free_shape(int mode) {
  const double u = wave_number(mode + 1, -1);
  const double mix = (std::cosh(u) - std::cos(u)) / (std::sinh(u) - std::sin(u));
  return {u, [u, mix](double s) {
            return std::cosh(u * s) + std::cos(u * s) - mix * (std::sinh(u * s) + std::sin(u * s));
          }};
}

/// Angular frequency [1/s] of a yarn that starts with small velocities in a shape, from the times at which its part in
/// that shape passes zero.
double measured_frequency(const Shape& shape, bool is_clamped) {
  Yarn yarn(80, 0.9);
  std::vector<double> share(yarn.model.nodes.size());
  for (std::size_t i = 0; i < share.size(); ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(yarn.tip());
    share[i] = shape.deflection(s);
    yarn.state.velocity.y[i] = share[i];
    yarn.state.angular_velocity.z[i] = (shape.deflection(s + 1e-5) - shape.deflection(s - 1e-5)) / (2e-5 * kLength);
  }
  if (is_clamped) {
    yarn.state.velocity.y[0] = 0;
    yarn.state.angular_velocity.z[0] = 0;
  }
  int passed = 0;
  double before = 0, first = 0, last = 0;
  while (passed < 5 && yarn.state.time < 0.1) {
    yarn.advance([&](model::NodalLoads& loads) {
      if (is_clamped) clamp_start(loads);
    });
    double part = 0;
    for (std::size_t i = 0; i < share.size(); ++i) part += yarn.inertia.mass[i] * share[i] * yarn.state.position.y[i];
    if (before * part < 0) {
      last = yarn.state.time - yarn.step * part / (part - before);
      if (passed++ == 0) first = last;
    }
    before = part;
  }
  return pi * (passed - 1) / (last - first);
}

TEST(BendingVibration, GivenAYarnClampedOrFree_ThenItsLowestThreeFrequenciesAreThoseOfEulerAndBernoulli) {
  EXPECT_NEAR(wave_number(0, 1), 1.8751, 1e-4);  // as tabulated everywhere
  EXPECT_NEAR(wave_number(1, -1), 4.7300, 1e-4);
  const double unit = std::sqrt(test::kBending / test::kMassPerLength) / (kLength * kLength);
  for (const bool is_clamped : {true, false}) {
    for (int mode = 0; mode < 3; ++mode) {
      const Shape shape = is_clamped ? cantilever_shape(mode) : free_shape(mode);
      test::verify({.chapter = "bending vibration",
                    .of = fmt::format("{}, mode {}, 80 elements", is_clamped ? "clamped and free" : "free", mode + 1),
                    .quantity = "frequency [Hz]",
                    .source = is_clamped ? "cosh(u) cos(u) = -1" : "cosh(u) cos(u) = 1",
                    .reference = shape.wave_number * shape.wave_number * unit / (2 * pi),
                    .computed = measured_frequency(shape, is_clamped) / (2 * pi),
                    .tolerance = 0.005});
    }
  }
}

}  // namespace
}  // namespace knitmech
