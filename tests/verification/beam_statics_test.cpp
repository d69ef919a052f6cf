// Beams at rest under large deformation, against theory.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "../support/beam_case.h"
#include "../support/monofilament.h"
#include "../support/relax.h"
#include "../support/rod_shooting.h"
#include "../support/stiffness.h"
#include "../support/verification.h"

namespace knitmech {
namespace {

/// Tip of a clamped elastica of unit length.
struct Tip {
  double along = 0, across = 0;  ///< position along and across its axis at the clamp, over the length [-]
};

/// Under a dead load across it, P L^2 / EI = load, by shooting: integrate theta'' = -load cos(theta) from the clamp
/// (theta = 0, theta' = m) and choose m so that theta' = 0 at the tip.
Tip elastica_tip(double load) {
  const int n = 4000;
  const double h = 1.0 / n;
  Tip tip;
  const auto tip_curvature = [&](double m) {
    double theta = 0;
    double slope = m;
    tip = {};
    for (int i = 0; i < n; ++i) {  // fourth-order Runge-Kutta
      const auto f = [&](double t) { return -load * std::cos(t); };
      const double k1 = slope, l1 = f(theta);
      const double k2 = slope + 0.5 * h * l1, l2 = f(theta + 0.5 * h * k1);
      const double k3 = slope + 0.5 * h * l2, l3 = f(theta + 0.5 * h * k2);
      const double k4 = slope + h * l3, l4 = f(theta + h * k3);
      const double next = theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      const double middle = theta + 0.5 * h * k2;
      tip.across += h / 6 * (std::sin(theta) + 4 * std::sin(middle) + std::sin(next));
      tip.along += h / 6 * (std::cos(theta) + 4 * std::cos(middle) + std::cos(next));
      theta = next;
      slope += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
    return slope;
  };
  double low = 0;
  double high = std::sqrt(2 * load);  // theta at the tip stays below 90 degrees
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (tip_curvature(middle) > 0 ? high : low) = middle;
  }
  return tip;
}

TEST(Elastica, GivenTheLoadsOfTheLiterature_ThenTheShootingReferenceAgrees) {
  // Bisshopp and Drucker 1945, doi:10.1090/qam/13360
  EXPECT_NEAR(elastica_tip(1).across, 0.30172, 1e-5);
  EXPECT_NEAR(elastica_tip(2).across, 0.49346, 1e-5);
  EXPECT_NEAR(elastica_tip(5).across, 0.71379, 1e-5);
  EXPECT_NEAR(elastica_tip(10).across, 0.81061, 1e-5);
  EXPECT_NEAR(elastica_tip(1).along, 1 - 0.05643, 1e-5);
  EXPECT_NEAR(elastica_tip(10).along, 1 - 0.55500, 1e-5);
}

constexpr double kAtRest = 1e-6;

/// A clamped yarn of length 10 mm, D = 0.12 mm, under a dead tip load.
Tip cantilever_tip(double load, int n_elements) {
  const double length = 10;
  const model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {length, 0, 0}, n_elements)}, test::monofilament());
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  const auto tip = static_cast<std::size_t>(n_elements);
  const double left =
      test::relax(elements, state, test::slowest_frequency(test::kBending, test::kMassPerLength, length),
                  [&](const model::State&, model::NodalLoads& loads) {
                    test::clamp(loads, 0);
                    loads.force.y[tip] += load * test::kBending / (length * length);
                  });
  EXPECT_LT(left, kAtRest);
  return {state.position.x[tip] / length, state.position.y[tip] / length};
}

TEST(Cantilever, GivenADeadTipLoad_ThenItsTipIsWhereTheElasticaHasIt) {
  for (const double load : {0.25, 1.0, 2.0, 5.0, 10.0, 20.0}) {
    const Tip reference = elastica_tip(load);
    const Tip computed = cantilever_tip(load, 40);
    const std::string of = fmt::format("P L^2 / EI = {}, 40 elements", load);
    test::verify({.chapter = "cantilever",
                  .of = of,
                  .quantity = "deflection over length [-]",
                  .source = "elastica, by shooting",
                  .reference = reference.across,
                  .computed = computed.across,
                  .tolerance = 1e-3});
    test::verify({.chapter = "cantilever",
                  .of = of,
                  .quantity = "place along the clamp's axis over length [-]",
                  .source = "elastica, by shooting",
                  .reference = reference.along,
                  .computed = computed.along,
                  .tolerance = 2e-3});
  }
}

