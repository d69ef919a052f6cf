// Every way to give a yarn in a case file, and every way to give it wrongly.

#include "model/sections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/errors.h"
#include "example_case.h"
#include "model/case_file.h"
#include "yarn/monofilament.h"
#include "yarn/multifilament.h"

namespace knitmech::model {
namespace {

using testing::HasSubstr;

/// A case whose [yarn] and [edge_yarn] begin at the lines 12 and 15.
std::string case_text(const std::string& yarn, const std::string& edge_yarn = "", const std::string& more = "") {
  return "title = \"yarns\"\n[loop]\nheight = \"7 mm\"\nwidth = \"3.9 mm\"\nhead_flat = \"0.2 mm\"\n"
         "head_radius = \"1.1 mm\"\nfoot_flat = \"0.2 mm\"\nfoot_radius = \"1 mm\"\n[fabric]\n"
         "wales = 3\ncourses = 2\ncourse_spacing = \"5 mm\"\nstructure = \"adjusted\"\n"
         "[contact]\nfriction = 0.1\n[yarn]\ndiameter = \"0.12 mm\"\ndensity = \"1140 kg/m^3\"\n" +
         yarn + "[edge_yarn]\n" + edge_yarn + more;
}

Case case_with(const std::string& yarn, const std::string& edge_yarn = "") {
  return parse_case(case_text(yarn, edge_yarn), "yarns.toml");
}

void expect_same(const yarn::Section& found, const yarn::Section& expected) {
  EXPECT_DOUBLE_EQ(found.diameter, expected.diameter);
  EXPECT_DOUBLE_EQ(found.axial_stiffness, expected.axial_stiffness);
  EXPECT_DOUBLE_EQ(found.shear_stiffness, expected.shear_stiffness);
  EXPECT_DOUBLE_EQ(found.bending_stiffness, expected.bending_stiffness);
  EXPECT_DOUBLE_EQ(found.torsional_stiffness, expected.torsional_stiffness);
  EXPECT_DOUBLE_EQ(found.mass_per_length, expected.mass_per_length);
}

const char* const kMonofilament = "youngs_modulus = \"1700 MPa\"\npoissons_ratio = 0.39\n";
const char* const kFilaments =
    "youngs_modulus = \"3000 MPa\"\nshear_modulus = \"700 MPa\"\nfilaments = 34\nfilament_diameter = \"16 um\"\n"
    "twist = \"0.4 /mm\"\n";
const char* const kOutright =
    "axial_stiffness = \"19 N\"\nbending_stiffness = \"0.017 N mm^2\"\ntorsional_stiffness = \"0.012 N mm^2\"\n";

yarn::Multifilament multifilament() {
  return {.filaments = 34,
          .filament = {.diameter = 0.016, .youngs_modulus = 3000, .density = 1.14e-9, .shear_modulus = 700},
          .diameter = 0.12,
          .twist = 0.4};
}

TEST(SectionOfCase, GivenEAndNu_ThenItIsThatOfAMonofilament) {
  expect_same(section_of(case_with(kMonofilament)), yarn::section_of(yarn::Monofilament{0.12, 1700, 0.39, 1.14e-9}));
}

TEST(SectionOfCase, GivenAShearModulusInPlaceOfNu_ThenItIsThatOfAMonofilamentWithThatShearModulus) {
  const Case input = case_with("youngs_modulus = \"1700 MPa\"\nshear_modulus = \"400 MPa\"\n");
  expect_same(section_of(input),
              yarn::section_of(yarn::Monofilament{
                  .diameter = 0.12, .youngs_modulus = 1700, .density = 1.14e-9, .shear_modulus = 400}));
  // GJ = G pi D^4 / 32.
  EXPECT_NEAR(section_of(input).torsional_stiffness, 400 * 2.0357520395261863e-5, 1e-12);
}

TEST(SectionOfCase, GivenFilaments_ThenItIsThatOfTheTwistedMultifilament) {
  expect_same(section_of(case_with(kFilaments)), yarn::section_of(multifilament()));
}

TEST(SectionOfCase, GivenStiffnesses_ThenItHasThem) {
  const yarn::Section section = section_of(case_with(kOutright));
  EXPECT_EQ(section.axial_stiffness, 19);
  EXPECT_EQ(section.bending_stiffness, 0.017);
  EXPECT_EQ(section.torsional_stiffness, 0.012);
}

const std::string kCurve = "curve_strains = [0, 0.1, 0.2]\ncurve_forces = [\"0 N\", \"2 N\", \"3 N\"]\n";

TEST(SectionOfCase, GivenAMeasuredCurve_ThenItsSlopeAtZeroStandsForEA) {
  // The slope at 0 of the parabola through (0, 0), (0.1, 2) and (0.2, 3): secants 20 and 10 N, so 20 + (20 - 10) / 2.
  const Case outright =
      case_with("bending_stiffness = \"0.017 N mm^2\"\ntorsional_stiffness = \"0.012 N mm^2\"\n" + kCurve);
  EXPECT_NEAR(section_of(outright).axial_stiffness, 25, 1e-12);
  EXPECT_EQ(section_of(outright).bending_stiffness, 0.017);
  const Case monofilament = case_with("poissons_ratio = 0.39\n" + kCurve);
  EXPECT_NEAR(section_of(monofilament).axial_stiffness, 25, 1e-12);
  EXPECT_NEAR(section_of(monofilament).bending_stiffness, 25 * 0.12 * 0.12 / 16, 1e-12);  // EA D^2 / 16, a circle
}

TEST(SectionOfCase, GivenACurve_ThenTheAxialLawGoesThroughItsPoints) {
  const auto law = axial_law_of(case_with("poissons_ratio = 0.39\n" + kCurve));
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->force(0.1), 2, 1e-13);
  EXPECT_NEAR(law->force(0.2), 3, 1e-13);
  EXPECT_FALSE(axial_law_of(case_with(kMonofilament)));
}

TEST(EdgeSectionOfCase, GivenFilaments_ThenItIsThatOfTheTwistedMultifilament) {
  expect_same(edge_section_of(case_with(kMonofilament, kFilaments)), yarn::section_of(multifilament()));
}

TEST(EdgeSectionOfCase, GivenItsBendingAlone_ThenTheRestFollowsFromTheYarn) {
  const Case input = case_with(kMonofilament, "bending_stiffness = \"1e-4 N mm^2\"\n");
  const yarn::Section yarn = section_of(input);
  const yarn::Section edge = edge_section_of(input);
  EXPECT_EQ(edge.bending_stiffness, 1e-4);
  EXPECT_NEAR(edge.torsional_stiffness, 1e-4 / 1.39, 1e-12);  // EI / GJ = 1 + nu in a circle
  EXPECT_EQ(edge.axial_stiffness, yarn.axial_stiffness);
}

struct WrongYarn {
  const char* name;
  std::string yarn, edge_yarn;
  std::vector<const char*> said;  ///< the key first
};

class WrongYarnTest : public testing::TestWithParam<WrongYarn> {};

TEST_P(WrongYarnTest, IsRefusedWithOneSentenceThatNamesTheKey) {
  try {
    (void)case_with(GetParam().yarn, GetParam().edge_yarn);
    FAIL() << "was not refused";
  } catch (const CaseFileError& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.key(), GetParam().said.front());
    EXPECT_GT(error.line(), 0);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const char* words : GetParam().said) EXPECT_THAT(message, HasSubstr(words));
  }
}

