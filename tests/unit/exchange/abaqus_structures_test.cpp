// Decks of fabrics with tied or joined edges: equations, sections by element, friction by pairs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/errors.h"
#include "deck_models.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

model::Case case_of(knit::Structure structure, int elements_per_erc = 10) {
  model::Case input = fabric_case(4, 3);
  input.fabric.structure = structure;
  input.fabric.elements_per_erc = elements_per_erc;
  return input;
}

struct RoundTrip {
  explicit RoundTrip(const model::Case& input)
      : model(model::build_model(input)), text(deck_text(model)), deck(deck_of(text)) {}
  model::Model model;
  std::string text;
  AbaqusDeck deck;
};

class TiedDeck : public testing::TestWithParam<int> {
 protected:
  const RoundTrip trip_{case_of(knit::Structure::tied, GetParam())};
};
INSTANTIATE_TEST_SUITE_P(Meshes, TiedDeck, testing::Values(10, 20, 33));

TEST_P(TiedDeck, HasThreeEquationsForEveryTieOneForEachDirection) {
  ASSERT_EQ(trip_.model.ties.size(), 16U);
  ASSERT_EQ(trip_.deck.equations.size(), 48U);
  for (std::size_t i = 0; i < 48; ++i) {
    for (const AbaqusDeck::Equation::Term& term : trip_.deck.equations[i].terms) {
      EXPECT_EQ(term.dof, static_cast<int>(i % 3) + 1) << "equation " << i;
    }
  }
  EXPECT_TRUE(trip_.deck.unread.empty());
}

TEST_P(TiedDeck, HasEquationsThatAnyTranslationSatisfies) {
  for (const AbaqusDeck::Equation& equation : trip_.deck.equations) {
    double sum = 0;
    for (const AbaqusDeck::Equation::Term& term : equation.terms) sum += term.coefficient;
    EXPECT_NEAR(sum, 0, 1e-15) << "line " << equation.line;
  }
}

TEST_P(TiedDeck, HasEquationsThatKeepTheTiedPlacesOfTheElementsTogether) {
  // Given any displacements of the nodes, then the left side of an equation is the displacement of the first place of
  // its tie, linear on the element, less that of the second.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Vector3d> displacement;
  for (std::size_t i = 0; i < trip_.model.nodes.size(); ++i) {
    displacement.emplace_back(uniform(random), uniform(random), uniform(random));
  }
  const auto at = [&](model::ElementPlace place) {
    const auto i = static_cast<std::size_t>(place.element);
    return Vector3d((1 - place.share) * displacement[i] + place.share * displacement[i + 1]);
  };
  for (std::size_t i = 0; i < trip_.deck.equations.size(); ++i) {
    const model::Tie& tie = trip_.model.ties[i / 3];
    double left = 0;
    for (const AbaqusDeck::Equation::Term& term : trip_.deck.equations[i].terms) {
      left += term.coefficient * displacement[std::stoul(term.nodes) - 1][term.dof - 1];
    }
    EXPECT_NEAR(left, (at(tie.first) - at(tie.second))[static_cast<Eigen::Index>(i % 3)], 1e-14) << i;
  }
}

TEST_P(TiedDeck, HasEquationsThatEliminateEachANodeOfItsOwnWhichNoGripHolds) {
  // Abaqus eliminates the first displacement of an equation, so it must not be held, and no other may eliminate it.
  std::set<std::pair<std::string, int>> eliminated;
  std::set<int> held;
  for (const char* grip : {"BOTTOM_FEET", "TOP_HEADS"}) {
    const auto& members = trip_.deck.node_sets.at(grip).members;
    held.insert(members.begin(), members.end());
  }
  for (const AbaqusDeck::Equation& equation : trip_.deck.equations) {
    const AbaqusDeck::Equation::Term& first = equation.terms.front();
    EXPECT_TRUE(eliminated.insert({first.nodes, first.dof}).second) << "line " << equation.line;
    EXPECT_FALSE(held.contains(std::stoi(first.nodes))) << "line " << equation.line;
    EXPECT_GT(std::abs(first.coefficient), 1e-3) << "line " << equation.line;
  }
}

TEST_P(TiedDeck, HasEquationsOfWhichNoneUsesWhatAnotherEliminates) {
  // So they can be imposed in any order.
  std::set<std::pair<std::string, int>> eliminated;
  for (const auto& equation : trip_.deck.equations) {
    eliminated.insert({equation.terms.front().nodes, equation.terms.front().dof});
  }
  for (const auto& equation : trip_.deck.equations) {
    for (std::size_t i = 1; i < equation.terms.size(); ++i) {
      EXPECT_FALSE(eliminated.contains({equation.terms[i].nodes, equation.terms[i].dof})) << "line " << equation.line;
    }
  }
}

