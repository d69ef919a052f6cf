// Wrong case files, one mistake each, and what the message must say: the line, the key, what is wrong, what is right.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "model/case_file.h"

namespace knitmech::model {
namespace {

using testing::HasSubstr;

/// A good case; the numbers on the left are its lines.
const char* const kGoodCase =
    /*  1 */
    "title = \"good\"\n"
    /*  2 */
    "[loop]\n"
    /*  3 */
    "height = \"7 mm\"\n"
    /*  4 */
    "width = \"3.9 mm\"\n"
    /*  5 */
    "head_flat = \"0.2 mm\"\n"
    /*  6 */
    "head_radius = \"1.1 mm\"\n"
    /*  7 */
    "foot_flat = \"0.2 mm\"\n"
    /*  8 */
    "foot_radius = \"1 mm\"\n"
    /*  9 */
    "[fabric]\n"
    /* 10 */
    "wales = 9\n"
    /* 11 */
    "courses = 15\n"
    /* 12 */
    "course_spacing = \"5 mm\"\n"
    /* 13 */
    "[yarn]\n"
    /* 14 */
    "diameter = \"0.12 mm\"\n"
    /* 15 */
    "density = \"1140 kg/m^3\"\n"
    /* 16 */
    "youngs_modulus = \"1700 MPa\"\n"
    /* 17 */
    "poissons_ratio = 0.39\n"
    /* 18 */
    "[contact]\n"
    /* 19 */
    "friction = 0.1\n"
    /* 20 */
    "[test]\n"
    /* 21 */
    "strain = 0.22\n"
    /* 22 */
    "[output]\n"
    /* 23 */ "frames_at = [0.08, 0.16]\n";

std::string message_of(const std::string& text) {
  try {
    (void)parse_case(text, "my.toml");
  } catch (const CaseFileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WrongCaseFile, StartsFromOneThatIsGood) {
  EXPECT_EQ(message_of(kGoodCase), "no error");
}

struct Mistake {
  const char* name;
  const char* before;  ///< part of the good case
  const char* after;   ///< what stands there instead
  std::vector<const char*> said;
};

class WrongCaseFileTest : public testing::TestWithParam<Mistake> {};

TEST_P(WrongCaseFileTest, IsRefusedWithOneClearSentence) {
  // Given the good case with one mistake.
  std::string text = kGoodCase;
  const auto place = text.find(GetParam().before);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, std::string(GetParam().before).size(), GetParam().after);
  // When it is read, then the message is one line that names file and line and says what is wrong and what would be
  // right.
  const std::string message = message_of(text);
  EXPECT_THAT(message, testing::StartsWith("my.toml"));
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const char* words : GetParam().said) EXPECT_THAT(message, HasSubstr(words));
}

std::string name_of_test(const testing::TestParamInfo<Mistake>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, WrongCaseFileTest,
    testing::Values(
        Mistake{"value_with_unit_unquoted", "\"7 mm\"", "7 mm", {"line 3", "height = \"7 mm\" with quotes"}},
        Mistake{"word_unquoted", "\"0.12 mm\"", "auto", {"line 14", "diameter = \"auto\" with quotes"}},
        Mistake{"quote_not_closed", "\"7 mm\"\n", "\"7 mm\n", {"line 3", "height", "not valid TOML"}},
        Mistake{"section_not_closed", "[loop]", "[loop", {"line 2", "[loop", "not valid TOML"}},
        Mistake{"slash_as_section", "[loop]", "[/", {"line 2", "not valid TOML"}},
        Mistake{"colon_for_equals", "width =", "width :", {"line 4", "key = value"}},
        Mistake{"no_value", "\"3.9 mm\"", "", {"line 4", "value after width ="}},
        Mistake{"decimal_comma_in_number", "0.39", "0,39", {"line 17", "decimal point"}},
        Mistake{"key_twice", "width = \"3.9 mm\"", "height = \"7 mm\"", {"line 4", "height", "second time"}},
        Mistake{"section_twice", "[fabric]", "[loop]", {"line 9", "[loop]", "second time"}},
        Mistake{"list_not_closed", "0.16]", "0.16", {"not valid TOML"}}),
    name_of_test);

INSTANTIATE_TEST_SUITE_P(
    Keys, WrongCaseFileTest,
    testing::Values(
        Mistake{"misspelt_key", "height =", "hieght =", {"line 3", "loop.hieght", "did you mean height?"}},
        Mistake{
            "unknown_key", "width =", "colour =", {"line 4", "loop.colour", "the keys of [loop] are height, width"}},
        Mistake{"misspelt_section", "[fabric]", "[fabrik]", {"line 9", "[fabrik]", "did you mean [fabric]?"}},
        Mistake{"unknown_section", "[test]", "[machine]", {"line 20", "[machine]", "loop, fabric, yarn"}},
        Mistake{"key_of_another_section", "wales = 9", "friction = 9", {"line 10", "friction belongs to [contact]"}},
        Mistake{"key_without_section", "[loop]\n", "", {"line 2", "height", "belongs to [loop]"}},
        Mistake{"unknown_key_at_the_top", "title = \"good\"", "name = 1", {"line 1", "\"name\"", "sections"}},
        Mistake{
            "section_as_value", "width = \"3.9 mm\"", "width.value = 3.9", {"line 4", "loop.width", "is a section"}},
        Mistake{"value_for_section", "title = \"good\"\n[loop]", "loop = 1", {"line 1", "loop", "write [loop]"}},
        Mistake{"list_of_sections", "[test]", "[[test]]", {"line 20", "test", "write [test]"}},
        Mistake{"key_missing", "height = \"7 mm\"\n", "", {"line 2", "loop.height", "missing", "height = \"7 mm\""}},
        Mistake{"title_missing", "title = \"good\"\n", "", {"title", "missing", "top of the file"}},
        Mistake{"friction_missing", "[contact]\nfriction = 0.1\n", "", {"contact.friction", "missing", "[contact]"}}),
    name_of_test);

INSTANTIATE_TEST_SUITE_P(
    Types, WrongCaseFileTest,
    testing::Values(
        Mistake{"no_unit", "\"7 mm\"", "7", {"line 3", "loop.height", "no unit", "height = \"7 mm\""}},
        Mistake{"no_unit_in_text", "\"7 mm\"", "\"7\"", {"line 3", "loop.height", "no unit", "mm, um, cm, m"}},
        Mistake{"unit_of_something_else", "\"7 mm\"", "\"7 MPa\"", {"line 3", "\"MPa\"", "pressure", "mm, um, cm, m"}},
        Mistake{"unknown_unit", "1140 kg/m^3", "9 tex", {"line 15", "yarn.density", "\"tex\"", "kg/m^3, g/cm^3"}},
        Mistake{"decimal_comma_in_text", "3.9 mm", "3,9 mm", {"line 4", "loop.width", "decimal point"}},
        Mistake{"number_in_quotes", "0.39", "\"0.39\"", {"line 17", "yarn.poissons_ratio", "without quotes"}},
        Mistake{"whole_number_in_quotes", "= 9", "= \"9\"", {"line 10", "fabric.wales", "whole number without quotes"}},
        Mistake{"whole_number_with_fraction", "= 9", "= 9.5", {"line 10", "fabric.wales", "9.5", "whole number"}},
        Mistake{"text_is_number", "\"good\"", "12", {"line 1", "title", "text in quotes"}},
        Mistake{"true_for_length", "\"7 mm\"", "true", {"line 3", "loop.height", "true or false", "\"7 mm\""}},
        Mistake{"date_for_number", "0.1\n", "2024-01-01\n", {"line 19", "contact.friction", "a date"}},
        Mistake{"number_for_list",
                "[0.08, 0.16]",
                "0.08",
                {"line 23", "output.frames_at", "is the number 0.08", "write a list"}},
        Mistake{"text_in_list", "0.16]", "\"0.16\"]", {"line 23", "output.frames_at", "place 2", "without quotes"}},
        Mistake{"auto_where_there_is_none", "\"0.12 mm\"", "\"auto\"", {"line 14", "yarn.diameter", "number"}},
        Mistake{"unknown_choice",
                "[test]\n",
                "[test]\ngrips = \"clampt\"\n",
                {"line 21", "test.grips", "\"clamped\" or \"sliding\"", "did you mean \"clamped\"?"}},
        Mistake{"unknown_structure",
                "courses = 15",
                "courses = 15\nstructure = \"teid\"",
                {"line 12", "fabric.structure", "\"basic\" or \"tied\" or \"adjusted\""}}),
    name_of_test);

INSTANTIATE_TEST_SUITE_P(
    Ranges, WrongCaseFileTest,
    testing::Values(
        Mistake{"length_zero", "\"7 mm\"", "\"0 mm\"", {"line 3", "loop.height", "greater than 0 mm"}},
        Mistake{
            "length_negative", "\"0.2 mm\"", "\"-0.2 mm\"", {"line 5", "loop.head_flat", "at least 0 mm", "-0.2 mm"}},
        Mistake{"length_in_metres", "\"7 mm\"", "\"7 m\"", {"line 3", "loop.height", "at most 1000 mm", "7000 mm"}},
        Mistake{"length_nan", "\"7 mm\"", "\"nan mm\"", {"line 3", "loop.height", "finite number"}},
        Mistake{"length_huge", "\"7 mm\"", "\"1e999 mm\"", {"line 3", "loop.height", "finite number"}},
        Mistake{"number_nan", "0.1\n", "nan\n", {"line 19", "contact.friction", "finite number"}},
        Mistake{"number_infinite", "0.1\n", "inf\n", {"line 19", "contact.friction", "finite number"}},
        Mistake{"poissons_ratio_above_half", "0.39", "0.51", {"line 17", "yarn.poissons_ratio", "at most 0.5"}},
        Mistake{"wales_zero", "= 9", "= 0", {"line 10", "fabric.wales", "at least 1"}},
        Mistake{"wales_huge", "= 9", "= 9000000000000000000", {"line 10", "fabric.wales", "at most 100000"}},
        Mistake{"wales_beyond_64_bits", "= 9", "= 99999999999999999999", {"line 10", "not valid TOML"}},
        Mistake{"density_in_the_wrong_unit", "1140 kg/m^3", "1140 g/cm^3", {"line 15", "yarn.density", "kg/m^3"}},
        Mistake{"strain_in_per_cent", "0.22", "22", {"line 21", "test.strain", "at most 2"}},
        Mistake{"title_empty", "\"good\"", "\"  \"", {"line 1", "title", "empty"}},
        Mistake{"title_of_two_lines", "\"good\"", "\"a\\nb\"", {"line 1", "title", "line break"}},
        Mistake{"frames_descending", "0.16]", "0.04]", {"line 23", "output.frames_at", "ascend"}},
        Mistake{"frames_twice_the_same", "0.16]", "0.08]", {"line 23", "output.frames_at", "ascend"}},
        Mistake{"frames_negative", "[0.08", "[-0.08", {"line 23", "output.frames_at", "place 1", "at least 0"}},
        Mistake{"frames_empty", "[0.08, 0.16]", "[]", {"line 23", "output.frames_at", "empty"}}),
    name_of_test);

INSTANTIATE_TEST_SUITE_P(
    Rules, WrongCaseFileTest,
    testing::Values(
        Mistake{
            "frames_beyond_the_end", "0.16]", "0.42]", {"line 23", "output.frames_at", "0.42", "test.strain", "0.22"}},
        Mistake{"stiffness_given_twice",
                "density",
                "axial_stiffness = \"19 N\"\ndensity",
                {"line 15", "yarn.axial_stiffness", "given twice", "either youngs_modulus"}},
        Mistake{
            "modulus_missing", "youngs_modulus = \"1700 MPa\"\n", "", {"line 13", "yarn.youngs_modulus", "missing"}},
        Mistake{"poissons_ratio_missing", "poissons_ratio = 0.39\n", "", {"line 13", "yarn.poissons_ratio", "missing"}},
        Mistake{"stiffnesses_incomplete",
                "youngs_modulus = \"1700 MPa\"\npoissons_ratio = 0.39",
                "axial_stiffness = \"19 N\"\nbending_stiffness = \"0.1 N mm^2\"",
                {"line 13", "yarn.torsional_stiffness", "missing"}},
        Mistake{"fabric_too_large",
                "courses = 15",
                "courses = 100000\nelements_per_erc = 100",
                {"line 12", "fabric.elements_per_erc", "180000000 elements", "at most 20000000"}}),
    name_of_test);

TEST(WrongCaseFile, EmptyIsToldFromMissing) {
  EXPECT_THAT(message_of(""), HasSubstr("is empty"));
  EXPECT_THAT(message_of(" \n\n\t\n"), HasSubstr("is empty"));
}

TEST(WrongCaseFile, BinaryIsNoText) {
  EXPECT_THAT(message_of(std::string("\x7f"
                                     "ELF\0\1\2",
                                     7)),
              HasSubstr("not a text file"));
  EXPECT_THAT(message_of("title = \"\xff\xfe\""), HasSubstr("line 1"));
}

TEST(WrongCaseFile, TooLargeIsRefused) {
  EXPECT_THAT(message_of(std::string(1'000'001, '\n')), HasSubstr("larger than 1000000 bytes"));
}

TEST(WrongCaseFile, ThatNestsDeeplyIsRefusedAndDoesNotExhaustTheStack) {
  std::string dotted = "a";
  for (int i = 0; i < 400'000; ++i) dotted += ".a";
  EXPECT_THAT(message_of(dotted + " = 1"), HasSubstr("line 1"));
  EXPECT_THAT(message_of("[" + dotted + "]"), HasSubstr("line 1"));
  EXPECT_THAT(message_of("x = " + std::string(9000, '[')), HasSubstr("line 1"));
}

TEST(WrongCaseFile, SaysWhereForPrograms) {
  std::string text = kGoodCase;
  text.replace(text.find("\"7 mm\""), 6, "\"7 m\"");
  try {
    (void)parse_case(text, "my.toml");
    FAIL() << "was not refused";
  } catch (const CaseFileError& error) {
    EXPECT_EQ(error.file(), "my.toml");
    EXPECT_EQ(error.line(), 3);
    EXPECT_EQ(error.key(), "loop.height");
  }
}

TEST(CaseFileOnDisk, MissingOrAFolderIsAFileError) {
  EXPECT_THROW((void)read_case_file("/no/such/case.toml"), FileError);
  EXPECT_THROW((void)read_case_file(std::filesystem::temp_directory_path()), FileError);
}

}  // namespace
}  // namespace knitmech::model
