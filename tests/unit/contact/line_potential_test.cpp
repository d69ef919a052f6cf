#include "contact/line_potential.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "contact/curve_distance.h"

namespace knitmech::contact {
namespace {

constexpr double kRadii = 0.12;   // mm
constexpr double kDensity = 2e4;  // N/mm^3
constexpr double kLengthA = 0.5;  // mm
constexpr double kLengthB = 0.4;  // mm
const PairSize kSize{kRadii, kDensity, kLengthA, kLengthB};

/// Two bent curves that cross over each other.
struct CurvePair {
  std::array<Curve, 2> curves;

  /// The twelve numbers of each curve.
  double& number(std::size_t curve, std::size_t i) {
    Curve& c = curves[curve];
    Vector3& v = i < 3 ? c.start : (i < 6 ? c.end : (i < 9 ? c.start_slope : c.end_slope));
    return i % 3 == 0 ? v.x : (i % 3 == 1 ? v.y : v.z);
  }
};

CurvePair random_pair(std::mt19937& random) {
  std::normal_distribution<double> normal(0, 0.05);
  const auto noise = [&] {
    const double x = normal(random);
    const double y = normal(random);
    return Vector3{x, y, normal(random)};
  };
  const double angle = 0.5 + 0.5 * std::abs(normal(random)) / 0.05;
  const Vector3 u{kLengthA, 0, 0};
  const Vector3 v{kLengthB * std::cos(angle), kLengthB * std::sin(angle), 0};
  const double above = kRadii * (0.97 - 0.3 * std::abs(normal(random)));
  const Vector3 a = -0.5 * u + 0.1 * noise();
  const Vector3 b = -0.5 * v + Vector3{0, 0, above};
  return {{Curve{a, a + u, u + noise(), u + noise()}, Curve{b, b + v, v + noise(), v + noise()}}};
}

struct Found {
  bool is_crossing;
  CurveApproach at;
  PairLoad load;
};

Places places(const CurvePair& pair, double s, double t) {
  return places_at(point_at(pair.curves[0], s), point_at(pair.curves[1], t));
}

Found crossing_of(const CurvePair& pair) {
  Found found{};
  found.at = closest_on_curves(pair.curves[0], pair.curves[1], 0.5, 0.5);
  const double distance = length(found.at.between);
  found.is_crossing = found.at.is_minimum && distance < kRadii && std::abs(found.at.s - 0.5) < 0.45 &&
                      std::abs(found.at.t - 0.5) < 0.45;
  if (!found.is_crossing) return found;
  const Places at = places(pair, found.at.s, found.at.t);
  found.load = crossing_load(at, hessian(at), distance, kSize);
  return found;
}

/// What a load on a curve does to the curve's twelve numbers: minus the derivative of the energy by them.
double on_number(const CurveLoad& load, double place, std::size_t i) {
  const HermiteWeights value = hermite(place);
  const HermiteWeights slope = hermite_slope(place);
  const HermiteWeights bend = hermite_bend(place);
  const auto part = [&](double HermiteWeights::*w) {
    return value.*w * load.force + slope.*w * load.slope + bend.*w * load.bend;
  };
  const Vector3 v = i < 3   ? part(&HermiteWeights::start)
                    : i < 6 ? part(&HermiteWeights::end)
                    : i < 9 ? part(&HermiteWeights::start_slope)
                            : part(&HermiteWeights::end_slope);
  return i % 3 == 0 ? v.x : (i % 3 == 1 ? v.y : v.z);
}

/// Largest difference between loads and the energy differentiated numerically, over the normal force.
template <typename FindAgain>
double error_of_loads(CurvePair pair, const Found& found, const FindAgain& find_again) {
  constexpr double kStep = 1e-6;
  double worst = 0;
  for (std::size_t curve = 0; curve < 2; ++curve) {
    for (std::size_t i = 0; i < 12; ++i) {
      double& number = pair.number(curve, i);
      const double before = number;
      number = before + kStep;
      const double more = find_again(pair).load.energy;
      number = before - kStep;
      const double less = find_again(pair).load.energy;
      number = before;
      const double expected = -(more - less) / (2 * kStep);
      const double load =
          curve == 0 ? on_number(found.load.on_first, found.at.s, i) : on_number(found.load.on_second, found.at.t, i);
      worst = std::max(worst, std::abs(load - expected));
    }
  }
  return worst / found.load.load;
}

TEST(LinePotential, GivenThousandsOfCrossings_ThenTheLoadsAreTheDerivativesOfTheEnergy) {
  std::mt19937 random(3);
  int tried = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const CurvePair pair = random_pair(random);
    const Found found = crossing_of(pair);
    if (!found.is_crossing || found.load.energy < 1e-9) continue;
    ++tried;
    EXPECT_LT(error_of_loads(pair, found, crossing_of), 5e-5);
  }
  EXPECT_GT(tried, 1500);
}

/// The energy by its definition, both curves cut into many short pieces.
double plain_energy(const CurvePair& pair) {
  constexpr int kCuts = 1200;
  double energy = 0;
  for (int i = 0; i < kCuts; ++i) {
    const Vector3 a = combine(pair.curves[0], hermite((i + 0.5) / kCuts));
    for (int j = 0; j < kCuts; ++j) {
      const double distance = length(combine(pair.curves[1], hermite((j + 0.5) / kCuts)) - a);
      if (distance < kRadii) energy += normal_energy(kRadii - distance, kRadii);
    }
  }
  return energy * kDensity * kLengthA * kLengthB / (static_cast<double>(kCuts) * kCuts);
}

TEST(LinePotential, GivenCrossings_ThenTheEnergyIsTheDoubleIntegralOfItsDefinition) {
  std::mt19937 random(7);
  int tried = 0;
  for (int trial = 0; tried < 25; ++trial) {
    const CurvePair pair = random_pair(random);
    const Found found = crossing_of(pair);
    if (!found.is_crossing) continue;
    const double penetration = kRadii - length(found.at.between);
    if (penetration < 0.01 * kRadii || std::abs(found.at.s - 0.5) > 0.1 || std::abs(found.at.t - 0.5) > 0.1) continue;
    ++tried;
    // The distance is taken as a parabola: the next terms make up a share of the order of the penetration.
    const double plain = plain_energy(pair);
    EXPECT_NEAR(found.load.energy, plain, (0.005 + penetration / kRadii) * plain);
  }
}

TEST(LinePotential, GivenTheCurvesSwapped_ThenTheAnswerIsSwapped) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 200; ++trial) {
    const CurvePair pair = random_pair(random);
    const Found found = crossing_of(pair);
    if (!found.is_crossing) continue;
    const Places at = places(pair, found.at.s, found.at.t);
    const Places other = places_at(at.second, at.first);
    const PairLoad swapped =
        crossing_load(other, hessian(other), length(at.between), {kRadii, kDensity, kLengthB, kLengthA});
    EXPECT_NEAR(swapped.energy, found.load.energy, 1e-10 * found.load.energy);
    EXPECT_LT(length(swapped.on_first.force - found.load.on_second.force), 1e-9 * found.load.load);
    EXPECT_LT(length(swapped.on_second.bend - found.load.on_first.bend), 1e-9 * found.load.load);
  }
}

}  // namespace
}  // namespace knitmech::contact
