#include "beam/elements.h"

#include <gtest/gtest.h>

#include "../../support/beam_case.h"
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
}

}  // namespace
}  // namespace knitmech
