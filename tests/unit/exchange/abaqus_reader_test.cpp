#include "exchange/abaqus_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.h"
#include "deck_models.h"

namespace knitmech::exchange {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two beams by another hand: other case, blanks, order of options, comments, continued lines, GENERATE, D exponents.
constexpr const char* kForeignDeck = R"(** by hand
*Heading
 Two beams
*node , nset = All
1, 0., 0., 0.
** a comment between nodes
2, 1.D0, 0, 0

3, +2., 0.,
*Element, elset=yarn,
 type = b31
1, 1, 2
2, 2,
3
*NSET, GENERATE, NSET=ends
1, 3, 2
*elset, elset="Everything"
yarn
*Beam Section, section=circ,
  material=nylon, elset=yarn
0.06
0., 1., 0.
*Material, name=Nylon
*Elastic
1700., 0.39
*Density
1.14e-9,
*Damping, alpha=3.
*Amplitude, name=pull
0., 0., 1., 1.,
2., 0.5
*Boundary
1, encastre
ends, 3
*step, nlgeom
*dynamic, explicit
, 2.
*boundary, amplitude=PULL, type=velocity
3, 2, 2, 5.
*end step
)";

TEST(AbaqusReader, ReadsADeckByAnotherHand) {
  const AbaqusDeck deck = deck_of(kForeignDeck);
  EXPECT_THAT(deck.heading, ElementsAre("Two beams"));
  EXPECT_EQ(deck.nodes.at(2), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(deck.nodes.at(3), Eigen::Vector3d(2, 0, 0));
  EXPECT_THAT(deck.elements.at(2).nodes, ElementsAre(2, 3));
  EXPECT_THAT(deck.node_sets.at("ALL").members, ElementsAre(1, 2, 3));
  EXPECT_THAT(deck.node_sets.at("ENDS").members, ElementsAre(1, 3));
  EXPECT_THAT(deck.element_sets.at("Everything").members, ElementsAre(1, 2));
}

TEST(AbaqusReader, ReadsSectionMaterialAndStepInAnyOrderOfOptions) {
  const AbaqusDeck deck = deck_of(kForeignDeck);
  ASSERT_EQ(deck.sections.size(), 1U);
  EXPECT_EQ(deck.sections[0].shape, "CIRC");
  EXPECT_EQ(deck.sections[0].first_axis, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(deck.sections[0].rotary_inertia, "EXACT");
  EXPECT_EQ(deck.materials.at("NYLON").youngs_modulus, 1700);
  EXPECT_EQ(deck.materials.at("NYLON").density, 1.14e-9);
  ASSERT_EQ(deck.steps.size(), 1U);
  EXPECT_TRUE(deck.steps[0].large_displacements);
  EXPECT_EQ(deck.steps[0].duration, 2);
  EXPECT_EQ(deck.boundaries.at(0).last_dof, 6);
  EXPECT_EQ(deck.boundaries.at(1).last_dof, 3);
  EXPECT_EQ(deck.steps[0].boundaries.at(0).amplitude, "PULL");
}

TEST(AbaqusReader, ReadsAmplitudesAsLinesBetweenTheirPoints) {
  const AbaqusDeck deck = deck_of(kForeignDeck);
  const AbaqusDeck::Amplitude& amplitude = deck.amplitudes.at("PULL");
  EXPECT_DOUBLE_EQ(amplitude.value(-1), 0);
  EXPECT_DOUBLE_EQ(amplitude.value(0.5), 0.5);
  EXPECT_DOUBLE_EQ(amplitude.value(1.5), 0.75);
  EXPECT_DOUBLE_EQ(amplitude.value(9), 0.5);
}

TEST(AbaqusReader, ListsTheKeywordsItPassesOver) {
  const AbaqusDeck deck = deck_of(kForeignDeck);
  ASSERT_EQ(deck.unread.size(), 1U);
  EXPECT_EQ(deck.unread[0].keyword, "*Damping");
  EXPECT_EQ(deck.unread[0].line, 28);
}

std::string complaint(const std::string& text) {
  try {
    (void)deck_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

struct Damage {
  const char* name;
  const char* part;         ///< of kForeignDeck
  const char* replacement;  ///< what stands there instead
  const char* message;      ///< all of it
};

class AbaqusReaderOfDamagedDeck : public testing::TestWithParam<Damage> {};

TEST_P(AbaqusReaderOfDamagedDeck, SaysWhatIsWrongAndInWhichLine) {
  std::string text = kForeignDeck;
  const auto at = text.find(GetParam().part);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(GetParam().part).size(), GetParam().replacement);
  EXPECT_EQ(complaint(text), std::string("deck.inp, ") + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Damages, AbaqusReaderOfDamagedDeck,
    testing::Values(
        Damage{"Coordinate", "2, 1.D0, 0, 0", "2, one, 0, 0", "line 7: \"ONE\" is not a number"},
        Damage{"LongNumber", "1.D0", "1.00000000000000000000",
               "line 7: the number \"1.00000000000000000000\" has more than 20 characters"},
        Damage{"NotFinite", "1.D0", "inf", "line 7: \"INF\" is not a number"},
        Damage{"NodeNumber", "2, 1.D0", "2.5, 1.D0", "line 7: \"2.5\" is not a whole number"},
        Damage{"NodeTwice", "2, 1.D0", "1, 1.D0", "line 7: node 1 is defined a second time"},
        Damage{"NodeWithoutCoordinates", "2, 1.D0, 0, 0", "2", "line 7: node 2 needs a number and three coordinates"},
        Damage{"NodeOfElement", "1, 1, 2\n", "1, 1, 7\n", "line 12: element 1 has the node 7, which does not exist"},
        Damage{"ElementTwice", "2, 2,\n3", "1, 2, 3", "line 13: element 1 is defined a second time"},
        Damage{"ElementTooLong", "1, 1, 2\n", "1, 1, 2, 3\n",
               "line 12: an element of type B31 has a number and 2 nodes, not 4 entries"},
        Damage{"ElementType", "b31", "C3D8", "line 10: elements of type C3D8 cannot be read; B31 can"},
        Damage{"OptionMissing", "*NSET, GENERATE, NSET=ends", "*NSET, GENERATE", "line 15: *NSET needs NSET=..."},
        Damage{"Generate", "1, 3, 2\n*elset", "3, 1, 2\n*elset",
               "line 16: GENERATE needs first, last, increment, with first <= last and a positive increment"},
        Damage{"SetWithUnknownNode", "1, 3, 2\n*elset", "1, 5, 2\n*elset",
               "line 15: the set ENDS has the node 5, which does not exist"},
        Damage{"UnknownSetInSet", "\nyarn\n", "\nother\n",
               "line 18: the set \"OTHER\" is not defined before it is used"},
        Damage{"TooManyInALine", "\nyarn\n", "\n1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n",
               "line 18: more than 16 entries on a line of a set"},
        Damage{"SectionSet", "elset=yarn\n0.06", "elset=nothing\n0.06",
               "line 19: the element set \"NOTHING\" does not exist"},
        Damage{"SectionMissing", "0.06\n0., 1., 0.\n", "", "line 19: *Beam Section ends before its data line 1"},
        Damage{"Radius", "\n0.06\n", "\n-0.06\n", "line 21: the radius of a CIRC section must be positive"},
        Damage{"FirstAxis", "0., 1., 0.", "0., 0., 0.", "line 22: the direction of the first axis is zero"},
        Damage{"Material", "material=nylon", "material=steel", "line 19: the material \"STEEL\" does not exist"},
        Damage{"MaterialTwice", "*Damping, alpha=3.", "*MATERIAL, NAME=NYLON",
               "line 28: the material NYLON is defined a second time"},
        Damage{"AmplitudeTimes", "2., 0.5", "1., 0.5", "line 31: the times of the amplitude PULL do not ascend"},
        Damage{"AmplitudePairs", "2., 0.5", "2.", "line 31: an amplitude needs pairs of time and value"},
        Damage{"Freedom", "ends, 3", "ends, 7",
               "line 34: the degrees of freedom of a boundary are a first and a last of 1 to 6"},
        Damage{"BoundaryNode", "1, encastre", "9, encastre", "line 33: the node 9 does not exist"},
        Damage{"BoundarySet", "ends, 3", "begins, 3", "line 34: the node set \"BEGINS\" does not exist"},
        Damage{"BoundaryAmplitude", "=PULL", "=PUSH", "line 39: the amplitude \"PUSH\" does not exist"},
        Damage{"Duration", ", 2.\n*boundary", "2.\n*boundary",
               "line 37: the duration of a step, the second entry, must be positive"},
        Damage{"StepEnd", "*end step\n", "", "line 35: the step does not end; *END STEP is missing"},
        Damage{"StepInStep", "*dynamic, explicit", "*step\n*dynamic, explicit",
               "line 36: *STEP inside the step of line 35; *END STEP is missing"},
        Damage{"Friction", "*Damping, alpha=3.", "*Friction\n0.1", "line 28: *Friction outside a *SURFACE INTERACTION"},
        Damage{"Parts", "*Damping, alpha=3.", "*Part, name=a",
               "line 28: *Part cannot be read; write the deck as one flat file without parts, instances and includes"},
        Damage{"NoKeyword", "*Damping, alpha=3.", "*, alpha=3.",
               "line 28: a keyword is missing after the *; expected for example *NODE"},
        Damage{"DataFirst", "** by hand", "1, 0., 0., 0.",
               "line 1: \"1, 0., 0., 0.\" before the first keyword; expected a line such as *HEADING"}),
    [](const auto& info) { return info.param.name; });

TEST(AbaqusReader, AsksForASectionOfEveryElementAndOnlyOne) {
  std::string text = kForeignDeck;
  text.replace(text.find("elset=yarn\n0.06"), 10, "elset=half");
  text.insert(text.find("*Beam Section"), "*ELSET, ELSET=HALF\n1\n");
  EXPECT_EQ(complaint(text), "deck.inp, line 13: element 2 has no section");

  text = kForeignDeck;
  text.insert(text.find("*Material, name=Nylon"),
              "*BEAM SECTION, ELSET=yarn, MATERIAL=nylon, SECTION=CIRC\n0.1\n0., 1., 0.\n");
  EXPECT_EQ(complaint(text), "deck.inp, line 23: element 1 gets a second section");
}

TEST(AbaqusReader, RejectsLongLinesAndEmptyFiles) {
  EXPECT_EQ(complaint("*HEADING\n" + std::string(257, 'x') + "\n"),
            "deck.inp, line 2: 257 characters; at most 256 are allowed");
  EXPECT_EQ(complaint(""), "deck.inp: no keyword in it; expected an Abaqus input file");
}

// Given a written deck cut off anywhere within its last part, then the reader never takes it for whole.
TEST(AbaqusReader, NoticesADeckThatWasCutOff) {
  const std::string text = deck_text(model::build_model(fabric_case(3, 2)));
  for (std::size_t kept = text.find("*STEP"); kept + 10 < text.size(); kept += 37) {
    EXPECT_THAT(complaint(text.substr(0, kept + 8)), HasSubstr("deck.inp, line ")) << text.substr(kept, 8);
  }
}

}  // namespace
}  // namespace knitmech::exchange
