// Elements that follow a measured axial law: against the same elements with a straight law, against the law's integral,
// and their loads against the numerically differentiated energy.

#include "beam/nonlinear_axial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "../../support/beam_case.h"
#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "beam/section_results.h"

namespace knitmech {
namespace {

using Random = std::mt19937;

/// A yarn that is stiff at first, then soft, then stiff again; slope at zero 24 N.
const yarn::AxialLaw& measured() {
  static const yarn::AxialLaw law({{0, 0}, {0.02, 0.4}, {0.08, 0.9}, {0.15, 2.6}, {0.2, 4.6}});
  return law;
}

/// Section 0 follows the law, section 1 is linear.
model::Model crooked_yarn(const std::vector<int>& sections) {
  const double axial = measured().slope_at_zero();
  model::Model model = test::yarns_through({{{0, 0, 0}, {0.5, 0, 0.1}, {0.9, 0.4, 0}, {1.0, 0.9, 0.2}}},
                                           test::section(axial, 8, 0.02, 0.015, 1e-11));
  model.sections.push_back(model.sections.front());
  model.element_section = sections;
  model.axial_laws.emplace(0, measured());
  return model;
}

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Nodes moved so that elements are strained by -0.2 to 0.5, and turned by up to 1 rad.
model::State random_state(Random& random, const model::Model& model) {
  model::State state = test::state_of(model);
  const auto any = [&](double size) {
    return Eigen::Vector3d(between(random, -size, size), between(random, -size, size), between(random, -size, size));
  };
  const double stretch = between(random, 0.9, 1.3);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Eigen::Vector3d at = stretch * model.nodes[i] + any(0.05);
    state.position.set(i, {at.x(), at.y(), at.z()});
    test::set_rotation(state, i, test::turn(any(0.6)));
  }
  return state;
}

/// Elements, and what belongs to them, as the solver uses them.
struct Beams {
  beam::Elements elements;
  beam::NonlinearAxial nonlinear;

  explicit Beams(const model::Model& model) : elements(beam::make_elements(model, 1, 0)), nonlinear(model) {}

  double energy(const model::State& state) {
    nonlinear.set_secants(state, elements);
    return beam::strain_energy(elements, state) + nonlinear.energy_beyond_secants(elements, state);
  }
  model::NodalLoads loads(const model::State& state) {
    nonlinear.set_secants(state, elements);
    beam::ElementWork work(elements.size());
    model::NodalLoads loads(elements.size());
    beam::set_internal_force(elements, state, 0, work, loads);
    return loads;
  }
};

model::State moved(const model::State& state, std::size_t node, int axis, double by) {
  model::State other = state;
  const Eigen::Vector3d motion = by * Eigen::Vector3d::Unit(axis % 3);
  if (axis < 3) {
    other.position.add(node, {motion.x(), motion.y(), motion.z()});
  } else {
    test::set_rotation(other, node, test::turn(motion) * test::rotation_of(state, node));
  }
  return other;
}

double chord_strain(const model::Model& model, const model::State& state, std::size_t i) {
  const double now = (test::vector_at(state.position, i + 1) - test::vector_at(state.position, i)).norm();
  return now / (model.nodes[i + 1] - model.nodes[i]).norm() - 1;
}

/// Simpson's rule.
double integral_of_force(double strain) {
  constexpr int kParts = 2000;
  double sum = measured().force(0) + measured().force(strain);
  for (int i = 1; i < kParts; ++i) sum += (i % 2 == 1 ? 4 : 2) * measured().force(strain * i / kParts);
  return sum * strain / (3 * kParts);
}

TEST(NonlinearAxial, GivenRandomStates_ThenTheEnergyDiffersFromALinearYarnsByTheIntegralOfTheLaw) {
  // Reference: the linear yarn, in which EA e^2 / 2 is replaced by the integral of the law, taken numerically.
  const model::Model model = crooked_yarn({0, 1, 0, 0});
  model::Model linear = model;
  linear.axial_laws.clear();
  Beams with_law(model);
  Beams without(linear);
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const model::State state = random_state(random, model);
    double expected = without.energy(state);
    for (const std::size_t i : {0U, 2U}) {
      const double strain = chord_strain(model, state, i);
      const double length = (model.nodes[i + 1] - model.nodes[i]).norm();
      expected += length * (integral_of_force(strain) - 0.5 * measured().slope_at_zero() * strain * strain);
    }
    EXPECT_NEAR(with_law.energy(state), expected, 1e-7 * expected) << "trial " << trial;
  }
}

