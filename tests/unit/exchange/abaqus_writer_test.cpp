#include "exchange/abaqus_writer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "deck_models.h"

namespace knitmech::exchange {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

/// A model, its deck and what is read back from it.
struct RoundTrip {
  explicit RoundTrip(const model::Case& input, const AbaqusOptions& options = {})
      : model(model::build_model(input)), text(deck_text(model, options)), deck(deck_of(text)) {}
  model::Model model;
  std::string text;
  AbaqusDeck deck;
};

/// The two fabrics every statement about nodes, elements and sets is tested on.
class AbaqusDeckOfFabric : public testing::TestWithParam<int> {
 protected:
  static model::Case input() { return GetParam() == 0 ? fabric_case(9, 15) : measured_yarn_case(); }
  RoundTrip trip{input()};
};

INSTANTIATE_TEST_SUITE_P(Fabrics, AbaqusDeckOfFabric, testing::Values(0, 1),
                         [](const auto& info) { return info.param == 0 ? "Monofilament9x15" : "MeasuredYarn3x2"; });

// Bit by bit from 0.1 mm upward; below that Abaqus' 20 characters leave 1e-17 mm.
TEST_P(AbaqusDeckOfFabric, HasEveryNodeWhereTheModelHasIt) {
  ASSERT_EQ(trip.deck.nodes.size(), trip.model.nodes.size());
  for (std::size_t i = 0; i < trip.model.nodes.size(); ++i) {
    const Eigen::Vector3d& expected = trip.model.nodes[i];
    const Eigen::Vector3d& found = trip.deck.nodes.at(static_cast<int>(i) + 1);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(expected[axis]) >= 0.1) {
        ASSERT_EQ(found[axis], expected[axis]) << "node " << i + 1;
      } else {
        ASSERT_LE(std::abs(found[axis] - expected[axis]), 1e-17) << "node " << i + 1;
      }
    }
  }
}

TEST_P(AbaqusDeckOfFabric, HasEveryElementOfEveryCourseInTheOrderOfTheYarn) {
  ASSERT_EQ(trip.deck.elements.size(), static_cast<std::size_t>(trip.model.n_elements()));
  int number = 0;
  for (const model::ModelYarn& yarn : trip.model.yarns) {
    std::vector<int> course;
    for (int node = yarn.first_node; node < yarn.first_node + yarn.n_nodes - 1; ++node) {
      const AbaqusDeck::Element& element = trip.deck.elements.at(++number);
      EXPECT_EQ(element.type, "B31");
      ASSERT_THAT(element.nodes, ElementsAre(node + 1, node + 2)) << "element " << number;
      course.push_back(number);
    }
    EXPECT_EQ(trip.deck.element_sets
                  .at(fmt::format("COURSE_{}", trip.model.course[static_cast<std::size_t>(yarn.first_node)] + 1))
                  .members,
              course);
  }
  EXPECT_EQ(trip.deck.element_sets.at("YARNS").members.size(), trip.deck.elements.size());
}

TEST_P(AbaqusDeckOfFabric, HasEveryNodeOfEverySet) {
  EXPECT_THAT(trip.deck.node_sets, testing::SizeIs(trip.model.node_sets.size()));
  for (const auto& [name, nodes] : trip.model.node_sets) {
    std::vector<int> numbers(nodes);
    for (int& number : numbers) ++number;
    EXPECT_EQ(trip.deck.node_sets.at(in_capitals(name)).members, numbers) << name;
  }
}

// The trap of beams in Abaqus: a first axis along an element leaves its section undefined.
TEST_P(AbaqusDeckOfFabric, HasAFirstAxisFarFromEveryElement) {
  for (const AbaqusDeck::Section& section : trip.deck.sections) {
    const Eigen::Vector3d axis = section.first_axis.normalized();
    for (const int number : trip.deck.element_sets.at(section.element_set).members) {
      const std::vector<int>& nodes = trip.deck.elements.at(number).nodes;
      const Eigen::Vector3d tangent = (trip.deck.nodes.at(nodes[1]) - trip.deck.nodes.at(nodes[0])).normalized();
      ASSERT_LE(std::abs(axis.dot(tangent)), std::numbers::sqrt2 / 2) << "element " << number;
    }
  }
}

