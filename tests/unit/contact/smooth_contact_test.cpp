#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "../../support/beam_case.h"
#include "contact/constants.h"
#include "contact/curve_distance.h"
#include "contact/normal_law.h"
#include "contact/yarn_contact.h"

namespace knitmech::contact {
namespace {

constexpr double kDiameter = 0.12;   // mm
constexpr double kStiffness = 16.0;  // N/mm

/// Density k of the contact energy [N/mm^3] (line_potential.h): two straight yarns at a right angle with the
/// penetration c D press with K c D = 2 pi k (D - c D) e(c D).
double density() {
  const double reference = kReferenceOverlap * kDiameter;
  return kStiffness * reference /
         (2 * std::numbers::pi * (kDiameter - reference) * normal_energy(reference, kDiameter));
}

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

/// The normal force of two straight yarns that cross, by cutting both into short pieces, each pressing along the line
/// between them; of that, the part along the line between the closest places.
double plain_force(double angle, double penetration) {
  constexpr double kPiece = 0.0008;  // mm
  const double reach = std::sqrt(2 * kDiameter * penetration) / std::sin(angle) * 1.2;
  const double above = kDiameter - penetration;
  double force = 0;
  for (double s = -reach; s < reach; s += kPiece) {
    for (double t = -reach; t < reach; t += kPiece) {
      const double squared = s * s + t * t - 2 * s * t * std::cos(angle) + above * above;
      if (squared >= kDiameter * kDiameter) continue;
      const double distance = std::sqrt(squared);
      force += normal_force(kDiameter - distance, kDiameter) * above / distance;
    }
  }
  return density() * force * kPiece * kPiece;
}

TEST(SmoothContact, GivenStraightYarnsThatCross_ThenTheForceIsTheSumOverAllPairsOfShortPieces) {
  const double penetration = 0.002;
  for (const double angle : {0.4, 0.8, 1.2, std::acos(0.0)}) {
    const double expected = plain_force(angle, penetration);
    const Response response =
        respond(crossing(angle, penetration, 0.1, 7), test::state_of(crossing(angle, penetration, 0.1, 7)));
    EXPECT_NEAR(response.on_second.z(), expected, 0.01 * expected) << "angle " << angle;
  }
}

TEST(SmoothContact, GivenTheReferenceOverlap_ThenARightAngledCrossingHasTheStiffnessAskedFor) {
  const double penetration = kReferenceOverlap * kDiameter;
  const model::Model model = crossing(std::acos(0.0), penetration, 0.1, 7);
  EXPECT_NEAR(respond(model, test::state_of(model)).on_second.z(), kStiffness * penetration,
              0.01 * kStiffness * penetration);
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

/// What a short length of a straight yarn feels of another beside it, per length and density [mm^2]: of the forces of
/// all short pieces of the other, the part across.
double plain_line_force(double distance) {
  constexpr double kPiece = 1e-6;  // mm
  double force = 0;
  for (double t = 0.5 * kPiece;; t += kPiece) {
    const double apart = std::sqrt(distance * distance + t * t);
    if (apart >= kDiameter) return 2 * force * kPiece;
    force += normal_force(kDiameter - apart, kDiameter) * distance / apart;
  }
}

TEST(SmoothContact, GivenYarnsSideBySide_ThenEachMillimetreCarriesTheLineLoadWhateverTheMesh) {
  const double penetration = 0.004;
  const double length = 4.0;
  const double expected = density() * length * plain_line_force(kDiameter - penetration);
  for (const int n : {4, 16, 50}) {
    const model::Model model =
        model_of({test::straight({-4, 0, 0}, {4, 0, 0}, 2 * n),
                  test::straight({-2, 0, kDiameter - penetration}, {2, 0, kDiameter - penetration}, n)});
    // The ends of the shorter yarn count for less than a diameter.
    EXPECT_NEAR(respond(model, test::state_of(model)).on_second.z(), expected, 0.02 * expected) << n << " elements";
  }
}

/// Three wavy yarns whose elements bow out besides.
model::Model tangle(std::mt19937& random) {
  std::normal_distribution<double> normal(0, 0.12);
  std::vector<std::vector<Eigen::Vector3d>> yarns(3);
  for (std::size_t y = 0; y < 3; ++y) {
    for (int i = 0; i <= 10; ++i) {
      const double along = -2 + 0.4 * i;
      const double a = normal(random);
      const double b = normal(random);
      if (y == 0) {
        yarns[y].emplace_back(along, a, b);
      } else {
        yarns[y].emplace_back(a + 0.7 * (y == 1 ? 1 : -1), along, b);
      }
    }
  }
  model::Model model = model_of(yarns);
  std::normal_distribution<double> bow(0, 0.01);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Eigen::Vector3d next = i + 1 < model.nodes.size() ? model.nodes[i + 1] : model.nodes[i];
    const double a = bow(random);
    const double b = bow(random);
    model.middles.emplace_back(0.5 * (model.nodes[i] + next) + Eigen::Vector3d(a, b, bow(random)));
  }
  return model;
}

TEST(SmoothContact, GivenRandomTangles_ThenTheLoadsAreTheDerivativesOfTheEnergyByPositionsAndRotations) {
  std::mt19937 random(71);
  std::normal_distribution<double> normal;
  constexpr double kStep = 1e-7;
  double difference = 0;
  double size = 0;
  int touching = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const model::Model model = tangle(random);
    const model::State state = test::state_of(model);
    YarnContact contact(model);
    model::NodalLoads loads(model.nodes.size());
    contact.add_forces(state, 0.0, loads);
    if (contact.n_contacts() == 0 || contact.largest_penetration() > 0.2 * kDiameter) continue;
    ++touching;
    model::State ahead = state;
    model::State behind = state;
    double power = 0;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const std::array<double, 6> v = {normal(random), normal(random), normal(random),
                                       normal(random), normal(random), normal(random)};
      const Vector3 move{v[0], v[1], v[2]};
      const Eigen::Vector3d turn(v[3], v[4], v[5]);
      ahead.position.add(i, kStep * move);
      behind.position.add(i, -kStep * move);
      test::set_rotation(ahead, i, test::turn(kStep * turn));
      test::set_rotation(behind, i, test::turn(-kStep * turn));
      power += dot(loads.force.at(i), move) + dot(loads.moment.at(i), {v[3], v[4], v[5]});
    }
    // Which way an overlap is counted stays as it is, as it does from one step to the next.
    YarnContact more = contact;
    YarnContact less = contact;
    model::NodalLoads unused(model.nodes.size());
    more.add_forces(ahead, 0.0, unused);
    less.add_forces(behind, 0.0, unused);
    const double expected = -(more.energy() - less.energy()) / (2 * kStep);
    difference += std::abs(power - expected);
    size += std::abs(expected);
  }
  EXPECT_GT(touching, 1000);
  EXPECT_LT(difference, 1e-4 * size);
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

/// The energy by its definition, without any search: all yarns cut into very short pieces, every piece with every
/// other.
double plain_energy(const model::Model& model) {
  const YarnElements elements = make_yarn_elements(model);
  Centreline line(model);
  line.update(test::state_of(model), {}, 0);
  constexpr int kCuts = 160;
  double energy = 0;
  for (std::size_t a = 0; a < elements.n_nodes(); ++a) {
    if (elements.exists[a] == 0) continue;
    const Curve here = line.curve(a);
    for (std::size_t b = a + 1; b < elements.n_nodes(); ++b) {
      if (elements.exists[b] == 0 || elements.yarn[b] == elements.yarn[a]) continue;
      const Curve there = line.curve(b);
      if (length(here.start - there.start) > elements.length[a] + elements.length[b] + 0.4) continue;
      const double share = elements.length[a] * elements.length[b] / (kCuts * kCuts);
      for (int i = 0; i < kCuts; ++i) {
        const Vector3 point = combine(here, hermite((i + 0.5) / kCuts));
        for (int j = 0; j < kCuts; ++j) {
          const double distance = length(combine(there, hermite((j + 0.5) / kCuts)) - point);
          if (distance < kDiameter) energy += share * normal_energy(kDiameter - distance, kDiameter);
        }
      }
    }
  }
  return density() * energy;
}

TEST(SmoothContact, GivenRandomTangles_ThenTheEnergyIsTheDoubleIntegralOfItsDefinition) {
  std::mt19937 random(37);
  double fast = 0;
  double plain = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const model::Model model = tangle(random);
    const Response response = respond(model, test::state_of(model));
    if (response.penetration > 0.15 * kDiameter) continue;  // the energy of one deep contact would outweigh all others
    fast += response.energy;
    plain += plain_energy(model);
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
