// A yarn is moved across or along another by hand, at constant overlap of the true curves: the force must neither
// depend on where their nodes are nor on how many there are.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../support/centrelines.h"
#include "../support/slide.h"
#include "../support/verification.h"

namespace knitmech {
namespace {

using std::numbers::pi;

constexpr double kStiffness = 16;    // N/mm
constexpr double kHalfStitch = 9.2;  // mm, arc length of half a stitch of the main example
constexpr double kArcRadius = 1.1;   // mm, of its head
const double kDiameter = test::monofilament().diameter;
const double kOverlap = 0.05 * kDiameter;
const double kDistance = kDiameter - kOverlap;
constexpr int kPlaces = 240;  // not a multiple of what repeats

double pair_force(model::Centreline centreline, const test::YarnShape& lower, const test::YarnShape& upper) {
  return test::force_between(test::monofilament(), kStiffness, centreline, lower, upper);
}

/// Straight yarns that cross at an angle [rad]; the upper one moves over three elements of the lower and two of its
/// own.
test::SlidingForce slide_across(double angle, double element, model::Centreline centreline) {
  const test::YarnShape lower = test::straight_shape({-6 * element, 0, 0}, {6 * element, 0, 0}, 12);
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
  return test::slide(
      [&](double share) {
        const Eigen::Vector3d middle(3 * (share - 0.5) * element, 0, kDistance);
        const Eigen::Vector3d start = middle + (2 * share - 7) * element * along;
        return pair_force(centreline, lower, test::straight_shape(start, start + 12 * element * along, 12));
      },
      kPlaces);
}

/// n elements along an arc about an axis through `centre`, starting in the direction e and turning towards f (unit
/// vectors across the axis) from an angle on.
struct Arc {
  Eigen::Vector3d centre, e, f;
  double radius;  ///< [mm]
  [[nodiscard]] test::YarnShape shape(double from, double element, int n) const {
    return test::along(
        [&](double s) {
          const double angle = from + s / radius;
          return test::Place{centre + radius * (std::cos(angle) * e + std::sin(angle) * f),
                             std::cos(angle) * f - std::sin(angle) * e};
        },
        n * element, n);
  }
};

/// A yarn that lies along a straight one and rises from it at both ends with a radius of 20 mm, so that they touch over
/// one millimetre. It moves over three elements of the straight one and two of its own.
test::SlidingForce slide_along(double element, model::Centreline centreline) {
  const double radius = 20;
  const int n = 2 * static_cast<int>(std::ceil(1.2 / element)) + 4;
  const test::YarnShape lower = test::straight_shape({-n * element, 0, 0}, {n * element, 0, 0}, 2 * n);
  return test::slide(
      [&](double share) {
        const Eigen::Vector3d centre(3 * (share - 0.5) * element, 0, kDistance + radius);
        const Arc arc{centre, -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), radius};
        return pair_force(centreline, lower, arc.shape((2 * share - 0.5 * n - 1) * element / radius, element, n));
      },
      kPlaces);
}

Arc head_arc() {
  return {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), kArcRadius};
}

/// A straight yarn along the axis of a head arc, on its outside or inside, moved over three elements of the arc and two
/// of its own.
test::SlidingForce slide_across_arc(bool outside, double element, model::Centreline centreline) {
  const double turn = element / kArcRadius;  // of one element
  const int n = 2 * static_cast<int>(std::ceil(1.0 / turn)) + 3;
  const test::YarnShape lower = head_arc().shape(-0.5 * n * turn, element, n);
  const double radius = kArcRadius + (outside ? kDistance : -kDistance);
  return test::slide(
      [&](double share) {
        const double angle = 3 * (share - 0.5) * turn;
        const Eigen::Vector3d middle(radius * std::cos(angle), radius * std::sin(angle), 0);
        const Eigen::Vector3d start = middle + (2 * share - 7) * element * Eigen::Vector3d::UnitZ();
        return pair_force(centreline, lower,
                          test::straight_shape(start, start + 12 * element * Eigen::Vector3d::UnitZ(), 12));
      },
      kPlaces);
}