TEST_P(AbaqusDeckOfFabric, DrivesTheGripAsTheTestOfTheModelDoes) {
  const model::TensileTest& test = trip.model.test;
  const AbaqusDeck::Step& step = trip.deck.steps.at(0);
  ASSERT_EQ(trip.deck.steps.size(), 1U);
  EXPECT_TRUE(step.explicit_dynamics);
  EXPECT_TRUE(step.large_displacements);
  EXPECT_DOUBLE_EQ(step.duration, test.time_at(test.strain));
  ASSERT_EQ(step.boundaries.size(), 1U);
  const AbaqusDeck::Boundary& driven = step.boundaries.front();
  EXPECT_EQ(driven.nodes, "TOP_HEADS");
  EXPECT_EQ(driven.type, "VELOCITY");
  EXPECT_EQ(driven.first_dof, 2);
  EXPECT_EQ(driven.last_dof, 2);
  const AbaqusDeck::Amplitude& amplitude = trip.deck.amplitudes.at(driven.amplitude);
  for (int i = 0; i <= 2000; ++i) {
    const double time = step.duration * i / 2000;
    ASSERT_NEAR(driven.value * amplitude.value(time), test.velocity(time), 1e-12) << "at " << time << " s";
  }
}

TEST_P(AbaqusDeckOfFabric, HasOneContactWithTheFrictionOfTheModel) {
  ASSERT_TRUE(trip.deck.contact.has_value());
  EXPECT_TRUE(trip.deck.contact->all_exterior);
  ASSERT_EQ(trip.deck.contact->properties.size(), 1U);
  const AbaqusDeck::Contact::Property& property = trip.deck.contact->properties.front();
  EXPECT_EQ(property.surface_a, property.surface_b);
  EXPECT_THAT(trip.deck.surfaces.at(property.surface_a).sets, ElementsAre("YARNS"));
  const AbaqusDeck::Interaction& interaction = trip.deck.interactions.at(property.interaction);
  EXPECT_EQ(interaction.friction, trip.model.friction);
  EXPECT_EQ(interaction.pressure_overclosure, "HARD");
}

TEST_P(AbaqusDeckOfFabric, IsReadWithoutALeftoverAndTheSameEveryTime) {
  EXPECT_TRUE(trip.deck.unread.empty());
  EXPECT_EQ(deck_text(trip.model), trip.text);
  for (const std::string& line : lines_of(trip.text)) ASSERT_LE(line.size(), 256U) << line;
}

