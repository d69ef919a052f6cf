#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../../support/beam_case.h"
#include "contact/constants.h"
#include "contact/curve_distance.h"
#include "contact/normal_law.h"
#include "contact/overlap.h"
#include "contact/yarn_contact.h"

namespace knitmech::contact {
namespace {

constexpr double kDiameter = 0.12;                                 // mm
constexpr double kStiffness = 16.0;                                // N/mm
constexpr double kLine = kLineStiffness * kStiffness / kDiameter;  // N/mm^2

model::Model model_of(const std::vector<std::vector<Eigen::Vector3d>>& yarns) {
  model::Model model = test::yarns_through(yarns, test::section(19, 6, 0.017, 0.012, 1e-11, kDiameter));
  model.contact_stiffness = kStiffness;
  model.centreline = model::Centreline::smooth;
  return model;
}

struct Response {
  Eigen::Vector3d on_second = Eigen::Vector3d::Zero();  ///< total force on the second yarn [N]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();      ///< on all nodes
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();     ///< on all nodes, about the origin
  double energy = 0;
  double penetration = 0;  ///< largest [mm]
};

Response respond(const model::Model& model, const model::State& state) {
  YarnContact contact(model);
  model::NodalLoads loads(model.nodes.size());
  contact.add_forces(state, 0.0, loads);
  Response response;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Eigen::Vector3d force = test::vector_at(loads.force, i);
    response.force += force;
    response.moment += test::vector_at(loads.moment, i) + test::vector_at(state.position, i).cross(force);
    if (static_cast<int>(i) >= model.yarns[1].first_node) response.on_second += force;
  }
  response.energy = contact.energy();
  response.penetration = contact.largest_penetration();
  return response;
}

/// Two straight yarns at an angle, the second above the first, the crossing at a place along the first.
model::Model crossing(double angle, double penetration, double place, int n_elements) {
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
  const Eigen::Vector3d at(place, 0, kDiameter - penetration);
  return model_of({test::straight({-3, 0, 0}, {3, 0, 0}, n_elements),
                   test::straight(at - 3.1 * along, at + 2.9 * along, n_elements)});
}

TEST(SmoothContact, GivenStraightYarnsThatCross_ThenTheForceIsThatOfTheLineLoadOverTheirOverlap) {
  // F = 4/3 k d sqrt(2 (D - d) d) / sin a for a linear penalty; the law's growth adds d / D of it times 4/5.
  const double penetration = 0.002;
  for (const double angle : {0.4, 0.8, 1.2, std::acos(0.0)}) {
    const double linear =
        4.0 / 3 * kLine * penetration * std::sqrt(2 * (kDiameter - penetration) * penetration) / std::sin(angle);
    const double expected = linear * (1 + 0.8 * penetration / kDiameter);
    const Response response =
        respond(crossing(angle, penetration, 0.1, 7), test::state_of(crossing(angle, penetration, 0.1, 7)));
    EXPECT_NEAR(response.on_second.z(), expected, 0.002 * expected) << "angle " << angle;
  }
}

TEST(SmoothContact, GivenAPenetrationOfFivePercent_ThenARightAngledCrossingHasTheStiffnessAskedFor) {
  const double penetration = 0.05 * kDiameter;
  const model::Model model = crossing(std::acos(0.0), penetration, 0.1, 7);
  EXPECT_NEAR(respond(model, test::state_of(model)).on_second.z(), kStiffness * penetration,
              0.03 * kStiffness * penetration);
}

TEST(SmoothContact, GivenACrossingThatSlidesOverNodes_ThenTheForceStaysTheSame) {
  const double penetration = 0.003;
  for (const double angle : {0.5, 1.0, 1.5}) {
    double least = 1e9;
    double most = 0;
    for (double place = -0.6; place < 0.6; place += 0.0037) {
      const model::Model model = crossing(angle, penetration, place, 15);
      const double force = respond(model, test::state_of(model)).on_second.z();
      least = std::min(least, force);
      most = std::max(most, force);
    }
    EXPECT_LT((most - least) / most, 5e-3) << "angle " << angle;
  }
}

TEST(SmoothContact, GivenShorterElements_ThenTheForceAtAGivenOverlapStaysTheSame) {
  const double penetration = 0.003;
  const model::Model reference = crossing(1.0, penetration, 0.07, 3);
  const double expected = respond(reference, test::state_of(reference)).on_second.z();
  for (const int n : {7, 15, 31, 63, 200}) {
    const model::Model model = crossing(1.0, penetration, 0.07, n);
    EXPECT_NEAR(respond(model, test::state_of(model)).on_second.z(), expected, 2e-3 * expected) << n << " elements";
  }
}

TEST(SmoothContact, GivenYarnsSideBySide_ThenEachMillimetreCarriesTheLineLoadWhateverTheMesh) {
  const double penetration = 0.004;
  const double length = 4.0;
  const double expected = kLine * normal_force(penetration, kDiameter) * length;
  for (const int n : {4, 16, 50}) {
    const model::Model model =
        model_of({test::straight({-4, 0, 0}, {4, 0, 0}, 2 * n),
                  test::straight({-2, 0, kDiameter - penetration}, {2, 0, kDiameter - penetration}, n)});
    // The ends of the shorter yarn count for less than a diameter.
    EXPECT_NEAR(respond(model, test::state_of(model)).on_second.z(), expected, 0.02 * expected) << n << " elements";
  }
}

/// Three wavy yarns with turned nodes.
model::Model tangle(std::mt19937& random) {
  std::normal_distribution<double> normal(0, 0.12);
  std::vector<std::vector<Eigen::Vector3d>> yarns(3);
  for (std::size_t y = 0; y < 3; ++y) {
    for (int i = 0; i <= 10; ++i) {
      const double along = -2 + 0.4 * i;
      const double a = normal(random);
      const double b = normal(random);
      yarns[y].push_back(y == 0 ? Eigen::Vector3d(along, a, b)
                                : Eigen::Vector3d(a + 0.7 * (y == 1 ? 1 : -1), along, b));
    }
  }
  return model_of(yarns);
}

TEST(SmoothContact, GivenRandomTangles_ThenForcesAndMomentsAreInBalance) {
  std::mt19937 random(31);
  int touching = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const model::Model model = tangle(random);
    const Response response = respond(model, test::state_of(model));
    EXPECT_LT(response.force.norm(), 1e-11);
    EXPECT_LT(response.moment.norm(), 1e-9 * (1 + response.on_second.norm()));
    touching += response.energy > 0 ? 1 : 0;
  }
  EXPECT_GT(touching, 50);
}