/// An arc of radius 1.3 mm that lies beside a head arc, in the plane above, so that they touch over one and a half
/// millimetres. It moves over three elements of the head arc and two of its own.
test::SlidingForce slide_along_arc(double element, model::Centreline centreline) {
  const double radius = 1.3;
  const double turn = element / kArcRadius;
  const int n = 2 * static_cast<int>(std::ceil(1.0 / element)) + 3;
  const test::YarnShape lower = head_arc().shape(-0.5 * n * turn, element, n);
  return test::slide(
      [&](double share) {
        const double angle = 2 * (share - 0.5) * turn;
        const Eigen::Vector3d outward(std::cos(angle), std::sin(angle), 0);
        const Eigen::Vector3d centre = (kArcRadius - radius) * outward + kDistance * Eigen::Vector3d::UnitZ();
        const Arc upper{centre, outward, Eigen::Vector3d::UnitZ().cross(outward), radius};
        return pair_force(centreline, lower, upper.shape((2 * share - 0.5 * n - 1) * element / radius, element, n));
      },
      kPlaces);
}

struct Allowed {
  double chords, smooth;
};

class Sliding : public testing::TestWithParam<model::Centreline> {
 protected:
  static void verify_ripple(const std::string& of, const test::SlidingForce& force, Allowed allowed) {
    const bool on_chords = GetParam() == model::Centreline::chords;
    test::verify({.chapter = "sliding",
                  .of = of + ", " + test::name_of(GetParam()),
                  .quantity = "ripple of the normal force, (largest - least) / mean [-]",
                  .source = "none",
                  .computed = force.ripple(),
                  .tolerance = on_chords ? allowed.chords : allowed.smooth,
                  .scale = 1,
                  .remark = on_chords ? "chords count a contact at a node up to four times" : ""});
  }
};
KNITMECH_WITH_EVERY_CENTRELINE(Sliding);

TEST_P(Sliding, GivenStraightYarns_ThenTheForceDoesNotFeelTheNodes) {
  const double element = kHalfStitch / 20;
  for (const double degrees : {90.0, 45.0, 20.0, 12.0, 7.0, 3.0}) {
    verify_ripple(fmt::format("across a straight yarn at {} degrees", degrees),
                  slide_across(degrees * pi / 180, element, GetParam()), {3, 0.02});
  }
  verify_ripple("along a straight yarn", slide_along(element, GetParam()), {3, 0.02});
}

TEST_P(Sliding, GivenArcs_ThenTheForceDoesNotFeelTheNodesEither) {
  for (const int n : {10, 20}) {
    const double element = kHalfStitch / n;
    verify_ripple(fmt::format("across the outside of a head arc at N{}", n),
                  slide_across_arc(true, element, GetParam()), {40, 0.02});
    verify_ripple(fmt::format("across the inside of a head arc at N{}", n),
                  slide_across_arc(false, element, GetParam()), {40, 0.02});
    verify_ripple(fmt::format("along a head arc at N{}", n), slide_along_arc(element, GetParam()), {40, 0.02});
  }
}

TEST_P(Sliding, GivenTheMeshesN10ToN80_ThenTheForceIsTheSame) {
  struct Contact {
    std::string name;
    test::SlidingForce (*slide)(double element, model::Centreline centreline);
  };
  const std::vector<Contact> contacts = {
      {"straight yarns, crossing", [](double h, model::Centreline c) { return slide_across(pi / 2, h, c); }},
      {"outside of a head arc, crossing", [](double h, model::Centreline c) { return slide_across_arc(true, h, c); }},
      {"straight yarns, side by side", slide_along},
      {"head arcs, side by side", slide_along_arc}};
  for (const Contact& contact : contacts) {
    const double finest = contact.slide(kHalfStitch / 80, GetParam()).mean;
    for (const int n : {10, 20, 40}) {
      test::verify({.chapter = "mesh",
                    .of = fmt::format("{}, N{}, {}", contact.name, n, test::name_of(GetParam())),
                    .quantity = "mean normal force [mN]",
                    .source = "the same at N80",
                    .reference = 1e3 * finest,
                    .computed = 1e3 * contact.slide(kHalfStitch / n, GetParam()).mean,
                    .tolerance = test::allowed(GetParam(), 1, 0.01)});
    }
  }
}

}  // namespace
}  // namespace knitmech
