#include "model/case_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/parameters.h"
#include "model/parameters_text.h"

namespace knitmech::model {
namespace {

const std::string kSource = KNITMECH_SOURCE_DIR;

std::string replaced(std::string text, const std::string& before, const std::string& after) {
  const auto place = text.find(before);
  EXPECT_NE(place, std::string::npos) << before;
  return text.replace(place, before.size(), after);
}

void expect_same_values(const Case& case_a, const Case& case_b, const std::string& except = "") {
  for (const Parameter& parameter : parameters()) {
    if (parameter.key == except) continue;
    EXPECT_EQ(value_in(case_a, parameter), value_in(case_b, parameter)) << parameter.key;
  }
}

TEST(CaseFile, OfTheMainExampleHasItsNumbersInInternalUnits) {
  const Case input = read_case_file(kSource + "/examples/02-wale-tension/case.toml");
  EXPECT_EQ(input.loop.height, 7);
  EXPECT_EQ(input.loop.width, 3.9);
  EXPECT_EQ(input.loop.head_flat, 0.2);
  EXPECT_EQ(input.loop.head_radius, 1.1);
  EXPECT_EQ(input.loop.foot_flat, 0.2);
  EXPECT_EQ(input.loop.foot_radius, 1);
  EXPECT_FALSE(input.loop.out_of_plane.has_value());
  EXPECT_EQ(input.fabric.wales, 9);
  EXPECT_EQ(input.fabric.courses, 15);
  EXPECT_EQ(input.fabric.course_spacing, 5);
  EXPECT_EQ(input.fabric.elements_per_erc, 10);
  EXPECT_EQ(input.yarn.diameter, 0.12);
  EXPECT_EQ(input.yarn.density, 1.14e-9);
  EXPECT_EQ(input.yarn.youngs_modulus, 1700);
  EXPECT_EQ(input.yarn.poissons_ratio, 0.39);
  EXPECT_EQ(input.contact.friction, 0.1);
  EXPECT_EQ(input.test.strain, 0.22);
  EXPECT_EQ(input.test.speed, 5);
  EXPECT_EQ(input.test.ramp, 0.5);
  EXPECT_FALSE(input.solver.mass_scaling.has_value());
  EXPECT_EQ(input.output.frames_at, (std::vector<double>{0.022, 0.08, 0.16, 0.22}));
}

TEST(CaseFile, OfEveryNamedCaseIsRead) {
  for (const char* name : {"/examples/01-first-loop/case.toml", "/cases/reference-9x15.toml",
                           "/cases/reference-5x7.toml", "/cases/reference-3x4.toml"}) {
    EXPECT_NO_THROW((void)read_case_file(kSource + name)) << name;
  }
}

TEST(CaseFile, ThatIsTheTemplateIsTheMainExample) {
  expect_same_values(parse_case(case_template(), "template"),
                     read_case_file(kSource + "/examples/02-wale-tension/case.toml"));
}

TEST(CaseFile, ShowsInTheTemplateWhatHoldsWithoutTheLine) {
  // Given the template with every default made active, when it is read, then it is the case of the template as it
  // stands.
  std::string text = case_template();
  for (const Parameter& parameter : parameters()) {
    if (parameter.need != Need::defaulted && parameter.need != Need::automatic) continue;
    if (parameter.from == FabricFrom::file) continue;  // the template is that of a fabric of loops
    // The yarn and the edge yarn have keys of the same name: the line of this section counts.
    const auto section = text.find(fmt::format("\n[{}]\n", section_name_of(parameter.key)));
    const auto line = text.find(fmt::format("\n# {} = ", name_of(parameter.key)), section);
    ASSERT_NE(line, std::string::npos) << parameter.key;
    text.erase(line + 1, 2);
  }
  expect_same_values(parse_case(text, "all active"), parse_case(case_template(), "template"));
}

TEST(CaseFile, WrittenAndReadAgainHasTheSameBits) {
  Case input = parse_case(case_template(), "template");
  input.title = "quotes \" and \\ and µ";
  input.loop.height = 7 + 1e-15;
  input.loop.out_of_plane = 1.0 / 3.0;
  input.yarn.density = 1.0 / 3.0 * 1e-9;
  input.solver.mass_scaling = 1e4 / 3.0;
  input.test.grips = Grips::sliding;
  input.output.frames_at = {0.1 / 3.0, 0.22};
  expect_same_values(parse_case(write_case(input), "written"), input);
}

TEST(CaseFile, OfATestThatEndsBeforeTheFirstDefaultFrameIsReadAgain) {
  const std::string text = replaced(case_template(), "# strain = 0.22", "strain = 0.02");
  const Case input = parse_case(text, "short");
  EXPECT_TRUE(input.output.frames_at.empty());
  expect_same_values(parse_case(write_case(input), "written"), input);
}

TEST(CaseFile, WrittenKeepsTheStiffnessesInPlaceOfTheModulus) {
  Case input = parse_case(case_template(), "template");
  input.yarn.youngs_modulus.reset();
  input.yarn.poissons_ratio.reset();
  input.yarn.axial_stiffness = 19.2265;
  input.yarn.bending_stiffness = 5e-6;
  input.yarn.torsional_stiffness = 0.0124488;
  expect_same_values(parse_case(write_case(input), "written"), input);
}

TEST(CaseFile, WithoutFramesTakesTheDefaultOnesWithinTheTest) {
  std::string text = replaced(case_template(), "# strain = 0.22", "strain = 0.1");
  EXPECT_EQ(parse_case(text, "short").output.frames_at, (std::vector<double>{0.022, 0.08}));
  text = replaced(case_template(), "# strain = 0.22", "strain = 0.5");
  EXPECT_EQ(parse_case(text, "long").output.frames_at, (std::vector<double>{0.022, 0.08, 0.16, 0.22, 0.42}));
}

TEST(CaseFile, MayUseEverySpellingOfToml) {
  const std::string usual = "[contact]\nfriction = 0.1";
  EXPECT_EQ(parse_case(replaced(case_template(), usual, "[contact]\n'friction' = 1e-1"), "").contact.friction, 0.1);
  EXPECT_EQ(parse_case(replaced(case_template(), usual, "[contact]\nfriction = 1"), "").contact.friction, 1);
  EXPECT_EQ(parse_case(replaced(case_template(), usual, "[\"contact\"]\nfriction = 0.1"), "").contact.friction, 0.1);
}

TEST(CaseFile, MayEndItsLinesAsWindowsDoes) {
  std::string text;
  for (const char letter : case_template()) text += letter == '\n' ? "\r\n" : std::string(1, letter);
  expect_same_values(parse_case(text, "windows"), parse_case(case_template(), "template"));
}

TEST(LineOfKey, IsThatOfTheKeyOrOfItsSection) {
  const std::string text = "title = \"a\"\n\n[loop]\nheight = \"7 mm\"\n";
  EXPECT_EQ(line_of_key(text, "loop.height"), 4);
  EXPECT_EQ(line_of_key(text, "loop.width"), 3);
  EXPECT_EQ(line_of_key(text, "yarn.diameter"), 0);
}

}  // namespace
}  // namespace knitmech::model