/// The energy by its definition: both yarns cut into very short pieces, each with the distance to the nearest of the
/// other.
double brute_force_energy(const model::Model& model) {
  const ContactElements elements = make_contact_elements(model);
  Centreline centreline(model, elements);
  centreline.update(test::state_of(model));
  constexpr int kCuts = 200;
  double energy = 0;
  for (std::size_t a = 0; a < elements.n_nodes(); ++a) {
    if (!elements.exists[a]) continue;
    const Curve here = centreline.curve(elements, a);
    for (int i = 0; i < kCuts; ++i) {
      const double s = (i + 0.5) / kCuts;
      const Vector3 point = combine(here, hermite(s));
      std::vector<double> nearest(model.yarns.size(), 1e9);
      for (std::size_t b = 0; b < elements.n_nodes(); ++b) {
        if (!elements.exists[b] || elements.yarn[b] == elements.yarn[a]) continue;
        const Curve there = centreline.curve(elements, b);
        if (length(point - there.start) > 1.0) continue;
        double& least = nearest[static_cast<std::size_t>(elements.yarn[b])];
        for (int j = 0; j <= 40; ++j) least = std::min(least, length(combine(there, hermite(j / 40.0)) - point));
      }
      for (const double distance : nearest) {
        if (distance >= kDiameter) continue;
        energy += 0.5 * kLine * normal_energy(kDiameter - distance, kDiameter) *
                  length(combine(here, hermite_slope(s))) / kCuts;
      }
    }
  }
  return energy;
}

