#include "model/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "model/parameters_text.h"

namespace knitmech::model {
namespace {

TEST(Parameters, HaveDifferentKeysInKnownSections) {
  std::set<std::string_view> known;
  for (const CaseSection& section : sections()) known.insert(section.name);
  std::set<std::string_view> keys;
  for (const Parameter& parameter : parameters()) {
    EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key;
    EXPECT_TRUE(known.contains(section_name_of(parameter.key))) << parameter.key;
    EXPECT_FALSE(parameter.help.empty()) << parameter.key;
  }
}

TEST(Parameters, HaveAnExampleOrDefaultThatIsAllowed) {
  for (const Parameter& parameter : parameters()) {
    EXPECT_EQ(complaint_about(parameter, parameter.value), "") << parameter.key;
  }
}

TEST(Parameters, FillAMemberOfTheirOwn) {
  // Given a case in which one parameter is set, then no other parameter has changed.
  const Case empty;
  for (const Parameter& set : parameters()) {
    Case input;
    set_value(input, set, set.value);
    EXPECT_EQ(value_in(input, set), set.value) << set.key;
    for (const Parameter& other : parameters()) {
      if (other.key != set.key) {
        EXPECT_EQ(value_in(input, other), value_in(empty, other)) << set.key << other.key;
      }
    }
  }
}

TEST(Parameters, GivenTwoCases_ThenTheFirstThatDiffersIsFound) {
  // Given a case in which one parameter is set, then it is the one that differs.
  const Case empty;
  EXPECT_EQ(first_difference(empty, empty), nullptr);
  for (const Parameter& set : parameters()) {
    Case input;
    set_value(input, set, set.value);
    if (value_in(empty, set) == set.value) continue;
    EXPECT_EQ(first_difference(input, empty), &set) << set.key;
  }
  Case both;
  both.fabric.wales = 3;
  both.output.history_points = 5;
  ASSERT_NE(first_difference(both, empty), nullptr);
  EXPECT_EQ(first_difference(both, empty)->key, "fabric.wales");
}

TEST(Parameters, HaveTheirChoicesInTheOrderOfTheEnumeration) {
  Case input;
  set_value(input, *find_parameter("test.grips"), "sliding");
  EXPECT_EQ(input.test.grips, Grips::sliding);
  set_value(input, *find_parameter("test.grips"), "clamped");
  EXPECT_EQ(input.test.grips, Grips::clamped);
}

TEST(Parameters, ExcludeAnOpenEndOfTheirRange) {
  const Parameter& radius = *find_parameter("loop.head_radius");
  EXPECT_EQ(complaint_about(radius, 0.0), "must be greater than 0 mm and at most 1000 mm, but is 0 mm");
  EXPECT_EQ(complaint_about(radius, 1000.0), "");
  const Parameter& flat = *find_parameter("loop.head_flat");
  EXPECT_EQ(complaint_about(flat, 0.0), "");
}

TEST(InputReference, InTheDocumentationIsCurrent) {
  std::ifstream page(std::string(KNITMECH_SOURCE_DIR) + "/docs/input-reference.md");
  std::stringstream text;
  text << page.rdbuf();
  EXPECT_EQ(text.str(), input_reference()) << "write it anew: knitmech parameters --markdown > docs/input-reference.md";
}

}  // namespace
}  // namespace knitmech::model
