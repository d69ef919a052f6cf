// The deck of a yarn that follows a measured curve.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.h"
#include "deck_models.h"

namespace knitmech::exchange {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

model::Model measured_fabric() {
  model::Case input = fabric_case(2, 2);
  input.yarn.youngs_modulus.reset();
  input.yarn.curve_strains = {0, 0.05, 0.1, 0.2};
  input.yarn.curve_forces = {0, 0.9, 1.2, 2.6};
  input.yarn.strength = 2.5;
  return model::build_model(input);
}

TEST(AbaqusDeckOfCurve, HasTheLinesThatTheKeywordGuideAsksFor) {
  // *AXIAL: force, then strain; a linear behaviour has its stiffness alone.
  const std::string text = deck_text(measured_fabric());
  EXPECT_THAT(text, AllOf(HasSubstr("*BEAM GENERAL SECTION, ELSET=SECTION_1, SECTION=NONLINEAR GENERAL, DENSITY="),
                          HasSubstr("*AXIAL, ELASTIC\n"), HasSubstr("*M1, LINEAR\n"), HasSubstr("*M2, LINEAR\n"),
                          HasSubstr("*TORQUE, LINEAR\n"), HasSubstr("*TRANSVERSE SHEAR STIFFNESS\n"),
                          HasSubstr("breaks at 2.5 N; here it does not")));
  EXPECT_THAT(text, testing::Not(HasSubstr("*MATERIAL, NAME")));
}

TEST(AbaqusDeckOfCurve, IsReadBackAsTheCurveAndTheStiffnessesOfTheModel) {
  const model::Model model = measured_fabric();
  const AbaqusDeck deck = deck_of(deck_text(measured_fabric()));
  EXPECT_TRUE(deck.unread.empty());
  ASSERT_EQ(deck.sections.size(), 1U);
  const AbaqusDeck::Section& section = deck.sections.front();
  const yarn::AxialLaw& law = model.axial_laws.at(0);
  ASSERT_EQ(section.axial_curve.size(), 27U);  // three times eight, the last point, and one beyond each end
  for (const auto& [strain, force] : section.axial_curve) EXPECT_NEAR(force, law.force(strain), 1e-12) << strain;
  EXPECT_EQ(section.axial_curve.front().first, -1);
  EXPECT_NEAR(section.axial_curve.back().first, 1.2, 1e-12);
  EXPECT_NEAR(section.bending_1, model.sections[0].bending_stiffness, 1e-12);
  EXPECT_NEAR(section.bending_2, model.sections[0].bending_stiffness, 1e-12);
  EXPECT_NEAR(section.torsion, model.sections[0].torsional_stiffness, 1e-12);
  const double area = section.dimensions.at(0);
  EXPECT_NEAR(section.density * area, model.sections[0].mass_per_length, 1e-9 * model.sections[0].mass_per_length);
  // Between the lines the curve is straight there; the smooth one is within 1 % of its largest force.
  for (std::size_t i = 2; i + 1 < section.axial_curve.size(); ++i) {
    const auto [strain_a, force_a] = section.axial_curve[i - 1];
    const auto [strain_b, force_b] = section.axial_curve[i];
    EXPECT_NEAR(0.5 * (force_a + force_b), law.force(0.5 * (strain_a + strain_b)), 0.01 * 2.6);
  }
}

TEST(AbaqusDeckOfCurve, GivesTheContactTheDiameterOfTheYarn) {
  const AbaqusDeck deck = deck_of(deck_text(measured_fabric()));
  ASSERT_TRUE(deck.contact.has_value());
  EXPECT_EQ(deck.contact->thickness.at("SECTION_1_SURFACE"), 0.12);
}

TEST(AbaqusDeckOfCurve, IsRefusedWhereItIsDamaged) {
  const auto damaged = [](const std::string& before, const std::string& after) {
    std::string text = deck_text(measured_fabric());
    text.replace(text.find(before), before.size(), after);
    return [text] { (void)deck_of(text); };
  };
  EXPECT_THAT(damaged("*AXIAL, ELASTIC", "*AXIAL"), ThrowsMessage<InputError>(HasSubstr("must be LINEAR, or ELASTIC")));
  EXPECT_THAT(damaged("*M1, LINEAR", "*M1, ELASTIC"), ThrowsMessage<InputError>(HasSubstr("must be LINEAR")));
  EXPECT_THAT(damaged("*NODE\n", "*AXIAL, LINEAR\n1.,\n*NODE\n"),
              ThrowsMessage<InputError>(HasSubstr("without a NONLINEAR GENERAL section before it")));
  EXPECT_THAT(damaged("*AXIAL, ELASTIC\n", "*AXIAL, ELASTIC\n0., 3.\n"),
              ThrowsMessage<InputError>(HasSubstr("strains of *AXIAL must ascend")));
}

}  // namespace
}  // namespace knitmech::exchange
