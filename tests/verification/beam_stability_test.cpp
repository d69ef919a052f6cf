// The load at which a yarn buckles, from the loads of the elements about the state before buckling, and in motion.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../support/beam_case.h"
#include "../support/monofilament.h"
#include "../support/stiffness.h"
#include "../support/verification.h"
#include "solve/integrate.h"

namespace knitmech {
namespace {

using std::numbers::pi;

constexpr double kLength = 10;  // [mm]

/// The positive zero of a function that changes its sign once between low and high.
template <typename Function>
double zero_between(Function function, double low, double high) {
  const bool rises = function(high) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((function(middle) > 0) == rises ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// tan(u) = u beyond zero: 4.4934. It belongs to the clamped and hinged column, and to the twisted one.
double first_zero_of_tan_u_less_u() {
  return zero_between([](double u) { return std::sin(u) - u * std::cos(u); }, pi, 1.5 * pi);
}

struct Column {
  model::Model model;
  beam::Elements elements;
  model::State state;

  explicit Column(int n_elements)
      : model(test::yarns_through({test::straight({0, 0, 0}, {kLength, 0, 0}, n_elements)}, test::monofilament())),
        elements(beam::make_elements(model, 1.0, 0.0)),
        state(test::state_of(model)) {}
};

std::vector<Eigen::Index> all_of(Eigen::Index node) {
  return {6 * node, 6 * node + 1, 6 * node + 2, 6 * node + 3, 6 * node + 4, 6 * node + 5};
}

/// Euler's column: the thrust at which the lowest frequency about the compressed straight state is zero. The thrust is
/// a dead load and has no stiffness of its own.
/// \param held degrees of freedom of the first node   \param held_at_end axes of the last one
double buckling_thrust(std::vector<Eigen::Index> held, const std::vector<Eigen::Index>& held_at_end, double guess) {
  const int n = 40;
  const Eigen::Index end = n;
  Column column(n);
  for (const Eigen::Index axis : held_at_end) held.push_back(6 * end + axis);
  const test::Freedom freedom = test::Freedom::without(n + 1, held);
  const auto lowest = [&](double thrust) {
    for (std::size_t i = 0; i <= n; ++i)
      column.state.position.x[i] = column.model.nodes[i].x() * (1 - thrust / test::kAxial);
    return test::modes_of(column.elements, column.state, freedom).squared[0];
  };
  return test::root_of(lowest, 0.8 * guess, 0.9 * guess);
}

TEST(Buckling, GivenAStraightYarnUnderThrust_ThenItBucklesAtEulersLoad) {
  const double unit = test::kBending / (kLength * kLength);
  const double hinged_clamped = std::pow(first_zero_of_tan_u_less_u(), 2);
  const std::vector<Eigen::Index> clamped = all_of(0);
  const std::vector<Eigen::Index> hinged{0, 1, 2, 3};  // neither moves nor turns about itself
  struct End {
    const char* of;
    const char* source;
    std::vector<Eigen::Index> start, end;
    double reference;
  };
  for (const End& ends : {End{"clamped and free", "(pi / 2)^2", clamped, {}, pi * pi / 4},
                          End{"hinged at both ends", "pi^2", hinged, {1, 2}, pi * pi},
                          End{"clamped and hinged", "u^2 with tan(u) = u", clamped, {1, 2}, hinged_clamped},
                          End{"clamped at both ends", "4 pi^2", clamped, {1, 2, 3, 4, 5}, 4 * pi * pi}}) {
    test::verify({.chapter = "buckling",
                  .of = std::string("thrust, ") + ends.of,
                  .quantity = "P L^2 / EI [-]",
                  .source = ends.source,
                  .reference = ends.reference,
                  .computed = buckling_thrust(ends.start, ends.end, unit * ends.reference) / unit,
                  .tolerance = 0.005});
  }
}

/// Greenhill's rod, clamped at both ends and twisted. Small deflections w = y + i z of a rod under the torque M and no
/// thrust obey EI w'''' - i M w''' = 0, so w = A + B s + C s^2 + D exp(i k s) with k = M / EI. With w = w' = 0 at both
/// ends the determinant is zero if and only if tan(k L / 2) = k L / 2.
TEST(Buckling, GivenAStraightYarnThatIsTwisted_ThenItBucklesAtGreenhillsTorque) {
  const int n = 80;
  Column column(n);
  std::vector<Eigen::Index> held = all_of(0);
  for (const Eigen::Index at_end : all_of(n)) held.push_back(at_end);
  const test::Freedom freedom = test::Freedom::without(n + 1, held);
  const auto lowest = [&](double torque) {
    for (std::size_t i = 0; i <= n; ++i) {
      const double twist = torque / test::kTorsion * column.model.nodes[i].x();
      test::set_rotation(column.state, i, test::turn({twist, 0, 0}));
    }
    return test::modes_of(column.elements, column.state, freedom).squared[0];
  };
  const double reference = 2 * first_zero_of_tan_u_less_u();
  const double unit = test::kBending / kLength;
  test::verify({.chapter = "buckling",
                .of = "torque, clamped at both ends",
                .quantity = "M L / EI [-]",
                .source = "2 u with tan(u) = u",
                .reference = reference,
                .computed = test::root_of(lowest, 0.8 * reference * unit, 0.9 * reference * unit) / unit,
                .tolerance = 0.005});
}

/// A straight yarn bent to a closed ring in the plane x, y and twisted before its ends are joined.
///
/// In equilibrium the ring carries the torque T = GJ twist / L and, across its plane, the force T / R. With t = e_theta
/// + alpha e_r + beta e_z, a small disturbance alpha = a cos(n s / R), beta = b sin(n s / R) of moment and force
/// balance, EI t x t'' + T t' + t x n = 0, gives for n >= 2
///
///     EI b (1 - n^2) / R^2 = T a n / R        EI a n^2 / R^2 = -T b n / R
///
/// and so T = EI sqrt(n^2 - 1) / R: first, for n = 2, the twist 2 pi sqrt(3) EI / GJ (Michell 1889, Zajac 1962).
struct TwistedRing {
  static constexpr int kElements = 60;
  model::Model model;
  beam::Elements elements;
  model::State state;
  test::Freedom freedom = test::Freedom::closed(kElements + 1);

  TwistedRing(double torsion, double twist)
      : model(
            test::yarns_through({test::straight({0, 0, 0}, {kLength, 0, 0}, kElements)}, test::monofilament(torsion))),
        elements(beam::make_elements(model, 1.0, 0.0)),
        state(test::state_of(model)) {
    const double radius = kLength / kElements / (2 * std::sin(pi / kElements));
    for (std::size_t i = 0; i <= kElements; ++i) {
      const double share = static_cast<double>(i) / kElements;
      const double angle = 2 * pi * share;
      state.position.set(i, {radius * std::sin(angle), -radius * std::cos(angle), 0});
      test::set_rotation(state, i, test::turn({0, 0, angle}) * test::turn({twist * share, 0, 0}));
    }
  }

  /// Lets shear take up the force across the plane: Newton's method on everything but the motions without stiffness.
  void settle() {
    for (int i = 0; i < 3; ++i) {
      const test::Modes modes = test::modes_of(elements, state, freedom);
      const Eigen::VectorXd push = modes.shapes.transpose() * test::loads_of(elements, state);
      const double stiff = 1e-9 * modes.squared.maxCoeff();
      Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero(push.size());
      for (Eigen::Index k = 0; k < push.size(); ++k) {
        if (std::abs(modes.squared[k]) > stiff) amplitudes[k] = push[k] / modes.squared[k];
      }
      test::displace(state, modes.shapes * amplitudes);
    }
  }

  /// Squared frequency of the first mode with stiffness. The ring moves freely in six ways as a rigid body and in a
  /// seventh by turning every section alike about the axis.
  [[nodiscard]] double softest() const {
    const Eigen::VectorXd squared = test::modes_of(elements, state, freedom).squared;
    const double stiff = 1e-9 * squared.maxCoeff();
    return squared[0] < -stiff ? squared[0] : squared[7];
  }
};

double michell_twist(double torsion) {
  return 2 * pi * std::sqrt(3.0) * test::kBending / torsion;
}

TEST(TwistedRing, GivenAnyTorsionalStiffness_ThenTheRingLosesItsStabilityAtMichellsTwist) {
  for (const double ratio : {0.5, 0.72, 1.0}) {
    const double torsion = ratio * test::kBending;
    const auto softest = [&](double twist) {
      TwistedRing ring(torsion, twist);
      ring.settle();
      return ring.softest();
    };
    const double reference = michell_twist(torsion);
    test::verify({.chapter = "twisted ring",
                  .of = fmt::format("GJ / EI = {}, 60 elements", ratio),
                  .quantity = "critical twist [rad]",
                  .source = "2 pi sqrt(3) EI / GJ",
                  .reference = reference,
                  .computed = test::root_of(softest, 0.93 * reference, 0.97 * reference),
                  .tolerance = 0.01});
  }
}

/// Largest distance from the plane [mm] that the ring reaches after it was pushed out of its plane with the speed 1
/// mm/s in the shape of its buckle.
double largest_deflection(double share_of_critical_twist) {
  TwistedRing ring(test::kTorsion, share_of_critical_twist * michell_twist(test::kTorsion));
  ring.settle();
  const beam::NodalInertia inertia = beam::lump_inertia(ring.elements, 1.0);
  const double step = 0.9 * 2 / std::sqrt(inertia.highest_frequency_squared);
  const std::size_t last = TwistedRing::kElements;
  for (std::size_t i = 0; i <= last; ++i) {
    ring.state.velocity.z[i] = std::cos(4 * pi * static_cast<double>(i) / static_cast<double>(last));
  }
  beam::ElementWork work(last + 1);
  model::NodalLoads loads(last + 1);
  double largest = 0;
  for (double time = 0; time < 0.01; time += step) {
    beam::set_internal_force(ring.elements, ring.state, step, work, loads);
    for (model::VectorArray* load : {&loads.force, &loads.moment}) {  // both ends have half a node's inertia
      const Vector3 mean = 0.5 * (load->at(0) + load->at(last));
      load->set(0, mean);
      load->set(last, mean);
    }
    solve::integrate(inertia, loads, {step, step}, 0.0, ring.state);
    for (const double z : ring.state.position.z) largest = std::max(largest, std::abs(z));
  }
  return largest;
}

TEST(TwistedRing, GivenLessThanMichellsTwistAndMore_ThenOneRingTremblesAndTheOtherLeavesItsPlane) {
  const double below = largest_deflection(0.95);
  const double above = largest_deflection(1.05);
  // The ring's radius is 1.6 mm. A stable one swings by its speed over the frequency of the mode, some 1e4 / s.
  EXPECT_LT(below, 1e-3);
  EXPECT_GT(above, 0.5);
}

}  // namespace
}  // namespace knitmech