TEST(AbaqusDeckOfMonofilament, HasTheRadiusNotTheDiameterAndTheMaterialOfTheCase) {
  const RoundTrip trip(fabric_case(9, 15));
  ASSERT_EQ(trip.deck.sections.size(), 1U);
  const AbaqusDeck::Section& section = trip.deck.sections.front();
  EXPECT_EQ(section.kind, AbaqusDeck::SectionKind::beam);
  EXPECT_EQ(section.shape, "CIRC");
  EXPECT_THAT(section.dimensions, ElementsAre(0.06));
  EXPECT_EQ(section.first_axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(section.rotary_inertia, "ISOTROPIC");
  const double shear = trip.model.sections.front().shear_stiffness;
  EXPECT_THAT(section.transverse_shear, ElementsAre(testing::DoubleEq(shear), testing::DoubleEq(shear), 0.25));
  const AbaqusDeck::Material& material = trip.deck.materials.at(section.material);
  EXPECT_EQ(material.density, 1.14e-9);
  EXPECT_EQ(material.youngs_modulus, 1700);
  EXPECT_EQ(material.poissons_ratio, 0.39);
}

// Straight from the text, without the reader: what Abaqus would see.
TEST(AbaqusDeckOfMonofilament, HasTheSectionLinesThatTheKeywordGuideAsksFor) {
  const RoundTrip trip(fabric_case(9, 15));
  const std::vector<std::string> lines = lines_of(trip.text);
  const auto section =
      std::find(lines.begin(), lines.end(),
                "*BEAM SECTION, ELSET=SECTION_1, MATERIAL=YARN_1, SECTION=CIRC, ROTARY INERTIA=ISOTROPIC");
  ASSERT_NE(section, lines.end());
  EXPECT_EQ(section[1], "0.06");
  EXPECT_EQ(section[2], "0., 0., 1.");
  EXPECT_EQ(section[3], "*TRANSVERSE SHEAR STIFFNESS");
  EXPECT_THAT(lines, Contains("*ELEMENT, TYPE=B31, ELSET=COURSE_15"));
  EXPECT_THAT(lines, Contains("1700., 0.39"));
  EXPECT_THAT(lines, Contains("bottom_feet, 1, 6"));
  EXPECT_THAT(lines, Contains("top_heads, 2, 2, 5."));
}

// 27 and 28 nodes need two lines each.
TEST(AbaqusDeckOfMonofilament, HasAtMost16NodesOnALineOfASet) {
  const RoundTrip trip(fabric_case(9, 15));
  const std::vector<std::string> lines = lines_of(trip.text);
  const auto set = std::find(lines.begin(), lines.end(), "*NSET, NSET=bottom_feet");
  ASSERT_NE(set, lines.end());
  EXPECT_EQ(std::count(set[1].begin(), set[1].end(), ','), 15);
  EXPECT_EQ(std::count(set[2].begin(), set[2].end(), ','), 11);
  EXPECT_EQ(trip.deck.node_sets.at("BOTTOM_FEET").members.size(), 28U);
  EXPECT_EQ(trip.deck.node_sets.at("TOP_HEADS").members.size(), 27U);
}

TEST(AbaqusDeckOfMeasuredYarn, KeepsEveryStiffnessAndTheMassInAGeneralSection) {
  const RoundTrip trip(measured_yarn_case());
  const yarn::Section& yarn = trip.model.sections.front();
  ASSERT_EQ(trip.deck.sections.size(), 1U);
  const AbaqusDeck::Section& section = trip.deck.sections.front();
  EXPECT_EQ(section.kind, AbaqusDeck::SectionKind::general_beam);
  EXPECT_EQ(section.shape, "GENERAL");
  ASSERT_EQ(section.dimensions.size(), 5U);  // A, I11, I12, I22, J
  ASSERT_EQ(section.moduli.size(), 2U);      // E, G
  const auto expect_share = [](double found, double expected) { EXPECT_NEAR(found, expected, 1e-11 * expected); };
  expect_share(section.moduli[0] * section.dimensions[0], yarn.axial_stiffness);
  expect_share(section.moduli[0] * section.dimensions[1], yarn.bending_stiffness);
  EXPECT_EQ(section.dimensions[2], 0);
  EXPECT_EQ(section.dimensions[3], section.dimensions[1]);
  expect_share(section.moduli[1] * section.dimensions[4], yarn.torsional_stiffness);
  expect_share(section.density * section.dimensions[0], yarn.mass_per_length);
  expect_share(section.transverse_shear.at(0), yarn.shear_stiffness);
  EXPECT_TRUE(trip.deck.materials.empty());
}

// A general section has no outline, so the contact is told the diameter.
TEST(AbaqusDeckOfMeasuredYarn, GivesTheContactTheDiameterOfTheYarn) {
  const RoundTrip trip(measured_yarn_case());
  ASSERT_EQ(trip.deck.contact->thickness.size(), 1U);
  const auto& [surface, thickness] = *trip.deck.contact->thickness.begin();
  EXPECT_EQ(thickness, 0.12);
  EXPECT_THAT(trip.deck.surfaces.at(surface).sets, ElementsAre("SECTION_1"));
}

std::vector<std::string> held(const AbaqusDeck& deck) {
  std::vector<std::string> result;
  for (const AbaqusDeck::Boundary& boundary : deck.boundaries) {
    EXPECT_EQ(boundary.value, 0);
    EXPECT_EQ(boundary.type, "DISPLACEMENT");
    result.push_back(fmt::format("{} {}-{}", boundary.nodes, boundary.first_dof, boundary.last_dof));
  }
  return result;
}

TEST(AbaqusDeckGrips, ClampedHoldEverythingButThePull) {
  const RoundTrip trip(fabric_case(3, 2));
  EXPECT_THAT(held(trip.deck), ElementsAre("BOTTOM_FEET 1-6", "TOP_HEADS 1-1", "TOP_HEADS 3-6"));
}

TEST(AbaqusDeckGrips, SlidingLeaveTheTopFreeAcrossThePull) {
  model::Case input = fabric_case(3, 2);
  input.test.grips = model::Grips::sliding;
  const RoundTrip trip(input);
  EXPECT_THAT(held(trip.deck), ElementsAre("BOTTOM_FEET 1-6", "TOP_HEADS 4-6"));
}

// Given no ramp, or a test that ends within it, then the velocity is still that of the model.
TEST(AbaqusDeckGrips, FollowShortRampsToo) {
  for (const double ramp : {0.0, 100.0}) {
    model::Case input = fabric_case(3, 2);
    input.test.ramp = ramp;
    const RoundTrip trip(input);
    const AbaqusDeck::Boundary& driven = trip.deck.steps.at(0).boundaries.at(0);
    for (const double share : {0.01, 0.3, 1.0}) {
      const double time = share * trip.deck.steps[0].duration;
      EXPECT_NEAR(driven.value * trip.deck.amplitudes.at(driven.amplitude).value(time), trip.model.test.velocity(time),
                  1e-12)
          << "ramp " << ramp << " s, time " << time << " s";
    }
  }
}

TEST(AbaqusDeckOptions, WriteMassScalingOnlyIfThereIsSome) {
  const RoundTrip plain(fabric_case(3, 2));
  EXPECT_FALSE(plain.deck.steps.at(0).mass_scaling.has_value());
  EXPECT_EQ(plain.deck.steps[0].linear_bulk_viscosity, 0.06);
  EXPECT_EQ(plain.deck.steps[0].quadratic_bulk_viscosity, 0);
  const RoundTrip scaled(fabric_case(3, 2), {1e4, 0.03});
  EXPECT_EQ(scaled.deck.steps.at(0).mass_scaling, 1e4);
  EXPECT_EQ(scaled.deck.steps[0].linear_bulk_viscosity, 0.03);
}

TEST(AbaqusDeckOutput, HasTheForcesOfBothGripsTheEnergiesAndTheContactForces) {
  const RoundTrip trip(fabric_case(3, 2));
  std::vector<std::string> requests;
  for (const AbaqusDeck::OutputRequest& request : trip.deck.steps.at(0).output) {
    for (const std::string& variable : request.variables) {
      const auto set = request.options.find("NSET");
      requests.push_back(fmt::format("{} {} {}", request.history ? "history" : "field",
                                     set == request.options.end() ? "all" : set->second, variable));
    }
  }
  EXPECT_THAT(requests,
              testing::IsSupersetOf({"history TOP_HEADS RF2", "history BOTTOM_FEET RF2", "history all ALLWK",
                                     "history all ALLIE", "history all ALLKE", "history all ALLFD", "field all U",
                                     "field all RF", "field all SF", "field all SE", "field all CFORCE"}));
}

TEST(AbaqusDeckHeading, HasTheTitleAndTheUnits) {
  const RoundTrip trip(fabric_case(3, 2));
  EXPECT_THAT(trip.deck.heading,
              ElementsAre("KnitMech: Monofilament jersey, wale-wise tension", HasSubstr("mm, N, s, t, MPa")));
}

TEST(AbaqusDeckHeading, TakesATitleThatLooksLikeAKeyword) {
  model::Case input = fabric_case(3, 2);
  input.title = "*NODE\n*END STEP";
  const RoundTrip trip(input);
  EXPECT_EQ(trip.deck.heading.front(), "KnitMech: *NODE?*END STEP");
}

/// A yarn that climbs straight up in its middle, so that no one axis suits all its elements.
model::Model climbing_yarn() {
  model::Model model = model::build_model(fabric_case(3, 2));
  model.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {2, 0, 1}};
  model.yarns = {{0, 4}};
  model.element_section.assign(4, 0);
  model.course.assign(4, 0);
  model.node_sets = {{model::kBottomFeet, {0}}, {model::kTopHeads, {3}}};
  return model;
}