TEST(TiedDeckText, HasTheEquationsAsTheKeywordGuideAsksFor) {
  // The number of terms; then node, degree of freedom, coefficient, at most four terms to a line.
  const RoundTrip trip(case_of(knit::Structure::tied));
  const std::vector<std::string> lines = lines_of(trip.text);
  const auto keyword = std::find(lines.begin(), lines.end(), "*EQUATION");
  ASSERT_NE(keyword, lines.end());
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "*EQUATION"), 1);
  EXPECT_EQ(keyword[1], "4");
  EXPECT_EQ(std::count(keyword[2].begin(), keyword[2].end(), ','), 11);
}

TEST(TiedDeckText, HasTheSectionAndContactOfTheBasicFabric) {
  const RoundTrip tied(case_of(knit::Structure::tied));
  const RoundTrip basic(case_of(knit::Structure::basic));
  EXPECT_THAT(basic.deck.equations, IsEmpty());
  EXPECT_EQ(tied.deck.sections.size(), basic.deck.sections.size());
  EXPECT_EQ(tied.deck.contact->properties.size(), 1U);
}

/// A deck of two elements with equations of the test's own.
std::string deck_with_equations(const std::string& equations) {
  const std::string text =
      "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 2., 0., 0.\n*NSET, NSET=END\n3\n*ELEMENT, TYPE=B31, ELSET=Y\n1, 1, "
      "2\n2, 2, 3\n"
      "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*BEAM SECTION, ELSET=Y, MATERIAL=M, SECTION=CIRC\n0.1\n0., 0., "
      "1.\n*EQUATION\n";
  return text + equations;
}

TEST(EquationReader, GivenSeveralEquationsOverSeveralLines_ThenAllTermsAreRead) {
  const AbaqusDeck deck =
      deck_of(deck_with_equations("2\n1, 2, 1., END, 2, -1.\n3\n1, 1, 1., 2, 1, -0.5,\n3, 1, -0.5\n"));
  ASSERT_EQ(deck.equations.size(), 2U);
  EXPECT_EQ(deck.equations[0].terms[1].nodes, "END");
  EXPECT_EQ(deck.equations[0].terms[1].dof, 2);
  EXPECT_EQ(deck.equations[0].terms[1].coefficient, -1);
  ASSERT_EQ(deck.equations[1].terms.size(), 3U);
  EXPECT_EQ(deck.equations[1].terms[2].nodes, "3");
  EXPECT_EQ(deck.equations[1].terms[2].coefficient, -0.5);
}

TEST(EquationReader, GivenAWrongEquation_ThenItIsRefusedWithItsLine) {
  const auto reading = [](const std::string& equations) {
    return [equations] { (void)deck_of(deck_with_equations(equations)); };
  };
  EXPECT_THAT(reading("0\n"), ThrowsMessage<InputError>(HasSubstr("line 17: an equation has 1 term or more, not 0")));
  EXPECT_THAT(reading("1\n1, 1, 1., 2, 1, -1.\n"),
              ThrowsMessage<InputError>(HasSubstr("line 17: the equation has 2 terms, but announces 1")));
  EXPECT_THAT(reading("2\n1, 1, 1., 9, 1, -1.\n"),
              ThrowsMessage<InputError>(HasSubstr("line 17: the node 9 does not exist")));
  EXPECT_THAT(reading("2\n1, 1, 1., TOP, 1, -1.\n"),
              ThrowsMessage<InputError>(HasSubstr("line 17: the node set \"TOP\" does not exist")));
  EXPECT_THAT(reading("2\n1, 1\n"), ThrowsMessage<InputError>(HasSubstr("line 18: a term of an equation is")));
}

class AdjustedDeck : public testing::Test {
 protected:
  static model::Case input() {
    model::Case input = case_of(knit::Structure::adjusted);
    input.contact.edge_friction = 0.3;
    return input;
  }
  const RoundTrip trip_{input()};

  /// Elements by number of which an end lies on a turning arc.
  [[nodiscard]] std::vector<int> elements_of_arcs() const {
    std::vector<int> numbers;
    for (int i = 0; i < trip_.model.n_elements(); ++i) {
      const auto node = static_cast<std::size_t>(i);
      if (trip_.model.wale[node] == knit::kNoWale || trip_.model.wale[node + 1] == knit::kNoWale)
        numbers.push_back(i + 1);
    }
    return numbers;
  }
};

