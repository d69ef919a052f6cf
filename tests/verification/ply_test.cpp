// A twisted yarn under tension that winds up into a two-strand ply with a loop at its end, as a snarl does.

#include <gtest/gtest.h>

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

constexpr double kAngle = 0.3;          // rad, of the strands against the axis of the ply, where it starts
constexpr double kTurns = 4;            // of the ply
constexpr int kElementsPerTurn = 14;    // of a strand
constexpr double kAxialStiffness = 60;  // N, so that stretching plays no part
constexpr double kTail = 2;             // mm
constexpr double kBend = 0.4;           // mm, radius where the tails turn into the ply
constexpr double kLoop = 0.35;          // mm, radius of the loop at the end of the ply
constexpr double kRate = 1e4;           // 1/s, damping

struct Ply {
  yarn::Section section = test::section(kAxialStiffness, kAxialStiffness / 3, 0.0173039, 0.0124488, 1.29e-11, 0.12);
  double bending = section.bending_stiffness;
  double radius = 0.5 * section.diameter;
  double pitch = 2 * pi * radius / std::tan(kAngle);  ///< [mm] per turn
};

/// F R^2 / B of a ply with this angle, sin^3 a (cos a tan 2a - sin a / 2): the tension in the tails, T + B k^2 / 2 of
/// the strands, for strands that carry the ply's axial force and torque of zero.
double theory(double angle) {
  return std::pow(std::sin(angle), 3) * (std::cos(angle) * std::tan(2 * angle) - std::sin(angle) / 2);
}

/// Half of the yarn: a tail along x, a bend into z, the helix, and half of the loop up to the axis.
std::vector<Eigen::Vector3d> drawn_half(const Ply& ply) {
  constexpr double kFine = 0.002;  // mm
  std::vector<Eigen::Vector3d> line;
  for (double x = ply.radius + kBend + kTail; x > ply.radius + kBend; x -= kFine) line.emplace_back(x, 0, 0);
  for (double a = 0; a < pi / 2; a += kFine / kBend) {
    line.emplace_back(ply.radius + kBend * (1 - std::sin(a)), 0, kBend * (1 - std::cos(a)));
  }
  const double turned = 2 * pi * kTurns;
  for (double a = 0; a < turned; a += kFine * std::sin(kAngle) / ply.radius) {
    line.emplace_back(ply.radius * std::cos(a), ply.radius * std::sin(a), kBend + ply.pitch * a / (2 * pi));
  }
  // Two arcs of one radius, the first about a place outside, the second about one on the axis.
  const double top = kBend + ply.pitch * kTurns;
  const double middle = top + std::sqrt(4 * kLoop * kLoop - std::pow(ply.radius + kLoop, 2));
  const double outward = std::asin((middle - top) / (2 * kLoop));
  const auto add = [&](double r, double z) { line.emplace_back(r * std::cos(turned), r * std::sin(turned), z); };
  for (double a = 0; a < outward; a += kFine / kLoop) {
    add(ply.radius + kLoop * (1 - std::cos(a)), top + kLoop * std::sin(a));
  }
  for (double a = -outward; a < pi / 2; a += kFine / kLoop) add(kLoop * std::cos(a), middle + kLoop * std::sin(a));
  return line;
}

/// The whole yarn, twisted so far that it holds the ply: a torque M = -2 B sin^3 a cos a / (R cos 2a).
test::ContactBench plied_yarn(const Ply& ply, model::Centreline centreline) {
  std::vector<Eigen::Vector3d> line = drawn_half(ply);
  for (std::size_t i = line.size(); i-- > 0;) line.emplace_back(-line[i].x(), -line[i].y(), line[i].z());
  const double length = test::length_of(line);
  const double element = 2 * pi * ply.radius / std::sin(kAngle) / kElementsPerTurn;
  const int n = static_cast<int>(std::lround(length / element));
  model::Model model = test::empty_model(ply.section, 0, 16, centreline);
  test::add_yarn(model, test::straight_shape({0, 0, 0}, {length, 0, 0}, n));
  test::ContactBench bench(model);
  const std::vector<test::Place> places = test::resample(line, bench.model.arc_length);
  test::bend_to(bench.model, 0, places, bench.state);
  const double torque =
      -2 * ply.bending * std::pow(std::sin(kAngle), 3) * std::cos(kAngle) / (ply.radius * std::cos(2 * kAngle));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double turned = torque / ply.section.torsional_stiffness * bench.model.arc_length[i];
    test::set_rotation(bench.state, i, test::turn(turned * places[i].tangent) * test::rotation_of(bench.state, i));
  }
  return bench;
}

