// Beams that bend and twist together in space, against the rod as a boundary value problem and against the literature.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "../support/beam_case.h"
#include "../support/monofilament.h"
#include "../support/relax.h"
#include "../support/rod_shooting.h"
#include "../support/stiffness.h"
#include "../support/verification.h"

namespace knitmech {
namespace {

using std::numbers::pi;

constexpr double kAtRest = 1e-6;

/// Bathe and Bolourchi's 45-degree bend: an eighth of a circle of radius 100 in the plane x, y, clamped at the origin
/// with its tangent along x, loaded along z at its tip. The section is a square of side 1 with E = 1e7, nu = 0; the
/// stiffnesses are those that the benchmark is usually computed with.
constexpr double kRadius = 100;
constexpr double kBendAxial = 1e7, kBendShear = 4.1667e6, kBendBending = 8.3333e5, kBendTorsion = 8.3333e5;

Eigen::Vector3d bend_tip(double load, int n_elements) {
  std::vector<Eigen::Vector3d> nodes;
  for (int i = 0; i <= n_elements; ++i) {
    const double angle = pi / 4 * i / n_elements;
    nodes.emplace_back(kRadius * std::sin(angle), kRadius * (1 - std::cos(angle)), 0.0);
  }
  const model::Model model =
      test::yarns_through({nodes}, test::section(kBendAxial, kBendShear, kBendBending, kBendTorsion, 1.0));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  const auto tip = static_cast<std::size_t>(n_elements);
  const double left = test::relax(elements, state, test::slowest_frequency(kBendBending, 1.0, 78.54),
                                  [&](const model::State&, model::NodalLoads& loads) {
                                    test::clamp(loads, 0);
                                    loads.force.z[tip] += load;
                                  });
  EXPECT_LT(left, kAtRest);
  return test::vector_at(state.position, tip);
}

/// The same by shooting: the moment at the clamp that leaves none at the tip, for a load that grows in ten steps.
Eigen::Vector3d bend_tip_by_shooting(double load) {
  const test::ShootingRod rod{.length = kRadius * pi / 4,
                              .axial = kBendAxial,
                              .shear = kBendShear,
                              .torsion = kBendTorsion,
                              .bending = kBendBending,
                              .natural_curvature = {0, 0, 1 / kRadius}};
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  const auto tip = [&](const Eigen::Vector3d& at_clamp) { return shoot(rod, {.moment = at_clamp}, force); };
  for (int step = 1; step <= 10; ++step) {
    force.z() = load * step / 10;
    moment =
        test::newton([&](const Eigen::Vector3d& at_clamp) { return tip(at_clamp).moment; }, moment, load * rod.length);
  }
  EXPECT_LT(tip(moment).moment.norm(), 1e-8 * load * rod.length);
  return tip(moment).position;
}

TEST(Bend45, GivenTheLoadsOfTheBenchmark_ThenTheTipIsWhereTheRodOfShootingHasIt) {
  for (const double load : {300.0, 600.0}) {
    const Eigen::Vector3d tip = bend_tip(load, 32);
    const Eigen::Vector3d reference = bend_tip_by_shooting(load);
    for (const int axis : {0, 1, 2}) {
      test::verify({.chapter = "bend",
                    .of = fmt::format("32 elements, load {}", load),
                    .quantity = fmt::format("{} of the tip [mm]", "xyz"[axis]),
                    .source = "rod by shooting",
                    .reference = reference[axis],
                    .computed = tip[axis],
                    .tolerance = 2e-3});
    }
  }
}

TEST(Bend45, GivenTheLoadsOfTheBenchmark_ThenTheTipIsWhereTheLiteratureHasIt) {
  const std::vector<std::pair<double, Eigen::Vector3d>> published{{300, {58.779, 22.245, 40.192}},
                                                                  {600, {47.150, 15.685, 53.476}}};
  for (const auto& [load, reference] : published) {
    const Eigen::Vector3d tip = bend_tip(load, 32);
    for (const int axis : {0, 1, 2}) {
      test::verify({.chapter = "bend",
                    .of = fmt::format("32 elements, load {}", load),
                    .quantity = fmt::format("{} of the tip [mm]", "xyz"[axis]),
                    .source = "benchmark",
                    .reference = reference[axis],
                    .computed = tip[axis],
                    .tolerance = 2e-3});
    }
  }
}

TEST(Bend45, GivenFinerMeshes_ThenTheTipConvergesToTheRodWithTheSquareOfTheElementLength) {
  const Eigen::Vector3d reference = bend_tip_by_shooting(600);
  const double coarse = (bend_tip(600, 8) - reference).norm();
  const double fine = (bend_tip(600, 16) - reference).norm();
  test::verify({.chapter = "bend",
                .of = "8 and 16 elements, load 600",
                .quantity = "order of convergence of the tip [-]",
                .source = "linear elements",
                .reference = 2,
                .computed = std::log2(coarse / fine),
                .tolerance = 0.05});
}

/// A helix about an axis, measured on its nodes.
struct Helix {
  double radius, pitch;
};

Helix measured_helix(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  // The circle x^2 + y^2 = 2 a x + 2 b y + c through all points, seen along the axis.
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd unknowns(n, 3);
  Eigen::VectorXd squares(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d p(points[static_cast<std::size_t>(i)].dot(u), points[static_cast<std::size_t>(i)].dot(v));
    unknowns.row(i) << 2 * p.x(), 2 * p.y(), 1;
    squares[i] = p.squaredNorm();
  }
  const Eigen::Vector3d fit = unknowns.colPivHouseholderQr().solve(squares);
  const auto from_centre = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(p.dot(u) - fit[0], p.dot(v) - fit[1]);
  };
  double turned = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Eigen::Vector2d a = from_centre(points[i]);
    const Eigen::Vector2d b = from_centre(points[i + 1]);
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  const double advance = (points.back() - points.front()).dot(axis);
  return {std::sqrt(fit[2] + fit[0] * fit[0] + fit[1] * fit[1]), 2 * pi * advance / std::abs(turned)};
}

/// A straight yarn under a couple at its tip whose axis makes an angle with its tangent at the clamp.
///
/// There is no force, so the moment is the couple M in every section. M = EI t x t' + T t, with T = M . t constant,
/// gives t' = M x t / EI: the tangent turns about the axis of M at the rate |M| / EI and keeps its angle a with it. So
/// the axis is a helix of radius EI sin(a) / |M| and pitch 2 pi EI cos(a) / |M|; GJ decides only on the twist.
///
/// Such a couple has no potential, and a damped yarn need not come to rest under it. So the yarn is laid out as that
/// helix, R(s) = exp(s M / EI) exp(s T (1 / GJ - 1 / EI) e1), and Newton's method finds the equilibrium of the elements
/// nearby.
TEST(Helix, GivenACoupleAtTheTip_ThenRadiusAndPitchAreThoseOfAHelixWhateverTheTorsionalStiffness) {
  const double length = 10;
  const double turns = 2;
  const double couple = 2 * pi * turns * test::kBending / length;
  for (const auto& [torsion_ratio, degrees, n] :
       {std::tuple{0.3, 60.0, 120}, {0.72, 60.0, 80}, {0.72, 30.0, 80}, {3.0, 60.0, 80}}) {
    const double angle = degrees * pi / 180;
    const Eigen::Vector3d axis(std::cos(angle), std::sin(angle), 0);
    const model::Model model = test::yarns_through({test::straight({0, 0, 0}, {length, 0, 0}, n)},
                                                   test::monofilament(torsion_ratio * test::kBending));
    const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
    const test::Freedom freedom = test::Freedom::without(model.nodes.size(), {0, 1, 2, 3, 4, 5});
    model::State state = test::state_of(model);
    Eigen::VectorXd external = Eigen::VectorXd::Zero(freedom.matrix.rows());
    external.tail<3>() = couple * axis;
    const double rate = couple / test::kBending;
    const double spin = couple * std::cos(angle) * (1 / model.sections[0].torsional_stiffness - 1 / test::kBending);
    Eigen::Vector3d end = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const double s = model.arc_length[i];
      state.position.set(i, {end.x(), end.y(), end.z()});
      test::set_rotation(state, i, test::turn(s * rate * axis) * test::turn({s * spin, 0, 0}));
      end += length / n * (test::turn((s + 0.5 * length / n) * rate * axis) * Eigen::Vector3d::UnitX());
    }
    EXPECT_GT((freedom.matrix.transpose() * (test::loads_of(elements, state) + external)).norm(), 1e-4 * couple);
    EXPECT_LT(test::find_equilibrium(elements, state, freedom, external), 1e-9 * couple);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) points.push_back(test::vector_at(state.position, i));
    const Helix helix = measured_helix(points, axis);
    const std::string of = fmt::format("GJ / EI = {}, a = {} degrees, {} elements", torsion_ratio, degrees, n);
    test::verify({.chapter = "helix",
                  .of = of,
                  .quantity = "radius [mm]",
                  .source = "EI sin(a) / M",
                  .reference = test::kBending * std::sin(angle) / couple,
                  .computed = helix.radius,
                  .tolerance = 0.005});
    test::verify({.chapter = "helix",
                  .of = of,
                  .quantity = "pitch [mm]",
                  .source = "2 pi EI cos(a) / M",
                  .reference = 2 * pi * test::kBending * std::cos(angle) / couple,
                  .computed = helix.pitch,
                  .tolerance = 0.005});
  }
}

}  // namespace
}  // namespace knitmech