TEST(Cantilever, GivenFinerMeshes_ThenTheDeflectionConvergesWithTheSquareOfTheElementLength) {
  const double coarse = cantilever_tip(2, 10).across;
  const double middle = cantilever_tip(2, 20).across;
  const double fine = cantilever_tip(2, 40).across;
  test::verify({.chapter = "cantilever",
                .of = "P L^2 / EI = 2, 10 to 40 elements",
                .quantity = "order of convergence [-]",
                .source = "linear elements",
                .reference = 2,
                .computed = std::log2((coarse - middle) / (middle - fine)),
                .tolerance = 0.05});
}

TEST(RollUp, GivenAnEndMomentOf2PiEIOverL_ThenTheYarnClosesToACircle) {
  // M = 2 pi EI / L: constant curvature 2 pi / L, tip back at the clamp.
  const int n = 40;
  const double length = 10;
  const model::Model model = test::yarns_through({test::straight({0, 0, 0}, {length, 0, 0}, n)}, test::monofilament());
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  long steps = 0;
  const double left =
      test::relax(elements, state, test::slowest_frequency(test::kBending, test::kMassPerLength, length),
                  [&](const model::State&, model::NodalLoads& loads) {
                    const double share =
                        std::min(1.0, static_cast<double>(++steps) / 20000);  // grows, so that the yarn rolls up once
                    test::clamp(loads, 0);
                    loads.moment.z[n] += share * 2 * std::numbers::pi * test::kBending / length;
                  });
  EXPECT_LT(left, kAtRest);
  test::verify({.chapter = "roll-up",
                .of = "40 elements",
                .quantity = "distance of the ends over length [-]",
                .source = "closed circle",
                .computed = test::vector_at(state.position, n).norm() / length,
                .tolerance = 0.01,
                .scale = 1});
  // The farthest node is the diameter away. One integration point: straight chords of a circle, so 1 / cos(pi / n) at
  // most.
  const double diameter = length / std::numbers::pi;
  test::verify({.chapter = "roll-up",
                .of = "40 elements",
                .quantity = "diameter [mm]",
                .source = "length / pi",
                .reference = diameter,
                .computed = state.position.y[n / 2],
                .tolerance = 0.005});
}

/// A short beam as a row of elements: its deflection under a small load, from the stiffness of the straight state.
double short_beam_deflection(double length, int n_elements) {
  const model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {length, 0, 0}, n_elements)}, test::monofilament());
  const test::Freedom freedom = test::Freedom::without(model.nodes.size(), {0, 1, 2, 3, 4, 5});
  const Eigen::MatrixXd stiffness = freedom.matrix.transpose() *
                                    test::stiffness_of(beam::make_elements(model, 1.0, 0.0), test::state_of(model)) *
                                    freedom.matrix;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(stiffness.rows());
  const Eigen::Index tip = load.size() - 5;  // along y
  load[tip] = 1;
  return stiffness.ldlt().solve(load)[tip];
}

/// Timoshenko's cantilever, P L^3 / (3 EI) + P L / (k G A), with the shear stiffness of the section: the elements work
/// with less of it (see beam/elements.h), but that and what they lack in bending both vanish with the square of their
/// length and nearly cancel. A row of n elements gives exactly, for EA / EI in place of A / I,
///
///     P L^3 / (3 EI) (1 - 1 / (4 n^2)) + P L / (k G A) (1 + EA L^2 / (48 EI n^2)).
TEST(ShortBeam, GivenABeamAFewDiametersLong_ThenShearAddsToItsDeflectionAsTimoshenkoHasIt) {
  for (const double diameters : {1.0, 2.0, 5.0}) {
    const double length = diameters * test::kMonofilamentDiameter;
    const double by_bending = std::pow(length, 3) / (3 * test::kBending);
    const double by_shear = length / test::kShear;
    const std::string of = fmt::format("length {} diameters", diameters);
    test::verify({.chapter = "short beam",
                  .of = of + ", 10 elements",
                  .quantity = "deflection over load [mm/N]",
                  .source = "L^3 / 3EI + L / kGA",
                  .reference = by_bending + by_shear,
                  .computed = short_beam_deflection(length, 10),
                  .tolerance = 1e-3,
                  .remark = fmt::format("{:.0f} % of it is shear", 100 * by_shear / (by_bending + by_shear))});
    const double reduced = 1 + test::kAxial * length * length / (48 * test::kBending * 4);
    EXPECT_NEAR(short_beam_deflection(length, 2), by_bending * (1 - 1.0 / 16) + by_shear * reduced, 1e-7 * by_bending);
  }
}

TEST(ShortBeam, GivenFinerMeshes_ThenTheDeflectionConvergesWithTheSquareOfTheElementLength) {
  const double length = 2 * test::kMonofilamentDiameter;
  const double reference = std::pow(length, 3) / (3 * test::kBending) + length / test::kShear;
  test::verify({.chapter = "short beam",
                .of = "length 2 diameters, 2 and 4 elements",
                .quantity = "order of convergence [-]",
                .source = "linear elements",
                .reference = 2,
                .computed = std::log2((short_beam_deflection(length, 2) - reference) /
                                      (short_beam_deflection(length, 4) - reference)),
                .tolerance = 0.01});
}