TEST(SmoothContact, GivenRandomTangles_ThenTheEnergyIsTheLineIntegralOfItsDefinition) {
  std::mt19937 random(37);
  double fast = 0;
  double plain = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const model::Model model = tangle(random);
    const Response response = respond(model, test::state_of(model));
    if (response.penetration > 0.25 * kDiameter) continue;  // the energy of one deep contact would outweigh all others
    fast += response.energy;
    plain += brute_force_energy(model);
  }
  EXPECT_GT(plain, 0);
  EXPECT_NEAR(fast / plain, 1.0, 0.03);
}

TEST(SmoothContact, GivenTheYarnsSwapped_ThenTheAnswerIsSwapped) {
  model::Model one = crossing(0.7, 0.005, 0.13, 9);
  model::Model two = model_of({{one.nodes.begin() + 10, one.nodes.end()}, {one.nodes.begin(), one.nodes.begin() + 10}});
  const Eigen::Vector3d on_upper = respond(one, test::state_of(one)).on_second;
  const Eigen::Vector3d on_lower = respond(two, test::state_of(two)).on_second;
  EXPECT_LT((on_upper + on_lower).norm(), 1e-9 * on_upper.norm());
}

TEST(Overlap, GivenAParabola_ThenLoadAndEnergyAreItsIntegrals) {
  const double depth = 1e-4;  // small: the law is a linear penalty
  const double curvature = 3.0;
  const double half = std::sqrt(2 * depth / curvature);
  const Overlap whole = integrate({depth, 0, curvature, -1, 1}, kDiameter);
  EXPECT_NEAR(whole.load, 4.0 / 3 * depth * half, 1e-3 * whole.load);
  EXPECT_NEAR(whole.energy, 8.0 / 15 * depth * depth * half, 1e-3 * whole.energy);
  EXPECT_NEAR(whole.tangent, 2 * half, 2e-3 * whole.tangent);
  EXPECT_NEAR(whole.centre, 0, 1e-15);
  // Cut anywhere, the two parts make up the whole.
  for (const double cut : {-0.5 * half, 0.0, 0.3 * half}) {
    const Overlap left = integrate({depth, 0, curvature, -1, cut}, kDiameter);
    const Overlap right = integrate({depth, 0, curvature, cut, 1}, kDiameter);
    EXPECT_NEAR(left.load + right.load, whole.load, 1e-4 * whole.load);
    EXPECT_NEAR(left.load * left.centre + right.load * right.centre, 0, 1e-4 * whole.load * half);
  }
}

TEST(ClosestOnCurves, GivenRandomPieces_ThenNoPairOfPlacesNearbyIsNearer) {
  std::mt19937 random(41);
  std::normal_distribution<double> normal;
  const auto vector = [&](double size) {
    const double x = normal(random);
    const double y = normal(random);
    return Vector3{size * x, size * y, size * normal(random)};
  };
  int found = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Vector3 a = vector(0.3);
    const Vector3 b = vector(0.3);
    const Vector3 u = vector(1);
    const Vector3 v = vector(1);
    const Curve first{a, a + u, u + vector(0.15), u + vector(0.15)};
    const Curve second{b, b + v, v + vector(0.15), v + vector(0.15)};
    const CurveApproach at = closest_on_curves(first, second, 0.5, 0.5);
    if (!at.is_minimum) continue;
    ++found;
    for (const double ds : {-1e-3, 0.0, 1e-3}) {
      for (const double dt : {-1e-3, 0.0, 1e-3}) {
        const double s = std::clamp(at.s + ds, 0.0, 1.0);
        const double t = std::clamp(at.t + dt, 0.0, 1.0);
        EXPECT_GE(length(combine(second, hermite(t)) - combine(first, hermite(s))), length(at.between) - 1e-12);
      }
    }
  }
  EXPECT_GT(found, 450);
}

}  // namespace
}  // namespace knitmech::contact