TEST(AbaqusDeckFirstAxis, IsAnotherForElementsAlongTheNormalOfTheFabric) {
  const AbaqusDeck deck = deck_of(deck_text(climbing_yarn()));
  ASSERT_EQ(deck.sections.size(), 2U);
  EXPECT_EQ(deck.sections[0].first_axis, Eigen::Vector3d(1, 0, 0));
  EXPECT_THAT(deck.element_sets.at(deck.sections[0].element_set).members, ElementsAre(2));
  EXPECT_EQ(deck.sections[1].first_axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_THAT(deck.element_sets.at(deck.sections[1].element_set).members, ElementsAre(1, 3));
}

TEST(AbaqusDeckYarns, AreNamedOneByOneWhereACourseHasSeveral) {
  model::Model model = climbing_yarn();
  model.yarns = {{0, 2}, {2, 2}};
  model.course.assign(4, 0);
  const AbaqusDeck deck = deck_of(deck_text(model));
  EXPECT_THAT(deck.element_sets.at("YARN_1").members, ElementsAre(1));
  EXPECT_THAT(deck.element_sets.at("YARN_2").members, ElementsAre(2));
}

TEST(AbaqusDeckYarns, HaveTheSectionTheModelGivesThem) {
  model::Model model = climbing_yarn();
  model.yarns = {{0, 2}, {2, 2}};
  model.element_section = {1, 1, 0, 0};
  model.course = {0, 0, 1, 1};
  model.sections.push_back(model.sections.front());
  model.sections.back().diameter = 0.2;
  const AbaqusDeck deck = deck_of(deck_text(model));
  ASSERT_EQ(deck.sections.size(), 2U);
  EXPECT_THAT(deck.element_sets.at(deck.sections[0].element_set).members, ElementsAre(2));
  EXPECT_THAT(deck.element_sets.at(deck.sections[1].element_set).members, ElementsAre(1));
  EXPECT_EQ(deck.contact->thickness.at("SECTION_2_SURFACE"), 0.2);
}

TEST(AbaqusDeckGrips, HaveToBeInTheModel) {
  model::Model model = climbing_yarn();
  model.node_sets.erase(model::kTopHeads);
  EXPECT_THROW(deck_text(model), std::invalid_argument);
}

}  // namespace
}  // namespace knitmech::exchange
