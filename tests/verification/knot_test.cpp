// An overhand knot in a long straight yarn, pulled at both ends: its loop and its braid.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "../support/centrelines.h"
#include "../support/contact_bench.h"
#include "../support/resample.h"
#include "../support/verification.h"

namespace knitmech {
namespace {

using std::numbers::pi;

// The yarn has the radius h = 1 mm, the bending stiffness B = 1 N mm^2 and the mass of 1 t/mm; only ratios matter.

constexpr double kStepShare = 0.25;  // of the stable step of the beams: the drawn strands press hard at first

/// A knot of looseness e = sqrt(h / R), the radius R of its loop being the shortening of the yarn over 2 pi.
struct Knot {
  double looseness;  ///< e [-]
  [[nodiscard]] double loop_radius() const { return 1 / (looseness * looseness); }
  [[nodiscard]] double half_braid() const { return 1.5 * looseness * loop_radius(); }
  [[nodiscard]] double tail() const { return 5 * loop_radius(); }
  [[nodiscard]] double pull_in_theory() const { return std::pow(looseness, 4) / 2; }  ///< F, without friction
};

/// The knot as it is tied at first: a tail, three half turns of the braid, a loop of two half circles, the braid once
/// more, the other tail.
std::vector<Eigen::Vector3d> drawn(const Knot& knot) {
  constexpr double kFine = 0.01;   // mm
  constexpr double kApart = 1.15;  // half the distance of the strands in the braid
  const double b = knot.half_braid();
  const double bend = knot.loop_radius() - 2 * b / pi;
  std::vector<Eigen::Vector3d> line;
  const auto strand = [&](double side) {
    for (double x = -b; x < b; x += kFine) {
      const double turned = 3 * pi * (x + b) / (2 * b);
      line.emplace_back(x, -side * kApart * std::cos(turned), -side * kApart * std::sin(turned));
    }
  };
  const auto half_circle = [&](double middle, double from) {
    for (double a = from; a < from + pi; a += kFine / bend) {
      line.emplace_back(middle + bend * std::sin(a), kApart + bend * (1 - std::cos(a)), 0);
    }
  };
  for (double x = -b - knot.tail(); x < -b; x += kFine) line.emplace_back(x, -kApart, 0);
  strand(1);
  half_circle(b, 0);
  for (double x = b; x > -b; x -= kFine) line.emplace_back(x, kApart + 2 * bend, 0);
  half_circle(-b, pi);
  strand(-1);
  for (double x = b; x < b + knot.tail(); x += kFine) line.emplace_back(x, -kApart, 0);
  return line;
}

/// Arc lengths of the nodes: close in the braid, wide elsewhere.
std::vector<double> node_places(const Knot& knot, double length) {
  const double close = 0.3 / knot.looseness;
  const double wide = 4 * close;
  const double braid = 3 * knot.half_braid();  // with room for the knot to change its shape
  std::vector<double> places{0};
  while (places.back() < length) {
    const double from_middle = std::abs(places.back() - length / 2);
    const bool is_braid = std::abs(from_middle - (pi * knot.loop_radius())) < braid;
    places.push_back(places.back() + (is_braid ? close : wide));
  }
  for (double& place : places) place *= length / places.back();
  return places;
}

struct Tied {
  test::ContactBench bench;
  double length;  ///< [mm], of the yarn