TEST_F(AdjustedDeck, HasOneYarnAndTheArcsInTheSetOfTheEdgeSection) {
  const auto& sets = trip_.deck.element_sets;
  EXPECT_EQ(sets.at("YARN_1").members.size(), trip_.deck.elements.size());
  EXPECT_EQ(sets.at("SECTION_2").members, elements_of_arcs());
  EXPECT_EQ(sets.at("SECTION_1").members.size() + sets.at("SECTION_2").members.size(), trip_.deck.elements.size());
  EXPECT_EQ(sets.at("YARNS").members.size(), trip_.deck.elements.size());
  EXPECT_THAT(lines_of(trip_.text), testing::Contains(HasSubstr("** 1 yarn, ")));
}

TEST_F(AdjustedDeck, HasTheYarnAsACircleAndTheEdgeYarnAsAGeneralSectionWithItsStiffnesses) {
  ASSERT_EQ(trip_.deck.sections.size(), 2U);
  const AbaqusDeck::Section& yarn = trip_.deck.sections[0];
  const AbaqusDeck::Section& edge = trip_.deck.sections[1];
  EXPECT_EQ(yarn.kind, AbaqusDeck::SectionKind::beam);
  EXPECT_EQ(yarn.element_set, "SECTION_1");
  ASSERT_EQ(edge.kind, AbaqusDeck::SectionKind::general_beam);
  EXPECT_EQ(edge.element_set, "SECTION_2");
  const yarn::Section& expected = trip_.model.sections[1];
  const auto expect_share = [](double found, double value) { EXPECT_NEAR(found, value, 1e-11 * value); };
  expect_share(edge.moduli.at(0) * edge.dimensions.at(0), expected.axial_stiffness);
  expect_share(edge.moduli.at(0) * edge.dimensions.at(1), 5e-6);
  expect_share(edge.moduli.at(1) * edge.dimensions.at(4), expected.torsional_stiffness);
  expect_share(edge.density * edge.dimensions.at(0), expected.mass_per_length);
}

TEST_F(AdjustedDeck, GivesTheEdgeYarnTheShearStiffnessThatItsElementsHaveHere) {
  // Abaqus: K / (1 + c L^2 A / (12 I)) with A / I of the section; here EA / EI is held at 16 / D^2, that of a circle.
  const AbaqusDeck::Section& edge = trip_.deck.sections.at(1);
  const double slenderness = edge.dimensions.at(0) / edge.dimensions.at(1);
  EXPECT_NEAR(edge.transverse_shear.at(2) * slenderness, 0.25 * 16 / (0.12 * 0.12), 1e-9 * 278);
  EXPECT_EQ(trip_.deck.sections[0].transverse_shear.at(2), 0.25);
}

TEST_F(AdjustedDeck, HasTheFrictionOfEveryPairOfYarns) {
  std::map<std::pair<std::string, std::string>, double> friction;  // by element sets
  for (const AbaqusDeck::Contact::Property& property : trip_.deck.contact->properties) {
    const auto set_of = [&](const std::string& surface) { return trip_.deck.surfaces.at(surface).sets.at(0); };
    friction[{set_of(property.surface_a), set_of(property.surface_b)}] =
        trip_.deck.interactions.at(property.interaction).friction;
  }
  const std::map<std::pair<std::string, std::string>, double> expected = {
      {{"YARNS", "YARNS"}, 0.1}, {{"SECTION_1", "SECTION_2"}, 0.3}, {{"SECTION_2", "SECTION_2"}, 0.3}};
  EXPECT_EQ(friction, expected);
}

TEST_F(AdjustedDeck, HasThePairsAfterThatOfAllYarnsWhichTheyOverrule) {
  // The last assignment of a pair of surfaces counts in Abaqus.
  const auto& properties = trip_.deck.contact->properties;
  ASSERT_EQ(properties.size(), 3U);
  EXPECT_EQ(trip_.deck.surfaces.at(properties.front().surface_a).sets.at(0), "YARNS");
}

TEST_F(AdjustedDeck, HasNoNodeOfAnArcInAGripAndNoEquations) {
  for (const char* grip : {"BOTTOM_FEET", "TOP_HEADS"}) {
    for (const int node : trip_.deck.node_sets.at(grip).members) {
      EXPECT_NE(trip_.model.wale[static_cast<std::size_t>(node) - 1], knit::kNoWale) << grip;
    }
  }
  EXPECT_THAT(trip_.deck.equations, IsEmpty());
}

TEST_F(AdjustedDeck, IsReadWithoutALeftoverAndTheSameEveryTime) {
  EXPECT_TRUE(trip_.deck.unread.empty());
  EXPECT_EQ(deck_text(trip_.model), trip_.text);
  for (const std::string& line : lines_of(trip_.text)) ASSERT_LE(line.size(), 256U) << line;
}

}  // namespace
}  // namespace knitmech::exchange
