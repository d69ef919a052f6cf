#include "yarn/table_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  split_cells(line, separator, cells);
  return cells;
}

TEST(TableText, IsUtf8WhateverTheFileHas) {
  EXPECT_EQ(table_text("\xef\xbb\xbfPr\xc3\xbc"), "Prü");  // UTF-8 with its mark
  EXPECT_EQ(table_text("Pr\xfc"), "Prü");                  // Latin-1
  EXPECT_EQ(table_text("\xb5m"), "µm");
  EXPECT_THAT([] { (void)table_text(" \r\n\n"); }, ThrowsMessage<InputError>(HasSubstr("empty")));
  EXPECT_THAT([] { (void)table_text(std::string_view("a\0b", 3)); },
              ThrowsMessage<InputError>(HasSubstr("not a text")));
  EXPECT_THAT(
      [] {
        (void)table_text(
            "\xff\xfe"
            "a");
      },
      ThrowsMessage<InputError>(HasSubstr("UTF-16")));
}

TEST(TableText, HasLinesOfEverySystem) {
  EXPECT_THAT(lines_of("a\nb\r\n\r\nc\rd"), ElementsAre("a", "b", "", "c", "d"));
  EXPECT_THAT(lines_of("a\n"), ElementsAre("a"));
}

TEST(TableText, SplitsCellsButNotWithinQuotes) {
  EXPECT_THAT(cells_of(" 1,5 ; 2 ;;", ';'), ElementsAre("1,5", "2", "", ""));
  EXPECT_THAT(cells_of(R"("1,5", "2,5",x)", ','), ElementsAre("1,5", "2,5", "x"));
  EXPECT_THAT(cells_of(R"(5" wide;2)", ';'), ElementsAre("5\" wide", "2"));
  EXPECT_THAT(cells_of(R"("never closed;2)", ';'), ElementsAre("\"never closed", "2"));
  EXPECT_THAT(cells_of("", ';'), ElementsAre(""));
}

TEST(NumberReader, ReadsPointsOrCommasButNotBoth) {
  EXPECT_EQ(NumberReader().number("1,25"), 1.25);
  EXPECT_EQ(NumberReader().number("+1.25E-2"), 0.0125);
  EXPECT_EQ(NumberReader().number("-7"), -7);
  EXPECT_EQ(NumberReader().number(",5"), 0.5);
  NumberReader reader;
  EXPECT_EQ(reader.number("1,25"), 1.25);
  EXPECT_EQ(reader.number("3"), 3);
  EXPECT_THAT([&] { (void)reader.number("1.234"); }, ThrowsMessage<InputError>(HasSubstr("decimal point")));
}

TEST(NumberReader, RefusesWhatIsNoFiniteNumber) {
  for (const char* text :
       {"", "abc", "1.5 N", "nan", "inf", "-inf", "1e999", "1.234,5", "1'000", "--1", "+-1", "0x10", "1e"}) {
    EXPECT_THROW((void)NumberReader().number(text), InputError) << text;
  }
}

}  // namespace
}  // namespace knitmech::yarn