/// Half the height and half the width of a ring that two opposite forces pull or press on.
struct HalfRing {
  double height, width;
};

constexpr double kRingRadius = 2;  // [mm]

/// A quarter of the ring as elements, from the side (tangent along y) to the place of the force.
HalfRing pinched_ring(double half_force) {
  const int n = 40;
  std::vector<Eigen::Vector3d> nodes;
  for (int i = 0; i <= n; ++i) {
    const double angle = std::numbers::pi / 2 * i / n;
    nodes.emplace_back(kRingRadius * std::cos(angle), kRingRadius * std::sin(angle), 0.0);
  }
  const model::Model model = test::yarns_through({nodes}, test::monofilament());
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  const double slowest = test::slowest_frequency(test::kBending, test::kMassPerLength, std::numbers::pi * kRingRadius);
  const double left = test::relax(elements, state, slowest, [&](const model::State&, model::NodalLoads& loads) {
    loads.moment.set(0, {0, 0, 0});  // by symmetry neither end turns ...
    loads.moment.set(n, {0, 0, 0});
    loads.force.set(0, {loads.force.x[0], 0, 0});  // ... and each moves along its own axis
    loads.force.set(n, {0, loads.force.y[n] + half_force, 0});
  });
  EXPECT_LT(left, kAtRest);
  return {state.position.y[n] - state.position.y[0], state.position.x[0] - state.position.x[n]};
}

/// The same by shooting. No force acts across the symmetry axes, so half the force is the internal force everywhere;
/// the moment at the side makes the quarter turn by a right angle.
HalfRing pinched_ring_by_shooting(double half_force) {
  const test::ShootingRod rod{.length = std::numbers::pi / 2 * kRingRadius,
                              .axial = test::kAxial,
                              .shear = test::kShear,
                              .torsion = test::kTorsion,
                              .bending = test::kBending,
                              .natural_curvature = {0, 0, 1 / kRingRadius}};
  Eigen::Matrix3d along_y;
  along_y << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  double force = 0;
  const auto top = [&](double moment) {
    return shoot(rod, {.directors = along_y, .moment = {0, 0, moment}}, {0, force, 0});
  };
  const auto missing_turn = [&](double moment) {
    const Eigen::Vector3d tangent = top(moment).directors.col(0);
    return std::atan2(tangent.y(), -tangent.x());
  };
  double moment = 0;
  for (int step = 1; step <= 20; ++step) {  // the force grows, so that the ring takes no other shape
    force = half_force * step / 20;
    moment = test::root_of(missing_turn, moment, moment - 0.01 * half_force * kRingRadius);
  }
  const test::RodSection end = top(moment);
  EXPECT_LT(std::abs(end.directors(1, 0)), 1e-6);
  return {end.position.y(), -end.position.x()};
}

TEST(PinchedRing, GivenTwoOppositeForces_ThenTheRingTakesTheShapeOfTheRodOfShooting) {
  const double unit = test::kBending / (kRingRadius * kRingRadius);
  for (const double force : {-2.0, -0.5, 2.0, 10.0}) {
    const HalfRing reference = pinched_ring_by_shooting(0.5 * force * unit);
    const HalfRing computed = pinched_ring(0.5 * force * unit);
    const std::string of = fmt::format("F R^2 / EI = {}, 40 elements on a quarter", force);
    test::verify({.chapter = "pinched ring",
                  .of = of,
                  .quantity = "half the height [mm]",
                  .source = "rod by shooting",
                  .reference = reference.height,
                  .computed = computed.height,
                  .tolerance = 1e-3});
    test::verify({.chapter = "pinched ring",
                  .of = of,
                  .quantity = "half the width [mm]",
                  .source = "rod by shooting",
                  .reference = reference.width,
                  .computed = computed.width,
                  .tolerance = 1e-3});
  }
}

TEST(PinchedRing, GivenASmallForce_ThenTheShootingReferenceAgreesWithCastigliano) {
  // The diameter changes by F R^3 / EI (pi / 4 - 2 / pi), without stretch and shear.
  const double force = 1e-4 * test::kBending / (kRingRadius * kRingRadius);
  const double expected = 1e-4 * kRingRadius * (std::numbers::pi / 4 - 2 / std::numbers::pi);
  EXPECT_NEAR(2 * (pinched_ring_by_shooting(0.5 * force).height - kRingRadius), expected, 0.01 * expected);
}

}  // namespace
}  // namespace knitmech
