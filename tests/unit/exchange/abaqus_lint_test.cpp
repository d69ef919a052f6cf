#include "exchange/abaqus_lint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "deck_models.h"
#include "exchange/abaqus_syntax.h"

namespace knitmech::exchange {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<DeckFinding> findings_in(const std::string& deck) {
  std::istringstream in(deck);
  return lint_abaqus(in, "deck.inp");
}

std::string good_deck() {
  return deck_text(model::build_model(fabric_case(1, 1)), {.mass_scaling = 100});
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  if (place == std::string::npos) throw std::logic_error("the deck has no " + from);
  return text.replace(place, from.size(), to);
}

int line_of(const std::string& text, const std::string& part) {
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(part)), '\n'));
}

/// The one finding after a part of the good deck was replaced.
DeckFinding finding_after(const std::string& from, const std::string& to) {
  const auto findings = findings_in(replaced(good_deck(), from, to));
  EXPECT_EQ(findings.size(), 1U) << from << " -> " << to;
  for (const DeckFinding& each : findings) EXPECT_TRUE(each.is_error) << each.message;
  return findings.empty() ? DeckFinding{} : findings.front();
}

model::Case case_of(knit::Structure structure) {
  model::Case input = fabric_case(3, 4);
  input.fabric.structure = structure;
  return input;
}

TEST(AbaqusLint, GivenTheDeckOfEachStructure_ThenNothingIsFound) {
  for (const auto structure : {knit::Structure::basic, knit::Structure::tied, knit::Structure::adjusted}) {
    const auto findings = findings_in(deck_text(model::build_model(case_of(structure)), {.mass_scaling = 100}));
    for (const DeckFinding& each : findings) ADD_FAILURE() << each.line << ": " << each.message;
  }
}

TEST(AbaqusLint, GivenYarnsOfEachKind_ThenNothingIsFound) {
  model::Case curved = fabric_case(2, 2);
  curved.yarn.youngs_modulus.reset();
  curved.yarn.curve_strains = {0, 0.05, 0.2};
  curved.yarn.curve_forces = {0, 1, 5};
  model::Case with_edge_friction = case_of(knit::Structure::adjusted);
  with_edge_friction.contact.edge_friction = 0.3;
  for (const model::Case& input : {measured_yarn_case(), curved, with_edge_friction}) {
    const auto findings = findings_in(deck_text(model::build_model(input)));
    for (const DeckFinding& each : findings) ADD_FAILURE() << each.line << ": " << each.message;
  }
}

TEST(AbaqusLint, GivenAMisspeltKeyword_ThenTheNearestIsNamedWithTheLine) {
  const std::string deck = good_deck();
  const DeckFinding found = finding_after("*BULK VISCOSITY", "*BULK VISCOSTY");
  EXPECT_THAT(found.message, HasSubstr("BULKVISCOSITY"));
  EXPECT_EQ(found.line, line_of(deck, "*BULK VISCOSITY"));
}

TEST(AbaqusLint, GivenAnUnknownKeyword_ThenItIsANoteAndNoError) {
  const auto findings = findings_in(replaced(good_deck(), "*BULK VISCOSITY", "*PREPRINT, ECHO=NO\n*BULK VISCOSITY"));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_FALSE(findings.front().is_error) << findings.front().message;
}

TEST(AbaqusLint, GivenOptionsThatAreMissingUnknownOrWrong_ThenEachIsFound) {
  EXPECT_THAT(finding_after(", SECTION=CIRC", "").message, HasSubstr("needs the option SECTION"));
  EXPECT_THAT(finding_after("SECTION=CIRC", "SECTION=ROUND").message, HasSubstr("SECTION=ROUND is not possible"));
  EXPECT_THAT(finding_after("NLGEOM=YES", "NLGEOM=TRUE").message, HasSubstr("expected YES, NO"));
  EXPECT_THAT(finding_after("*NODE\n", "*NODE, COLOUR=RED\n").message, HasSubstr("no option COLOUR"));
  EXPECT_THAT(finding_after("*DYNAMIC, EXPLICIT", "*DYNAMIC").message, HasSubstr("needs the option EXPLICIT"));
}

TEST(AbaqusLint, GivenAGeneralSectionWithoutDensity_ThenItIsFound) {
  // Optional in Abaqus/Standard, required in Abaqus/Explicit.
  const std::string deck = deck_text(model::build_model(measured_yarn_case()));
  const auto place = deck.find(", DENSITY=");
  const auto findings = findings_in(std::string(deck).erase(place, deck.find_first_of(",\n", place + 2) - place));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings.front().message, HasSubstr("needs the option DENSITY"));
}

