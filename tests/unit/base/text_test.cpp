#include "base/text.h"

#include <gtest/gtest.h>

#include <string>

namespace knitmech::base {
namespace {

TEST(EditDistance, CountsInsertedDeletedAndReplacedLetters) {
  EXPECT_EQ(edit_distance("height", "height"), 0);
  EXPECT_EQ(edit_distance("heigt", "height"), 1);
  EXPECT_EQ(edit_distance("heightt", "height"), 1);
  EXPECT_EQ(edit_distance("hieght", "height"), 2);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  // The example of the textbooks.
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearestWord, IsTheOneWithTheFewestChanges) {
  EXPECT_EQ(nearest_word("hieght", {"width", "height"}), "height");
  EXPECT_EQ(nearest_word("head_radios", {"head_radius", "foot_radius"}), "head_radius");
}

TEST(NearestWord, IsEmptyWhereNothingIsNear) {
  EXPECT_EQ(nearest_word("colour", {"width", "height"}), "");
  EXPECT_EQ(nearest_word(std::string(5000, 'x'), {"width", "height"}), "");
}

TEST(InQuotes, HidesControlCharactersAndCutsLongTexts) {
  EXPECT_EQ(in_quotes("a\nb"), "\"a?b\"");
  EXPECT_EQ(in_quotes(std::string(100, 'x')), '"' + std::string(60, 'x') + "...\"");
}

TEST(InQuotes, NeverCutsWithinALetter) {
  // Given a text in which byte 60 lies within a letter of two bytes.
  EXPECT_EQ(in_quotes(std::string(59, 'x') + "µµµ"), '"' + std::string(59, 'x') + "...\"");
}

TEST(TakeLetter, ReadsLettersOfOneToFourBytes) {
  std::string_view text = "aµ€😀";
  std::u32string letters;
  while (!text.empty()) letters += take_letter(text);
  EXPECT_TRUE(letters == U"aµ€😀");
}

TEST(TakeLetter, ReplacesWhatIsNoLetter) {
  for (const std::string_view wrong : {"\x80", "\xC3", "\xC3z", "\xFFzzz"}) {
    std::string_view text = wrong;
    EXPECT_EQ(take_letter(text), U'\uFFFD');
    EXPECT_EQ(text.size() + 1, wrong.size());
  }
}

TEST(Alternatives, ReadAsASentence) {
  EXPECT_EQ(alternatives({"a"}), "a");
  EXPECT_EQ(alternatives({"a", "b"}), "a or b");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "a, b or c");
}

}  // namespace
}  // namespace knitmech::base
