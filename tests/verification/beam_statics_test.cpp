// Beams at rest under large deformation, against theory.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../support/beam_case.h"
#include "../support/relax.h"
#include "../support/verification.h"

namespace knitmech {
namespace {

/// Tip deflection v / L of a clamped elastica under a dead tip load, P L^2 / EI = load, by shooting: integrate
/// theta'' = -load cos(theta) from the clamp (theta = 0, theta' = m) and choose m so that theta' = 0 at the tip.
double elastica_deflection(double load) {
  const int n = 4000;
  const double h = 1.0 / n;
  double deflection = 0;
  const auto tip_curvature = [&](double m) {
    double theta = 0;
    double slope = m;
    deflection = 0;
    for (int i = 0; i < n; ++i) {  // fourth-order Runge-Kutta
      const auto f = [&](double t) { return -load * std::cos(t); };
      const double k1 = slope, l1 = f(theta);
      const double k2 = slope + 0.5 * h * l1, l2 = f(theta + 0.5 * h * k1);
      const double k3 = slope + 0.5 * h * l2, l3 = f(theta + 0.5 * h * k2);
      const double k4 = slope + h * l3, l4 = f(theta + h * k3);
      const double next = theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      deflection += h / 6 * (std::sin(theta) + 4 * std::sin(theta + 0.5 * h * k2) + std::sin(next));
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
  return deflection;
}

TEST(Elastica, GivenTheLoadsOfTheLiterature_ThenTheShootingReferenceAgrees) {
  // Bisshopp and Drucker 1945, doi:10.1090/qam/13360
  EXPECT_NEAR(elastica_deflection(1), 0.30172, 1e-5);
  EXPECT_NEAR(elastica_deflection(2), 0.49346, 1e-5);
  EXPECT_NEAR(elastica_deflection(5), 0.71379, 1e-5);
  EXPECT_NEAR(elastica_deflection(10), 0.81061, 1e-5);
}

/// Lowest angular frequency of a clamped beam, 3.516 sqrt(EI / (rho A L^4)) [1/s].
double slowest_frequency(double bending, double mass_per_length, double length) {
  return 3.516 * std::sqrt(bending / mass_per_length) / (length * length);
}

constexpr double kAtRest = 1e-6;

/// A clamped yarn of length 10 mm, D = 0.12 mm, under a dead tip load.
double cantilever_deflection(double load, int n_elements) {
  const double length = 10;
  const double bending = 0.0173039;
  const model::Model model = test::yarns_through({test::straight({0, 0, 0}, {length, 0, 0}, n_elements)},
                                                 test::section(19.2265, 6.17, bending, 0.0124488, 1.29e-11));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  const auto tip = static_cast<std::size_t>(n_elements);
  const double left = test::relax(elements, state, slowest_frequency(bending, 1.29e-11, length),
                                  [&](const model::State&, model::NodalLoads& loads) {
                                    test::clamp(loads, 0);
                                    loads.force.y[tip] += load * bending / (length * length);
                                  });
  EXPECT_LT(left, kAtRest);
  return state.position.y[tip] / length;
}

TEST(Cantilever, GivenADeadTipLoad_ThenItsDeflectionIsThatOfTheElastica) {
  for (const double load : {0.25, 1.0, 2.0, 5.0, 10.0}) {
    test::verify({.chapter = "cantilever",
                  .of = fmt::format("P L^2 / EI = {}, 40 elements", load),
                  .quantity = "deflection over length [-]",
                  .source = "elastica, by shooting",
                  .reference = elastica_deflection(load),
                  .computed = cantilever_deflection(load, 40),
                  .tolerance = 1e-3});
  }
}

TEST(Cantilever, GivenFinerMeshes_ThenTheDeflectionConvergesWithTheSquareOfTheElementLength) {
  const double coarse = cantilever_deflection(2, 10);
  const double middle = cantilever_deflection(2, 20);
  const double fine = cantilever_deflection(2, 40);
  test::verify({.chapter = "cantilever",
                .of = "P L^2 / EI = 2, 10 to 40 elements",
                .quantity = "order of convergence [-]",
                .source = "linear elements",
                .reference = 2,
                .computed = std::log2((coarse - middle) / (middle - fine)),
                .tolerance = 0.05});
}

/// Bathe and Bolourchi's 45-degree bend of radius 100 in a plane, clamped, loaded across the plane at its tip.
Eigen::Vector3d bend_tip(double load, int n_elements) {
  std::vector<Eigen::Vector3d> nodes;
  for (int i = 0; i <= n_elements; ++i) {
    const double angle = std::numbers::pi / 4 * i / n_elements;
    nodes.emplace_back(100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0.0);
  }
  const model::Model model = test::yarns_through({nodes}, test::section(1e7, 4.1667e6, 8.3333e5, 8.3333e5, 1.0));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  const auto tip = static_cast<std::size_t>(n_elements);
  const double left = test::relax(elements, state, slowest_frequency(8.3333e5, 1.0, 78.54),
                                  [&](const model::State&, model::NodalLoads& loads) {
                                    test::clamp(loads, 0);
                                    loads.force.z[tip] += load;
                                  });
  EXPECT_LT(left, kAtRest);
  return test::vector_at(state.position, tip);
}

TEST(Bend45, GivenTheLoad600_ThenTheTipIsWhereTheBenchmarkHasIt) {
  // Tip (47.150, 15.685, 53.476) in the axes of the benchmark: x across the clamp's tangent, y along it.
  const Eigen::Vector3d tip = bend_tip(600, 32);
  const Eigen::Vector3d reference(47.150, 15.685, 53.476);
  for (const int axis : {0, 1, 2}) {
    test::verify({.chapter = "bend",
                  .of = "32 elements, load 600",
                  .quantity = fmt::format("{} of the tip [mm]", "xyz"[axis]),
                  .source = "benchmark",
                  .reference = reference[axis],
                  .computed = tip[axis],
                  .tolerance = 0.005,
                  .scale = 47.150});
  }
}

TEST(RollUp, GivenAnEndMomentOf2PiEIOverL_ThenTheYarnClosesToACircle) {
  // M = 2 pi EI / L: constant curvature 2 pi / L, tip back at the clamp.
  const int n = 40;
  const double length = 10;
  const double bending = 0.0173039;
  const model::Model model = test::yarns_through({test::straight({0, 0, 0}, {length, 0, 0}, n)},
                                                 test::section(19.2265, 6.17, bending, 0.0124488, 1.29e-11));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  long steps = 0;
  const double left =
      test::relax(elements, state, slowest_frequency(bending, 1.29e-11, length),
                  [&](const model::State&, model::NodalLoads& loads) {
                    const double share =
                        std::min(1.0, static_cast<double>(++steps) / 20000);  // grows, so that the yarn rolls up once
                    test::clamp(loads, 0);
                    loads.moment.z[n] += share * 2 * std::numbers::pi * bending / length;
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

}  // namespace
}  // namespace knitmech
