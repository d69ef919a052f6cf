#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "base/segment_distance.h"
#include "watched_yarns.h"

namespace knitmech::contact {
namespace {

using Eigen::Vector3d;

constexpr double kD = kDiameter;
constexpr double kPi = std::numbers::pi;

/// Reference: two pieces pass through each other in a straight motion of their nodes where the volume that the four
/// nodes span changes its sign while the pieces meet.
struct PlainPass {
  std::int32_t first, second;
  bool near_end;  ///< within a diameter of an end of a yarn
};

class PlainSearch {
 public:
  PlainSearch(const ContactElements& elements, model::VectorArray before, const model::VectorArray& now)
      : elements_(elements), before_(std::move(before)), now_(now) {}

  [[nodiscard]] std::vector<PlainPass> passes() const {
    std::vector<PlainPass> found;
    for (std::size_t a = 0; a < elements_.n_nodes(); ++a) {
      for (std::size_t b = a + 1; b < elements_.n_nodes(); ++b) {
        if (elements_.exists[a] == 0 || elements_.exists[b] == 0 || too_near_along_yarn(elements_, a, b)) continue;
        if (may_meet(a, b)) look(a, b, found);
      }
    }
    return found;
  }

 private:
  struct Pieces {
    Vector3 a, u, b, v;
    [[nodiscard]] double volume() const { return dot(b - a, cross(u, v)); }
    [[nodiscard]] ClosestPoints closest() const { return closest_points(a, u, b, v); }
    [[nodiscard]] double distance() const {
      const ClosestPoints at = closest();
      return length(b + at.t * v - a - at.s * u);
    }
  };
  [[nodiscard]] Pieces at(std::size_t a, std::size_t b, double time) const {
    const auto node = [&](std::size_t i) { return (1 - time) * before_.at(i) + time * now_.at(i); };
    return {node(a), node(a + 1) - node(a), node(b), node(b + 1) - node(b)};
  }
  [[nodiscard]] bool may_meet(std::size_t a, std::size_t b) const { return at(a, b, 0).distance() < kD; }

  void look(std::size_t a, std::size_t b, std::vector<PlainPass>& found) const {
    constexpr int kParts = 64;
    for (int i = 0; i < kParts; ++i) {
      double low = static_cast<double>(i) / kParts;
      double high = static_cast<double>(i + 1) / kParts;
      const bool sign = at(a, b, low).volume() > 0;
      if ((at(a, b, high).volume() > 0) == sign) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        ((at(a, b, middle).volume() > 0) == sign ? low : high) = middle;
      }
      const Pieces pieces = at(a, b, high);
      if (pieces.distance() > 1e-9) continue;
      const ClosestPoints place = pieces.closest();
      found.push_back(
          {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), near_end(a, place.s) || near_end(b, place.t)});
    }
  }
  [[nodiscard]] bool near_end(std::size_t piece, double share) const {
    const auto is_within = [&](bool exists, double steps) { return !exists && steps < 1; };
    // Pieces are at least a diameter long.
    return is_within(elements_.has_previous(piece), share) || is_within(elements_.has_next(piece), 1 - share);
  }

  const ContactElements& elements_;
  model::VectorArray before_;
  const model::VectorArray& now_;
};

/// A yarn that winds about a ball of some 4 D at random; n pieces of one diameter or more.
std::vector<Vector3d> random_yarn(std::mt19937& random, int n) {
  std::normal_distribution<double> size(0, 2);
  const auto vector = [&] {
    const double x = size(random);
    const double y = size(random);
    return in_diameters(x, y, size(random));
  };
  std::array<Vector3d, 3> sines;
  std::array<Vector3d, 3> cosines;
  for (Vector3d& wave : sines) wave = vector();
  for (Vector3d& wave : cosines) wave = vector();
  const auto curve = [&](double p) -> Vector3d {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const double phase = static_cast<double>(k + 1) * p;
      sum += std::sin(phase) * sines[k] + std::cos(phase) * cosines[k];
    }
    return sum;
  };
  return drawn(curve, 0, 6, n);
}

/// Every yarn drifts at random and bends while it does: up to 0.2 D between two calls.
struct RandomDrift {
  std::vector<Vector3d> drift, bend;  ///< [mm], per yarn
  double phase = 0;

  static RandomDrift choose(std::mt19937& random, std::size_t n_yarns) {
    std::uniform_real_distribution<double> size(-1, 1);
    RandomDrift motion;
    for (std::size_t i = 0; i < 2 * n_yarns; ++i) {
      const double x = size(random);
      const double y = size(random);
      const Vector3d v = 0.1 * kD * Vector3d(x, y, size(random)).normalized();
      (i % 2 == 0 ? motion.drift : motion.bend).push_back(v);
    }
    motion.phase = kPi * size(random);
    return motion;
  }
  /// After a number of calls.
  [[nodiscard]] Motion after(int calls) const {
    return [*this, calls](std::size_t yarn, const Vector3d& x) -> Vector3d {
      const double wave = std::sin(x.sum() / (2 * kD) + phase);
      return x + calls * (drift[yarn] + wave * bend[yarn]);
    };
  }
};

template <typename A, typename B>
bool are_near(const A& a, const B& b, int pieces) {
  return std::abs(a.first - b.first) <= pieces && std::abs(a.second - b.second) <= pieces;
}