TEST(AbaqusLint, GivenDataLinesOfAnotherForm_ThenEachIsFound) {
  EXPECT_THAT(finding_after("*FRICTION\n0.1,\n", "*FRICTION\n").message, HasSubstr("ends before its data line 1"));
  EXPECT_THAT(finding_after("*FRICTION\n0.1,\n", "*FRICTION\nslippery\n").message, HasSubstr("not a number"));
  EXPECT_THAT(finding_after("0.06\n0., 0., 1.\n", "0.06\n0., 1.\n").message, HasSubstr("at least 3"));
  EXPECT_THAT(finding_after("0.06\n0., 0., 1.\n", "0.06, 0.05\n0., 0., 1.\n").message, HasSubstr("at most 1"));
  EXPECT_THAT(finding_after("*END STEP\n", "*END STEP\n1.\n").message, HasSubstr("no such data line"));
  EXPECT_THAT(finding_after("top_heads, 2, 2,", "top_heads, 2, 7,").message, HasSubstr("7 is no degree of freedom"));
  EXPECT_THAT(finding_after("U2, RF2", "U2, FORCE").message, HasSubstr("\"FORCE\""));
}

TEST(AbaqusLint, GivenAnElementWithTooFewNodes_ThenItIsFound) {
  EXPECT_THAT(finding_after("1, 1, 2\n2, 2, 3\n", "1, 1\n2, 2, 3\n").message, HasSubstr("2 to 3 nodes, not 1"));
}

TEST(AbaqusLint, GivenANameThatIsNotDefinedBefore_ThenItIsFound) {
  EXPECT_THAT(finding_after("MATERIAL=YARN_1,", "MATERIAL=WOOL,").message, HasSubstr("material \"WOOL\""));
  EXPECT_THAT(finding_after("NSET=top_heads\nU2", "NSET=tops\nU2").message, HasSubstr("node set \"TOPS\""));
  EXPECT_THAT(finding_after("AMPLITUDE=GRIP_VELOCITY\n", "AMPLITUDE=GRIP\n").message, HasSubstr("amplitude \"GRIP\""));
  EXPECT_THAT(finding_after("YARNS,\n", "YARN,\n").message, HasSubstr("element set \"YARN\""));
  EXPECT_THAT(finding_after(", YARN_ON_YARN", ", YARN_ON_STEEL").message, HasSubstr("interaction \"YARN_ON_STEEL\""));
}

TEST(AbaqusLint, GivenASetOfNoNodes_ThenItIsFoundAndItsUseToo) {
  const auto findings = findings_in(replaced(good_deck(), "*STEP", "*NSET, NSET=empty\n*BOUNDARY\nempty, 1, 1\n*STEP"));
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_THAT(findings[0].message, HasSubstr("ends before its data line 1"));
  EXPECT_THAT(findings[1].message, HasSubstr("node set \"EMPTY\""));
}

TEST(AbaqusLint, GivenAKeywordInTheWrongPlace_ThenItIsFound) {
  EXPECT_THAT(finding_after("*STEP", "*BULK VISCOSITY\n0.06\n*STEP").message, HasSubstr("belongs into a step"));
  EXPECT_THAT(finding_after("*END STEP", "*MATERIAL, NAME=X\n*END STEP").message, HasSubstr("not belong into a step"));
  EXPECT_THAT(finding_after("*STEP", "*DENSITY\n1.,\n*STEP").message, HasSubstr("belongs to a *MATERIAL"));
  EXPECT_THAT(finding_after("*END STEP\n", "").message, HasSubstr("*END STEP is missing"));
}

TEST(AbaqusLint, GivenANameDefinedTwice_ThenItIsFound) {
  EXPECT_THAT(finding_after("*STEP", "*MATERIAL, NAME=yarn_1\n*STEP").message, HasSubstr("a second time"));
}

TEST(AbaqusLint, GivenRightKeywordsButNumbersThatDoNotFit_ThenTheReaderFindsIt) {
  const auto findings = findings_in(replaced(good_deck(), "*STEP", "*NSET, NSET=n\n1\n*NODE\n1, 0., 0., 0.\n*STEP"));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings.front().message, HasSubstr("node 1"));
}

TEST(AbaqusLint, GivenNoDeckAtAll_ThenOneSentenceSaysSo) {
  for (const char* text : {"", "hello\n", "** only a comment\n", "*\n", "*NODE\n1,,,,\n\n,,\n"}) {
    EXPECT_THAT(findings_in(text), testing::Not(IsEmpty())) << text;
  }
}

/// Each keyword that the writer knows, so that a new one needs its rule.
TEST(AbaqusLint, GivenADeckCutAtAnyLine_ThenItIsAnErrorOrALackOfTheEnd) {
  const std::vector<std::string> lines = lines_of(good_deck());
  std::string deck;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    deck += lines[i] + "\n";
    const auto findings = findings_in(deck);
    EXPECT_THAT(findings, testing::Contains(testing::Field(&DeckFinding::is_error, true))) << i;
  }
}

}  // namespace
}  // namespace knitmech::exchange