TEST(NonlinearAxial, GivenRandomStates_ThenTheLoadsAreTheNegativeDerivativeOfTheEnergy) {
  const model::Model model = crooked_yarn({0, 1, 0, 0});
  Beams beams(model);
  Random random(5);
  double largest_error = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const model::State state = random_state(random, model);
    const model::NodalLoads loads = beams.loads(state);
    for (std::size_t node = 0; node < 4; ++node) {
      for (int axis = 0; axis < 6; ++axis) {
        const double h = 1e-5;
        const double slope =
            (beams.energy(moved(state, node, axis, h)) - beams.energy(moved(state, node, axis, -h))) / (2 * h);
        const double load = test::vector_at(axis < 3 ? loads.force : loads.moment, node)[axis % 3];
        largest_error = std::max(largest_error, std::abs(load + slope));
      }
    }
  }
  // Forces are up to 10 N; the differences leave 1e-8 N and, across a corner of the law's slope, 1e-6 N.
  EXPECT_LT(largest_error, 1e-5);
}

TEST(NonlinearAxial, GivenALawOfTwoPoints_ThenNothingDiffersFromALinearYarn) {
  model::Model model = crooked_yarn({0, 0, 0, 0});
  model.axial_laws.clear();
  Beams linear(model);
  const double axial = model.sections.front().axial_stiffness;
  model.axial_laws.emplace(0, yarn::AxialLaw({{0, 0}, {0.1, 0.1 * axial}}));
  Beams straight(model);
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const model::State state = random_state(random, model);
    EXPECT_NEAR(straight.energy(state), linear.energy(state), 1e-12 * linear.energy(state));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT(
          (test::vector_at(straight.loads(state).force, i) - test::vector_at(linear.loads(state).force, i)).norm(),
          1e-11);
    }
  }
}

TEST(NonlinearAxial, GivenAFrame_ThenForcesAreThoseOfTheLawAndTheEnergiesOfItsElementsAddUp) {
  const model::Model model = crooked_yarn({0, 1, 0, 0});
  Beams beams(model);
  Random random(11);
  const model::State state = random_state(random, model);
  const double energy = beams.energy(state);
  model::Frame frame;
  beam::set_section_results(beams.elements, state, frame);
  beams.nonlinear.correct_stretch_energy(beams.elements, frame);
  double sum = 0;
  double stretch = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double strain = chord_strain(model, state, i);
    const double expected = i == 1 ? measured().slope_at_zero() * strain : measured().force(strain);
    EXPECT_NEAR(frame.axial_force[i], expected, 1e-12 * std::abs(expected)) << "element " << i;
    stretch += frame.stretch_energy[i];
    sum += frame.stretch_energy[i] + frame.bending_energy[i] + frame.twist_energy[i];
  }
  EXPECT_NEAR(sum, energy, 1e-12 * energy);
  const double of_all =
      beam::stretch_energy(beams.elements, state) + beams.nonlinear.energy_beyond_secants(beams.elements, state);
  EXPECT_NEAR(stretch, of_all, 1e-12 * of_all);
  EXPECT_LT(stretch, 0.99 * energy);  // so there is bending and twist as well
}

TEST(NonlinearAxial, GivenALawThatStiffens_ThenTheStableStepAndTheViscosityAreThoseOfItsLargestSlope) {
  // Reference: w^2 = 2 EA / (L0 m), m half the element's mass, and b1 sqrt(EA rho A), EA the largest slope.
  model::Model model = test::yarns_through({test::straight({0, 0, 0}, {3, 0, 0}, 3)},
                                           test::section(measured().slope_at_zero(), 1, 0.02, 0.015, 1e-11));
  model.axial_laws.emplace(0, measured());
  const double slope = measured().largest_slope();
  ASSERT_GT(slope, 1.5 * measured().slope_at_zero());
  const beam::Elements elements = beam::make_elements(model, 4, 0.06);
  EXPECT_NEAR(beam::lump_inertia(elements, 4).highest_frequency_squared, 2 * slope / (4 * 0.5e-11),
              1e-3 * slope / 1e-11);
  EXPECT_NEAR(elements.viscosity[1], 0.06 * std::sqrt(slope * 1e-11 * 4), 1e-12);
}

TEST(NonlinearAxial, GivenAnElementThatIsRemoved_ThenItIsLeftAsItIs) {
  const model::Model model = crooked_yarn({0, 0, 0, 0});
  Beams beams(model);
  beams.nonlinear.remove(1);
  beams.elements.axial[1] = 0;
  Random random(13);
  beams.nonlinear.set_secants(random_state(random, model), beams.elements);
  EXPECT_EQ(beams.elements.axial[1], 0);
  EXPECT_GT(beams.elements.axial[0], 0);
}

}  // namespace
}  // namespace knitmech
