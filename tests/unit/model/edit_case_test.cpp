#include "model/edit_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "model/case_file.h"

namespace knitmech::model {
namespace {

using testing::HasSubstr;

const std::string kCase = R"(# My first jersey, 7 µm thinner than the last
title = "Jersey"  # as on the label

[loop]
height = "7 mm"         # H
width = "3.9 mm"        # L, from "ten wales" µ
# head_flat = "0.2 mm"    # l1

[output]
frames_at = [
  0.022,  # small
  0.08,
]  # and no more
)";

TEST(EditedCase, HasTheNewValueAndAllComments) {
  EXPECT_EQ(with_value(kCase, "loop.height", "7.25 mm"),
            std::string(kCase).replace(kCase.find("7 mm\""), 4, "7.25 mm"));
  EXPECT_THAT(with_value(kCase, "loop.width", "4 mm"),
              HasSubstr("width = \"4 mm\"        # L, from \"ten wales\" µ\n"));
  EXPECT_THAT(with_value(kCase, "title", "A \"new\" one"),
              HasSubstr("title = \"A \\\"new\\\" one\"  # as on the label\n"));
}

TEST(EditedCase, ChangesAListOverSeveralLines) {
  EXPECT_THAT(with_value(kCase, "output.frames_at", "0.1 0.2"), HasSubstr("frames_at = [0.1, 0.2]  # and no more\n"));
}

TEST(EditedCase, TakesTheLineThatHoldsThePlaceOfAKey) {
  EXPECT_THAT(with_value(kCase, "loop.head_flat", "0.3 mm"), HasSubstr("\nhead_flat = \"0.3 mm\"    # l1\n"));
}

TEST(EditedCase, PutsANewKeyBehindThoseBeforeItInTheTable) {
  EXPECT_THAT(with_value(kCase, "loop.foot_radius", "1 mm"),
              HasSubstr("width = \"3.9 mm\"        # L, from \"ten wales\" µ\nfoot_radius = \"1 mm\"\n"));
}

TEST(EditedCase, OpensASectionThatIsNotThere) {
  EXPECT_THAT(with_value(kCase, "fabric.wales", "9"), testing::EndsWith("\n[fabric]\nwales = 9\n"));
  EXPECT_EQ(with_value("", "title", "Jersey"), "title = \"Jersey\"\n");
}

TEST(EditedCase, PutsATitleBeforeTheFirstSection) {
  EXPECT_EQ(with_value("[loop]\nheight = \"7 mm\"", "title", "Jersey"),
            "title = \"Jersey\"\n[loop]\nheight = \"7 mm\"\n");
}

TEST(EditedCase, KeepsAnOptionalKeyAsACommentWhenItIsEmptied) {
  const std::string without = with_value(kCase, "output.frames_at", "  ");
  EXPECT_THAT(without, HasSubstr("# frames_at = [\n#   0.022,  # small\n#   0.08,\n# ]  # and no more\n"));
  EXPECT_EQ(with_value("[solver]\nstep_factor = 0.8  # less\n", "solver.step_factor", ""),
            "[solver]\n# step_factor = 0.8  # less\n");
  EXPECT_EQ(with_value("[solver]\n# step_factor = 0.8  # less\n", "solver.step_factor", "0.7"),
            "[solver]\nstep_factor = 0.7  # less\n");
}

TEST(EditedCase, KeepsARequiredKeyWhenItIsEmptied) {
  EXPECT_THAT(with_value(kCase, "loop.height", ""), HasSubstr("height = \"\"         # H\n"));
}

TEST(EditedCase, TakesWhatIsTypedAsTheReaderWantsIt) {
  const auto written = [](const char* key, const char* typed) { return toml_of_typed(*find_parameter(key), typed); };
  EXPECT_EQ(written("fabric.wales", " 9 "), "9");
  EXPECT_EQ(written("fabric.wales", "9.5"), "9.5");
  EXPECT_EQ(written("fabric.wales", "nine"), "\"nine\"");
  EXPECT_EQ(written("contact.friction", ".1"), "0.1");
  EXPECT_EQ(written("contact.friction", "1e-2"), "0.01");
  EXPECT_EQ(written("loop.out_of_plane", "auto"), "\"auto\"");
  EXPECT_EQ(written("fabric.structure", "tied"), "\"tied\"");
  EXPECT_EQ(written("output.frames_at", "[0.1, 0.2]"), "[0.1, 0.2]");
  EXPECT_EQ(written("yarn.curve_forces", "1 N, 2 N"), "[\"1 N\", \"2 N\"]");
  EXPECT_EQ(written("title", "a\tb\\"), "\"a\\u0009b\\\\\"");
}

TEST(EditedCase, GivesBackWhatWasTyped) {
  // Given every parameter's own value, when it is typed, then the reader sees that value.
  for (const Parameter& parameter : parameters()) {
    const std::string typed = typed_text(parameter, parameter.value);
    if (typed.empty()) continue;
    const auto entries = toml_entries("x = " + toml_of_typed(parameter, typed));
    EXPECT_EQ(typed_text(entries.at(0).value), typed) << parameter.key;
  }
}

TEST(EditedCase, IsRefusedWhereOnlyItsAuthorCanChangeIt) {
  EXPECT_THROW((void)with_value("loop = {height = \"7 mm\",", "loop.height", "8 mm"), InputError);
  EXPECT_THROW((void)with_value("yarn = {strength = \"1 N\"}", "yarn.strength", ""), InputError);
  EXPECT_THROW((void)with_value(kCase, "loop.hight", "8 mm"), InputError);
  EXPECT_THAT(with_value("loop = {height = \"7 mm\", width = \"3 mm\"}", "loop.height", "8 mm"),
              HasSubstr("height = \"8 mm\", width"));
}

TEST(MistakesOfACase, AreToldSideBySide) {
  // Given three wrong lines and a section that lacks keys, then each has its own sentence, in the order of the lines.
  const auto mistakes = mistakes_in("[loop]\nheight = \"7 kg\"\nhight = 3\n[contact]\nfriction = -1\n", "my.toml");
  ASSERT_GE(mistakes.size(), 4U);
  EXPECT_EQ(mistakes[0].key(), "loop.height");
  EXPECT_EQ(mistakes[0].line(), 2);
  EXPECT_THAT(mistakes[0].complaint(), testing::Not(HasSubstr("my.toml")));
  EXPECT_EQ(mistakes[1].line(), 3);
  EXPECT_EQ(mistakes[2].key(), "contact.friction");
  EXPECT_THAT(mistakes[3].complaint(), HasSubstr("is missing"));
}

TEST(MistakesOfACase, BeginWithTheOneThatTheReaderStopsAt) {
  const std::string text = "[loop]\nheight = \"7 kg\"\n";
  try {
    (void)parse_case(text, "my.toml");
    FAIL() << "read a wrong case";
  } catch (const CaseFileError& error) {
    EXPECT_STREQ(error.what(), mistakes_in(text, "my.toml").at(0).what());
  }
  EXPECT_EQ(mistakes_in("= 3", "my.toml").size(), 1U);
}

}  // namespace
}  // namespace knitmech::model
