// The LS-DYNA deck of every structure, read back and compared with the model number by number.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "deck_models.h"
#include "exchange/lsdyna_reader.h"
#include "exchange/lsdyna_writer.h"

namespace knitmech::exchange {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

constexpr double kMassScaling = 1e4;
constexpr LsDynaOptions kOptions{.mass_scaling = kMassScaling, .history_points = 200, .pictures = 20};

/// A field of ten characters holds six digits at least.
constexpr double kTenCharacters = 5e-6;

std::string lsdyna_text(const model::Model& model) {
  std::ostringstream out;
  write_lsdyna(out, model, kOptions);
  return out.str();
}

LsDynaDeck lsdyna_of(const std::string& text) {
  std::istringstream in(text);
  return read_lsdyna(in, "jersey.k");
}

struct Deck {
  explicit Deck(const model::Case& input)
      : model(model::build_model(input)), text(lsdyna_text(model)), read(lsdyna_of(text)) {}
  model::Model model;
  std::string text;
  LsDynaDeck read;
};

class LsDynaStructures : public testing::TestWithParam<knit::Structure> {
 protected:
  const Deck deck_{structure_case(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(All, LsDynaStructures,
                         testing::Values(knit::Structure::basic, knit::Structure::tied, knit::Structure::adjusted));

TEST_P(LsDynaStructures, IsReadWithoutALeftoverAndHoldsTogether) {
  EXPECT_THAT(deck_.read.unread, IsEmpty());
  EXPECT_NO_THROW(check_lsdyna(deck_.read, "jersey.k"));
}

TEST_P(LsDynaStructures, HasTheNodesOfTheModelAndOneOfOrientation) {
  ASSERT_EQ(deck_.read.nodes.size(), deck_.model.nodes.size() + 1);
  for (std::size_t i = 0; i < deck_.model.nodes.size(); ++i) {
    // 16 columns, one of them blank.
    ASSERT_LT((deck_.read.nodes.at(static_cast<int>(i) + 1) - deck_.model.nodes[i]).norm(), 1e-11) << "node " << i + 1;
  }
  EXPECT_THAT(deck_.read.groups.at(3).members, ElementsAre(deck_.model.n_nodes() + 1));
}

TEST_P(LsDynaStructures, HasTheElementsAlongTheYarnsEachInThePartOfItsSection) {
  int number = 0;
  for (const model::ModelYarn& yarn : deck_.model.yarns) {
    for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes - 1; ++i) {
      const LsDynaDeck::Beam& beam = deck_.read.beams.at(++number);
      EXPECT_THAT(beam.nodes, ElementsAre(i + 1, i + 2, deck_.model.n_nodes() + 1));
      EXPECT_EQ(beam.part, deck_.model.element_section[static_cast<std::size_t>(i)] + 1);
    }
  }
  EXPECT_THAT(deck_.read.beams, SizeIs(static_cast<std::size_t>(deck_.model.n_elements())));
}

TEST_P(LsDynaStructures, HasTheStiffnessesAndTheScaledMassOfEverySection) {
  for (const auto& [number, part] : deck_.read.parts) {
    const yarn::Section& expected = deck_.model.sections.at(static_cast<std::size_t>(number) - 1);
    const LsDynaDeck::Section& section = deck_.read.sections.at(part.section);
    const LsDynaDeck::Material& material = deck_.read.materials.at(part.material);
    const auto expect = [](double found, double value) { EXPECT_NEAR(found, value, 2 * kTenCharacters * value); };
    const double shear_modulus = material.youngs_modulus / (2 * (1 + material.poissons_ratio));
    EXPECT_EQ(section.formulation, 2);
    expect(material.youngs_modulus * section.area, expected.axial_stiffness);
    expect(material.youngs_modulus * section.inertia_s, expected.bending_stiffness);
    expect(material.youngs_modulus * section.inertia_t, expected.bending_stiffness);
    expect(shear_modulus * section.torsion_constant, expected.torsional_stiffness);
    expect(shear_modulus * section.shear_area, expected.shear_stiffness);
    expect(section.area, std::numbers::pi * expected.diameter * expected.diameter / 4);
    expect(material.density * section.area, kMassScaling * expected.mass_per_length);
  }
}

TEST_P(LsDynaStructures, HoldsTheFeetAndTheHeadsAcrossThePull) {
  const auto numbers = [&](const char* set) {
    std::vector<int> nodes = deck_.model.node_sets.at(set);
    for (int& node : nodes) ++node;
    return nodes;
  };
  EXPECT_EQ(deck_.read.groups.at(1).members, numbers("bottom_feet"));
  EXPECT_EQ(deck_.read.groups.at(2).members, numbers("top_heads"));
  ASSERT_THAT(deck_.read.held, SizeIs(3));
  EXPECT_EQ(deck_.read.held[0].group, 1);
  EXPECT_THAT(deck_.read.held[0].directions, Each(true));
  EXPECT_EQ(deck_.read.held[1].group, 2);
  EXPECT_THAT(deck_.read.held[1].directions, ElementsAre(true, false, true, true, true, true));
  EXPECT_EQ(deck_.read.held[2].group, 3);
  EXPECT_THAT(deck_.read.held[2].directions, Each(true));
}

TEST_P(LsDynaStructures, DrivesTheHeadsWithTheVelocityOfTheTest) {
  ASSERT_THAT(deck_.read.motions, SizeIs(1));
  const LsDynaDeck::Motion& motion = deck_.read.motions[0];
  EXPECT_EQ(motion.group, 2);
  EXPECT_EQ(motion.direction, 2);
  EXPECT_EQ(motion.kind, 0);
  const model::TensileTest& test = deck_.model.test;
  for (const double time : {0.0, 0.1, 0.25, 0.5, 0.6, test.time_at(test.strain)}) {
    EXPECT_NEAR(motion.scale * deck_.read.curves.at(motion.curve).value(time), test.velocity(time), 1e-12) << time;
  }
}

TEST_P(LsDynaStructures, HasTheContactOfAllYarnsWithTheStiffnessOfACrossingInOpenRadioss) {
  ASSERT_THAT(deck_.read.contacts, SizeIs(1));
  const LsDynaDeck::Contact& contact = deck_.read.contacts[0];
  EXPECT_EQ(contact.soft, -11);  // /INTER/TYPE11
  EXPECT_EQ(contact.thickness, 0.12);
  // Mean stiffness of two lines, SFS sqrt(A) E, and half of that (OpenRadioss, i11sti3.F, i11cor3.F and i11for3.F).
  const double area = std::numbers::pi * 0.12 * 0.12 / 4;
  const double stiffness = contact.stiffness_scale * std::sqrt(area) * 1700 / 2;
  EXPECT_NEAR(stiffness, deck_.model.contact_stiffness, kTenCharacters * stiffness);
  EXPECT_EQ(deck_.read.part_groups.at(contact.group).members.size(), deck_.read.parts.size());
  EXPECT_EQ(contact.friction, -2);
  EXPECT_EQ(deck_.read.frictions.at(contact.friction_table).of_all, deck_.model.friction);
}

TEST_P(LsDynaStructures, RunsAsLongAsTheTestAndWritesAsOftenAsAsked) {
  const double duration = deck_.model.test.time_at(0.22);
  EXPECT_NEAR(deck_.read.end_time, duration, kTenCharacters * duration);
  EXPECT_NEAR(deck_.read.intervals.at("GLSTAT"), duration / 200, kTenCharacters * duration);
  EXPECT_NEAR(deck_.read.intervals.at("BNDOUT"), duration / 200, kTenCharacters * duration);
  EXPECT_NEAR(deck_.read.intervals.at("SPCFORC"), duration / 200, kTenCharacters * duration);
  EXPECT_NEAR(deck_.read.intervals.at("BINARY_D3PLOT"), duration / 20, kTenCharacters * duration);
  EXPECT_THAT(deck_.read.history_groups, ElementsAre(1, 2));
  EXPECT_EQ(deck_.read.step_share, 0.8);
  EXPECT_THAT(deck_.read.units, ElementsAre("mm", "sec", "mtrc_ton"));
}

TEST_P(LsDynaStructures, IsTheSameEveryTimeAndNoLineOfDataIsLongerThanEightyColumns) {
  EXPECT_EQ(lsdyna_text(deck_.model), deck_.text);
  for (const std::string& line : lines_of(deck_.text)) {
    if (line.starts_with('$')) continue;
    ASSERT_LE(line.size(), 80U) << line;
  }
}

TEST(LsDynaTies, KeepTheTiedPlacesOfTheElementsTogetherInEachDirection) {
  const Deck deck(structure_case(knit::Structure::tied));
  expect_constraints_of_ties(deck.model, deck.read.constraints, 4 * kTenCharacters);
}

TEST(LsDynaHead, SaysWhatOpenRadiossDoesNotMakeOfTheDeck) {
  EXPECT_THAT(lines_of(Deck(structure_case(knit::Structure::tied)).text),
              Contains("$ OpenRadioss does not read the ties of this deck; its native deck has that."));
  model::Case input = structure_case(knit::Structure::adjusted);
  input.edge_yarn.diameter = 0.08;
  const std::vector<std::string> lines = lines_of(Deck(input).text);
  EXPECT_THAT(lines, Contains(HasSubstr("OpenRadioss does not take the friction of pairs of yarns")));
  EXPECT_THAT(lines, Contains(HasSubstr("OpenRadioss takes all yarns of this deck for as thick")));
  EXPECT_THAT(Deck(structure_case(knit::Structure::basic)).text, testing::Not(HasSubstr("its native deck")));
}

TEST(LsDynaFriction, GivenAnotherOneOfTheEdgeYarn_ThenItIsThatOfItsPairs) {
  const Deck deck(structure_case(knit::Structure::adjusted));
  const std::map<std::pair<int, int>, double> expected = {{{1, 2}, 0.3}, {{2, 2}, 0.3}};
  EXPECT_EQ(deck.read.frictions.at(1).of_pairs, expected);
}

TEST(LsDynaGrips, GivenSlidingOnes_ThenTheHeadsAreFreeAcrossThePull) {
  model::Case input = fabric_case(2, 2);
  input.test.grips = model::Grips::sliding;
  EXPECT_THAT(Deck(input).read.held.at(1).directions, ElementsAre(false, false, false, true, true, true));
}

TEST(LsDynaStrength, GivenAYarnThatBreaks_ThenTheHeadSaysThatHereItDoesNot) {
  model::Case input = fabric_case(2, 2);
  input.yarn.strength = 4.5;
  EXPECT_THAT(lines_of(Deck(input).text), Contains(HasSubstr("breaks at 4.5 N; here it does not")));
}

TEST(LsDynaCurve, GivenAMeasuredTensileCurve_ThenItIsRefused) {
  model::Case input = fabric_case(2, 2);
  input.yarn.youngs_modulus.reset();
  input.yarn.curve_strains = {0, 0.1, 0.2};
  input.yarn.curve_forces = {0, 1.0, 3.0};
  EXPECT_THAT([&] { Deck deck(input); },
              ThrowsMessage<InputError>(HasSubstr("the elastic beam of LS-DYNA has no measured tensile curve")));
}

TEST(LsDynaOrientation, GivenAnElementAlongTheFirstAxis_ThenItHasANodeOfItsOwn) {
  model::Model model = model::build_model(fabric_case(2, 2));
  model.nodes[1] = model.nodes[0] + Eigen::Vector3d(0, 0, 0.5);
  const LsDynaDeck deck = lsdyna_of(lsdyna_text(model));
  ASSERT_EQ(deck.nodes.size(), model.nodes.size() + 2);
  const LsDynaDeck::Beam& beam = deck.beams.at(1);
  const Eigen::Vector3d along = (deck.nodes.at(beam.nodes[1]) - deck.nodes.at(beam.nodes[0])).normalized();
  const Eigen::Vector3d away = (deck.nodes.at(beam.nodes[2]) - deck.nodes.at(beam.nodes[0])).normalized();
  EXPECT_LT(std::abs(along.dot(away)), 0.2);
  EXPECT_NE(beam.nodes[2], deck.beams.at(2).nodes[2]);
}

TEST(LsDynaModel, GivenNoNodesInAGrip_ThenItIsRefused) {
  model::Model model = model::build_model(fabric_case(2, 2));
  model.node_sets["top_heads"].clear();
  EXPECT_THROW((void)lsdyna_text(model), std::invalid_argument);
}

struct Defect {
  const char* was;  ///< its first occurrence
  const char* is;
  const char* message;
};

class LsDynaDefects : public testing::TestWithParam<Defect> {};

TEST_P(LsDynaDefects, AreFound) {
  model::Case input = fabric_case(3, 2);
  input.fabric.structure = knit::Structure::tied;
  std::string text = lsdyna_text(model::build_model(input));
  const auto at = text.find(GetParam().was);
  ASSERT_NE(at, std::string::npos) << GetParam().was;
  text.replace(at, std::string(GetParam().was).size(), GetParam().is);
  EXPECT_THAT([&] { check_lsdyna(lsdyna_of(text), "deck.k"); },
              ThrowsMessage<InputError>(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    Deck, LsDynaDefects,
    testing::Values(
        // Columns
        Defect{"       1       1       1       2     ", "       1       1        1      2     ",
               "\"1      2\" is not a whole number"},
        Defect{"         1   1.14e-5      1700", "         1    1.14e-5     1700", "\"1.14e-\" is not a number"},
        Defect{"         1         1         1         1         1\n",
               "         1         1         1         1         11\n", "behind column 80"},
        // Cards that are missing or too many
        Defect{"         1         2\n$        A", "$        A", "*SECTION_BEAM has 1 lines here and needs 2"},
        Defect{"$     SOFT\n       -11\n", "", "*CONTACT_AUTOMATIC_GENERAL_ID has 4 lines here and needs 5"},
        Defect{"*END", "*TITLE\nend", "does not end with *END"},
        Defect{"*KEYWORD", "*TITLE\nbegin", "does not begin with *KEYWORD"},
        Defect{"        10\n         1\n", "        10\n", "the group 10 is empty"},
        // What is not there, or twice
        Defect{"         1         1         1\n*SECTION", "         1         2         1\n*SECTION",
               "the section 2 does not exist"},
        Defect{"         1         1         1\n*SECTION", "         1         1         2\n*SECTION",
               "the material 2 does not exist"},
        Defect{"       1       1       1       2     ", "       1       1       1     999     ",
               "the node 999 does not"},
        Defect{"       1       1       1       2     ", "       1       1       2       2     ", "has a node twice"},
        Defect{"       2       1       2       3     ", "       1       1       2       3     ", "a second time"},
        Defect{"        10         0         2         0", "        11         0         2         0",
               "the part set 11 does not exist"},
        Defect{"        -2         1\n", "        -2         3\n", "the friction 3 does not exist"},
        Defect{"         2         2         0         1         5",
               "         2         2         0         4         5", "the curve 4 does not exist"},
        // Mechanics
        Defect{"         2         0         1         0         1",
               "         2         0         1         1         1", "is driven along 2 and held"},
        Defect{"         2         2         0         1         5",
               "         2         2         2         1         5", "a grip moves with a velocity"},
        Defect{"         1         2\n$        A", "         1         1\n$        A", "ELFORM 1 has other cards"}));

TEST(LsDynaReader, ListsKeywordsThatItDoesNotKnow) {
  std::string text = lsdyna_text(model::build_model(fabric_case(2, 2)));
  text.insert(text.find("*END"), "*DAMPING_GLOBAL\n         0       1.0\n");
  const LsDynaDeck deck = lsdyna_of(text);
  ASSERT_THAT(deck.unread, SizeIs(1));
  EXPECT_EQ(deck.unread[0].keyword, "*DAMPING_GLOBAL");
}

}  // namespace
}  // namespace knitmech::exchange