std::string without(std::string text, const std::string& key) {
  const auto start = text.find(key + " =");
  return text.erase(start, text.find('\n', start) + 1 - start);
}

const std::string kFilamentsText = kFilaments;
const std::string kOutrightText = kOutright;

INSTANTIATE_TEST_SUITE_P(
    Yarns, WrongYarnTest,
    testing::Values(
        WrongYarn{"nothing", "", "", {"yarn.youngs_modulus", "missing", "axial_stiffness, bending_stiffness"}},
        WrongYarn{"no_modulus", "poissons_ratio = 0.3\n", "", {"yarn.youngs_modulus", "missing"}},
        WrongYarn{
            "no_shear", "youngs_modulus = \"1700 MPa\"\n", "", {"yarn.poissons_ratio", "missing", "shear_modulus"}},
        WrongYarn{"nu_and_g",
                  std::string(kMonofilament) + "shear_modulus = \"600 MPa\"\n",
                  "",
                  {"yarn.shear_modulus", "beside poissons_ratio", "keep one"}},
        WrongYarn{"no_number", without(kFilaments, "filaments"), "", {"yarn.filaments", "missing"}},
        WrongYarn{"no_filament_diameter",
                  without(kFilaments, "filament_diameter"),
                  "",
                  {"yarn.filament_diameter", "missing"}},
        WrongYarn{"no_twist", without(kFilaments, "twist"), "", {"yarn.twist", "missing"}},
        WrongYarn{"filaments_without_material",
                  "filaments = 34\nfilament_diameter = \"16 um\"\ntwist = \"0.4 /mm\"\n",
                  "",
                  {"yarn.youngs_modulus", "missing"}},
        WrongYarn{"filaments_and_stiffnesses",
                  kOutrightText + "filaments = 34\nfilament_diameter = \"16 um\"\ntwist = \"0.4 /mm\"\n",
                  "",
                  {"yarn.axial_stiffness", "given twice", "filaments"}},
        WrongYarn{"shear_modulus_and_stiffnesses",
                  kOutrightText + "shear_modulus = \"600 MPa\"\n",
                  "",
                  {"yarn.axial_stiffness", "given twice", "shear_modulus"}},
        WrongYarn{"no_bending", without(kOutright, "bending_stiffness"), "", {"yarn.bending_stiffness", "missing"}},
        WrongYarn{
            "no_torsion", without(kOutright, "torsional_stiffness"), "", {"yarn.torsional_stiffness", "missing"}}),
    [](const auto& tested) { return tested.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Curves, WrongYarnTest,
    testing::Values(
        WrongYarn{"strains_alone",
                  "poissons_ratio = 0.3\ncurve_strains = [0, 0.1]\n",
                  "",
                  {"yarn.curve_forces", "0 forces", "2 strains"}},
        WrongYarn{"one_force_missing",
                  "poissons_ratio = 0.3\ncurve_strains = [0, 0.1, 0.2]\ncurve_forces = [\"0 N\", \"1 N\"]\n",
                  "",
                  {"yarn.curve_forces", "2 forces", "3 strains"}},
        WrongYarn{"curve_and_modulus",
                  kMonofilament + kCurve,
                  "",
                  {"yarn.youngs_modulus", "yarn.curve_strains", "remove one"}},
        WrongYarn{
            "curve_and_ea", kOutrightText + kCurve, "", {"yarn.axial_stiffness", "yarn.curve_strains", "remove one"}},
        WrongYarn{"curve_and_filaments",
                  without(kFilaments, "youngs_modulus") + kCurve,
                  "",
                  {"yarn.filaments", "curve", "remove one"}},
        WrongYarn{"curve_without_shear", kCurve, "", {"yarn.poissons_ratio", "missing"}},
        WrongYarn{"falling_curve",
                  "poissons_ratio = 0.3\ncurve_strains = [0, 0.1, 0.2]\ncurve_forces = [\"0 N\", \"2 N\", \"1 N\"]\n",
                  "",
                  {"yarn.curve_forces", "yarn.curve_strains", "no tensile curve", "point 3"}},
        WrongYarn{"curve_not_from_zero",
                  "poissons_ratio = 0.3\ncurve_strains = [0.01, 0.1]\ncurve_forces = [\"0 N\", \"2 N\"]\n",
                  "",
                  {"yarn.curve_forces", "no tensile curve", "point 1"}}),
    [](const auto& tested) { return tested.param.name; });

INSTANTIATE_TEST_SUITE_P(
    EdgeYarns, WrongYarnTest,
    testing::Values(
        WrongYarn{
            "edge_no_shear", kMonofilament, "youngs_modulus = \"3000 MPa\"\n", {"edge_yarn.poissons_ratio", "missing"}},
        WrongYarn{"edge_no_modulus", kMonofilament, "poissons_ratio = 0.3\n", {"edge_yarn.youngs_modulus", "missing"}},
        WrongYarn{"edge_nu_and_g",
                  kMonofilament,
                  std::string(kMonofilament) + "shear_modulus = \"600 MPa\"\n",
                  {"edge_yarn.shear_modulus", "beside poissons_ratio"}},
        WrongYarn{"edge_no_twist", kMonofilament, without(kFilaments, "twist"), {"edge_yarn.twist", "missing"}},
        WrongYarn{"edge_filaments_and_bending",
                  kMonofilament,
                  kFilamentsText + "bending_stiffness = \"5e-6 N mm^2\"\n",
                  {"edge_yarn.bending_stiffness", "given twice"}}),
    [](const auto& tested) { return tested.param.name; });

TEST(WrongYarn, GivenFilamentsThatDoNotFitIntoTheYarn_ThenTheSectionIsRefused) {
  // 34 filaments of 0.05 mm have a larger section than the yarn of 0.12 mm.
  Case input = case_with(kFilaments);
  input.yarn.filament_diameter = 0.05;
  EXPECT_THROW((void)section_of(input), InputError);
}

}  // namespace
}  // namespace knitmech::model