  [[nodiscard]] double loop_radius() const {
    const Eigen::Vector3d start = test::vector_at(bench.state.position, 0);
    const Eigen::Vector3d end = test::vector_at(bench.state.position, bench.last_node(0));
    return (length - (end - start).norm()) / (2 * pi);
  }
  [[nodiscard]] double pull() const { return 0.5 * (bench.tension(0) + bench.tension(bench.last_node(0) - 1)); }
  /// Sum of the forces with which the strands press on each other.
  [[nodiscard]] double pressure() {
    static_cast<void>(bench.contact_loads());
    double sum = 0;
    for (const contact::ContactPoint& point : bench.contact.points()) sum += point.load;
    return sum;
  }
};

Tied tie(const Knot& knot, double friction, model::Centreline centreline) {
  const std::vector<Eigen::Vector3d> line = drawn(knot);
  const double length = test::length_of(line);
  const double axial = 4000 * knot.pull_in_theory();
  const yarn::Section section = test::section(axial, axial / 3, 1, 0.77, 1, 2);
  model::Model model = test::empty_model(section, friction, 0.3 * axial * knot.looseness, centreline);
  const std::vector<double> nodes = node_places(knot, length);
  test::YarnShape straight;
  for (const double s : nodes) straight.places.push_back({{s, 0, 0}, Eigen::Vector3d::UnitX()});
  straight.arc_length = nodes;
  test::add_yarn(model, straight);
  Tied tied{test::ContactBench(model, kStepShare), length};
  test::bend_to(tied.bench.model, 0, test::resample(line, nodes), tied.bench.state);
  return tied;
}

/// Lets a knot come to rest, or pulls its ends apart. \param speed of each end [mm/s]   \param time [s]
void hold_or_pull(Tied& knot, double damping, double speed, double time) {
  test::ContactBench& bench = knot.bench;
  const std::size_t last = bench.last_node(0);
  const long n_steps = std::lround(time / bench.step);
  for (long i = 0; i < n_steps; ++i) {
    bench.advance(
        [&](const model::State&, model::NodalLoads& loads) {
          for (const std::size_t end : {std::size_t{0}, last}) {
            loads.force.x[end] = 0;
            bench.state.velocity.x[end] = end == 0 ? -speed : speed;
          }
        },
        damping);
  }
}

struct Measured {
  double looseness;  ///< e [-]
  double pull;       ///< F R^2 / B [-]
  double pressure;   ///< P h^2 / (B e^3) [-]
};

Measured measure(Tied& knot) {
  const double e = 1 / std::sqrt(knot.loop_radius());
  return {e, knot.pull() * std::pow(e, -4), knot.pressure() * std::pow(e, -3)};
}

/// Half the critical damping of the loop as a spring [1/s].
double rate_of(const Knot& knot) {
  return 0.4 / (knot.loop_radius() * knot.loop_radius());
}

/// Value at e = 0 of the parabola that fits numbers at several e best.
double at_zero(const std::vector<Measured>& knots, double Measured::*number) {
  const auto n = static_cast<Eigen::Index>(knots.size());
  Eigen::MatrixX3d powers(n, 3);
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Measured& knot = knots[static_cast<std::size_t>(i)];
    powers.row(i) << 1, knot.looseness, knot.looseness * knot.looseness;
    values[i] = knot.*number;
  }
  return powers.colPivHouseholderQr().solve(values)[0];
}

class OverhandKnot : public testing::TestWithParam<model::Centreline> {
 protected:
  [[nodiscard]] static std::string here(const std::string& of) { return of + ", " + test::name_of(GetParam()); }
};
KNITMECH_WITH_EVERY_CENTRELINE(OverhandKnot);

TEST_P(OverhandKnot, GivenEverLooserKnotsWithoutFriction_ThenPullAndPressureTendToTheTheory) {
  std::vector<Measured> knots;
  for (const double looseness : {0.07, 0.1, 0.14, 0.2, 0.3}) {
    const Knot knot{looseness};
    Tied tied = tie(knot, 0, GetParam());
    hold_or_pull(tied, 2 * rate_of(knot), 0, 10 / rate_of(knot));
    knots.push_back(measure(tied));
    test::verify({.chapter = "knot",
                  .of = here(fmt::format("e = {:.2f}, no friction", knots.back().looseness)),
                  .quantity = "F R^2 / B [-]",
                  .source = "1/2 as e tends to 0",
                  .reference = 0.5,
                  .computed = knots.back().pull,
                  .tolerance = 2.5 * looseness,
                  .remark = "the theory is the first term of an expansion in e"});
  }
  test::verify({.chapter = "knot",
                .of = here("extrapolated to e = 0"),
                .quantity = "F R^2 / B [-]",
                .source = "1/2",
                .reference = 0.5,
                .computed = at_zero(knots, &Measured::pull),
                .tolerance = test::allowed(GetParam(), 0.1, 0.05),
                .remark = "parabola through the rows above"});
  test::verify({.chapter = "knot",
                .of = here("extrapolated to e = 0"),
                .quantity = "contact force of the strands, P h^2 / (B e^3) [-]",
                .source = "0.492",
                .reference = 0.492,
                .computed = at_zero(knots, &Measured::pressure),
                .tolerance = test::allowed(GetParam(), 0.15, 0.13),
                .remark = "parabola through the same knots, whose pressure bends the more the looser they are"});
}

TEST_P(OverhandKnot, GivenAKnotThatIsPulledTight_ThenFrictionAddsMuTimesThePressure) {
  constexpr double kFriction = 0.1;
  constexpr double kLooseness = 0.2;
  constexpr double kTime = 5e4;  // s, so that inertia and damping are a hundredth of the pull
  const Knot knot{kLooseness};
  Tied smooth_yarn = tie(knot, 0, GetParam());
  hold_or_pull(smooth_yarn, 2 * rate_of(knot), 0, 10 / rate_of(knot));
  const double without = smooth_yarn.pull();

  const Knot looser{0.98 * kLooseness};
  Tied tied = tie(looser, kFriction, GetParam());
  const double speed = pi * (tied.loop_radius() - smooth_yarn.loop_radius()) / kTime;
  hold_or_pull(tied, 2 * rate_of(knot), 0, 5 / rate_of(knot));
  hold_or_pull(tied, 2 * rate_of(knot), speed, 0.9 * kTime);
  double pull = 0;
  double pressure = 0;
  constexpr int kLooks = 50;
  for (int i = 0; i < kLooks; ++i) {
    hold_or_pull(tied, 2 * rate_of(knot), speed, 0.1 * kTime / kLooks);
    pull += tied.pull() / kLooks;
    pressure += tied.pressure() / kLooks;
  }
  test::verify({.chapter = "knot",
                .of = here("e = 0.2, mu = 0.1"),
                .quantity = "force added by friction over mu P [-]",
                .source = "work of friction",
                .reference = 1,
                .computed = (pull - without) / (kFriction * pressure),
                .tolerance = 0.05});
}

}  // namespace
}  // namespace knitmech