struct Shape {
  double angle, radius;
};

/// Angle and radius of the strands in the middle third of the ply: a line through their turning over height.
Shape shape_of(const test::ContactBench& bench, const Ply& ply) {
  const double from = kBend + 0.35 * kTurns * ply.pitch;
  const double to = kBend + 0.65 * kTurns * ply.pitch;
  double n = 0, z = 0, turned = 0, zz = 0, z_turned = 0, radius_squared = 0, here = 0, before = 0;
  for (std::size_t i = 0; i <= bench.last_node(0) / 2; ++i) {
    const Eigen::Vector3d at = test::vector_at(bench.state.position, i);
    if (at.z() < from || at.z() > to) continue;
    const double angle = std::atan2(at.y(), at.x());
    if (n > 0) here += std::remainder(angle - before, 2 * pi);
    before = angle;
    n += 1;
    z += at.z();
    turned += here;
    zz += at.z() * at.z();
    z_turned += at.z() * here;
    radius_squared += at.head<2>().squaredNorm();
  }
  const double radius = std::sqrt(radius_squared / n);
  return {std::atan(radius * (n * z_turned - z * turned) / (n * zz - z * z)), radius};
}

class TwoStrandPly : public testing::TestWithParam<model::Centreline> {};
KNITMECH_WITH_EVERY_CENTRELINE(TwoStrandPly);

TEST_P(TwoStrandPly, GivenTensionAndTwist_ThenTheAngleOfTheStrandsIsThatOfTheTheory) {
  const Ply ply;
  test::ContactBench bench = plied_yarn(ply, GetParam());
  const double tension = ply.bending / (ply.radius * ply.radius) * theory(kAngle);
  const std::size_t last = bench.last_node(0);
  const long n_steps = std::lround(9 / (kRate * bench.step));
  double largest = 0;
  for (long i = 0; i < n_steps; ++i) {
    bench.advance(
        [&](const model::State&, model::NodalLoads& loads) {
          for (const std::size_t end : {std::size_t{0}, last}) {  // pulled along x, held across it and against turning
            loads.force.set(end, {loads.force.x[end] + (end == 0 ? tension : -tension), 0, 0});
            loads.moment.set(end, {0, 0, 0});
          }
        },
        2 * kRate);
    largest = std::max(largest, solve::largest_speed_squared(bench.state));
  }
  EXPECT_LT(std::sqrt(solve::largest_speed_squared(bench.state) / largest), 1e-3);
  const Shape shape = shape_of(bench, ply);
  const bool on_chords = GetParam() == model::Centreline::chords;
  test::verify({.chapter = "ply",
                .of = "four turns at about 0.3 rad, " + test::name_of(GetParam()),
                .quantity = "F R^2 / B [-]",
                .source = "sin^3 a (cos a tan 2a - sin a / 2)",
                .reference = theory(shape.angle),
                .computed = tension * shape.radius * shape.radius / ply.bending,
                .tolerance = test::allowed(GetParam(), 0.07, 0.03),
                .remark = on_chords ? "the edges of the chords hook into each other"
                                    : "R the radius of the helix, strands soft in shear"});
  test::verify({.chapter = "ply",
                .of = "four turns at about 0.3 rad, " + test::name_of(GetParam()),
                .quantity = "radius of the helix over that of the yarn [-]",
                .source = "touching yarns",
                .reference = 1,
                .computed = shape.radius / ply.radius,
                .tolerance = 0.05});
}

}  // namespace
}  // namespace knitmech
