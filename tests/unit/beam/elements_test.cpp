#include "beam/elements.h"

#include <gtest/gtest.h>

#include "../../support/beam_case.h"
#include "beam/internal_force.h"
#include "beam/section_results.h"

namespace knitmech {
namespace {

TEST(Elements, GivenASlenderElement_ThenShearIsReducedAsInB31) {
  // A / I = 16 / D^2 = 1111: k G A' = k G A / (1 + 0.25 L0^2 A / (12 I))
  const yarn::Section section = test::section(20.0, 6.0, 0.018, 0.0124, 1.3e-11, 0.12);
  EXPECT_NEAR(beam::compensated_shear_stiffness(section, 0.9), 6.0 / (1 + 0.25 * 0.81 * (20.0 / 0.018) / 12), 1e-14);
  EXPECT_NEAR(beam::compensated_shear_stiffness(section, 1e-6), 6.0, 1e-9);
}

TEST(Elements, GivenAYarnOfLooseFilaments_ThenItsShearFallsNoLowerThanThatOfASolidYarn) {
  const yarn::Section solid = test::section(20.0, 6.0, 20.0 * 0.12 * 0.12 / 16, 0.0124, 1.3e-11, 0.12);
  yarn::Section loose = solid;
  loose.bending_stiffness = 5e-6;
  EXPECT_NEAR(beam::compensated_shear_stiffness(loose, 0.9), beam::compensated_shear_stiffness(solid, 0.9), 1e-12);
}

TEST(Elements, GivenTwoYarns_ThenTheGapBetweenThemHasNoStiffnessAndNoMass) {
  const model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {2, 0, 0}, 2), test::straight({0, 5, 0}, {2, 5, 0}, 2)},
                          test::section(19.0, 6.1, 0.0173, 0.0124, 1.3e-11));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.06);
  for (const std::size_t last : {2U, 5U}) {
    EXPECT_EQ(elements.axial[last], 0.0);
    EXPECT_EQ(elements.bending[last], 0.0);
    EXPECT_EQ(elements.mass[last], 0.0);
    EXPECT_EQ(elements.viscosity[last], 0.0);
  }
  EXPECT_NEAR(elements.mass[0], 1.3e-11, 1e-24);
  EXPECT_EQ(elements.axis_x[3], 1.0);
}

TEST(SectionResults, GivenAPureStretchABendAndATwist_ThenEachShowsInItsOwnField) {
  const double EA = 19.0, EI = 0.0173, GJ = 0.0124, length = 0.5;
  const model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {3 * length, 0, 0}, 3)}, test::section(EA, 6.1, EI, GJ, 1.3e-11));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  state.position.x[0] -= 0.01 * length;                                             // element 0: stretched by 1 %
  test::set_rotation(state, 2, test::turn({0, 0, 0.2}));                            // elements 1 and 2: bent by +-0.2
  test::set_rotation(state, 3, test::turn({0, 0, 0.2}) * test::turn({0.3, 0, 0}));  // element 2: twisted by 0.3
  model::Frame frame;
  beam::set_section_results(elements, state, frame);

  EXPECT_NEAR(frame.axial_force[0], EA * 0.01, 1e-12);
  EXPECT_NEAR(frame.bending_moment[0], 0.0, 1e-15);
  EXPECT_NEAR(frame.bending_moment[1], EI * 0.2 / length, 1e-12);
  EXPECT_NEAR(frame.curvature[1], 0.2 / length, 1e-12);
  EXPECT_NEAR(frame.torque[2], GJ * 0.3 / length, 1e-12);
  EXPECT_NEAR(frame.curvature[2], 0.0, 1e-12);
  EXPECT_EQ(frame.axial_force[3], 0.0);

  EXPECT_NEAR(frame.axial_strain[0], 0.01, 1e-14);
  EXPECT_NEAR(frame.stretch_energy[0], 0.5 * EA * 0.01 * 0.01 * length, 1e-14);
  EXPECT_NEAR(frame.bending_energy[1], 0.5 * EI * 0.2 * 0.2 / length, 1e-14);
  EXPECT_NEAR(frame.twist_energy[2], 0.5 * GJ * 0.3 * 0.3 / length, 1e-14);
  EXPECT_NEAR(frame.twist_energy[1], 0.0, 1e-16);
  EXPECT_NEAR(frame.bending_energy[2], 0.0, 1e-16);
}

TEST(SectionResults, GivenAnyState_ThenTheEnergiesOfStretchBendingAndTwistAddUpToTheStrainEnergy) {
  const model::Model model =
      test::yarns_through({{{0, 0, 0}, {0.8, 0.3, 0.1}, {1.4, -0.2, 0.5}}, {{0, 3, 0}, {1, 3.2, 0}, {2, 3, 0.4}}},
                          test::section(19.0, 6.1, 0.0173, 0.0124, 1.3e-11));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  model::State state = test::state_of(model);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto s = static_cast<double>(i);
    state.position.add(i, {0.1 * std::sin(s), 0.05 * s, -0.1 * std::cos(2 * s)});
    test::set_rotation(state, i, test::turn({0.4 * std::cos(s), 0.3 * s, -0.5 * std::sin(3 * s)}));
  }
  model::Frame frame;
  beam::set_section_results(elements, state, frame);
  double sum = 0;
  for (const auto* energies : {&frame.stretch_energy, &frame.bending_energy, &frame.twist_energy}) {
    for (const double energy : *energies) {
      EXPECT_GE(energy, 0.0);
      sum += energy;
    }
  }
  EXPECT_GT(sum, 1e-3);
  EXPECT_NEAR(sum, beam::strain_energy(elements, state), 1e-13 * sum);
}

}  // namespace
}  // namespace knitmech