TEST(CrossingWatchAtRandom, GivenTanglesThatDriftThroughEachOther_ThenEveryPassIsReportedAndNothingElse) {
  int n_passes = 0;
  int n_calls_without = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const int n = 20 + static_cast<int>(seed % 3) * 20;
    WatchedYarns yarns({random_yarn(random, n), random_yarn(random, n), random_yarn(random, n)});
    const RandomDrift drift = RandomDrift::choose(random, 3);
    for (int call = 1; call <= 40; ++call) {
      const model::VectorArray before = yarns.position();
      const std::vector<CrossingLoss> lost = yarns.move(drift.after(call)).lost;
      const std::vector<PlainPass> passes = PlainSearch(yarns.elements(), before, yarns.position()).passes();
      for (const CrossingLoss& loss : lost) {
        EXPECT_TRUE(std::any_of(passes.begin(), passes.end(), [&](const PlainPass& p) { return are_near(p, loss, 1); }))
            << "false alarm, seed " << seed << ", call " << call;
      }
      for (const PlainPass& pass : passes) {
        const auto near_pass = [&](const PlainPass& other) { return are_near(pass, other, 3); };
        const bool alone = std::count_if(passes.begin(), passes.end(), near_pass) == 1;
        if (!alone || pass.near_end) continue;
        ++n_passes;
        EXPECT_TRUE(std::any_of(lost.begin(), lost.end(), [&](const CrossingLoss& l) { return are_near(pass, l, 1); }))
            << "missed, seed " << seed << ", call " << call;
      }
      n_calls_without += passes.empty() ? 1 : 0;
    }
  }
  EXPECT_GT(n_passes, 500);
  EXPECT_GT(n_calls_without, 100);
}

/// A plain weave of 2 x n yarns, a place 4 D wide each.
std::vector<std::vector<Vector3d>> weave(int n) {
  std::vector<std::vector<Vector3d>> yarns;
  const double place = 4;
  for (int i = 0; i < n; ++i) {
    const double side = i % 2 == 0 ? 0.5 : -0.5;
    const auto along_x = [&](double x) { return in_diameters(x, place * i, side * std::cos(kPi * x / place)); };
    const auto along_y = [&](double y) { return in_diameters(place * i, y, -side * std::cos(kPi * y / place)); };
    yarns.push_back(drawn(along_x, -2, place * n - 2, 10 * n));
    yarns.push_back(drawn(along_y, -2, place * n - 2, 10 * n));
  }
  return yarns;
}

/// A shear of all space, x + a sin(k . x + phase) with a at a right angle to k, and its inverse: nothing meets in it
/// that was apart, whatever its size.
struct Shear {
  Vector3d a;  ///< [mm]
  Vector3d k;  ///< [1/mm]
  double phase;

  static Shear choose(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const auto direction = [&]() -> Vector3d {
      const double x = normal(random);
      const double y = normal(random);
      return Vector3d(x, y, normal(random)).normalized();
    };
    const Vector3d k = direction();
    const Vector3d a = k.cross(direction()).normalized();
    return {8 * kD * a, k / (6 * kD), normal(random)};
  }
  [[nodiscard]] Vector3d apply(const Vector3d& x, double share) const {
    return x + share * std::sin(k.dot(x) + phase) * a;
  }
};

double least_distance(const WatchedYarns& yarns) {
  const ContactElements& elements = yarns.elements();
  const auto pairs = find_neighbours(elements, yarns.position(), std::vector<double>(elements.n_nodes(), 0.0), 0);
  double least = kD;
  for (const ElementPair pair : pairs) {
    const Vector3 a = yarns.position().at(static_cast<std::size_t>(pair.first));
    const Vector3 b = yarns.position().at(static_cast<std::size_t>(pair.second));
    const Vector3 u = yarns.position().at(static_cast<std::size_t>(pair.first) + 1) - a;
    const Vector3 v = yarns.position().at(static_cast<std::size_t>(pair.second) + 1) - b;
    const ClosestPoints at = closest_points(a, u, b, v);
    least = std::min(least, length(b + at.t * v - a - at.s * u));
  }
  return least;
}

TEST(CrossingWatchAtRandom, GivenAWeaveThatSpaceShearsBeyondRecognition_ThenNoCrossingIsLost) {
  double nearest = kD;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const std::vector<Shear> shears{Shear::choose(random), Shear::choose(random), Shear::choose(random)};
    WatchedYarns yarns(weave(4));
    for (std::size_t n_done = 0; n_done < shears.size(); ++n_done) {
      const auto sheared = [&](double share) {
        return [&, share](std::size_t, Vector3d x) -> Vector3d {
          for (std::size_t i = 0; i < n_done; ++i) x = shears[i].apply(x, 1);
          return shears[n_done].apply(x, share);
        };
      };
      EXPECT_TRUE(yarns.move_along(sheared, 45).lost.empty()) << "seed " << seed;
      nearest = std::min(nearest, least_distance(yarns));
    }
  }
  // Nearer than yarns move against each other between two calls, so that distances alone prove nothing.
  EXPECT_LT(nearest, 0.3 * kD);
}

}  // namespace
}  // namespace knitmech::contact
