// Numbers and lines of decks whose values stand in columns.

#include "exchange/fixed_card.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <vector>

#include "base/errors.h"

namespace knitmech::exchange {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(NumberWithin, GivenRoom_ThenItIsTheShortestTextThatGivesBackTheSameBits) {
  EXPECT_EQ(number_within(1700, 10), "1700");
  EXPECT_EQ(number_within(0, 10), "0");
  EXPECT_EQ(number_within(-0.12, 10), "-0.12");
  EXPECT_EQ(number_within(1.14e-5, 10), "1.14e-5");
  EXPECT_EQ(number_within(2.5e21, 10), "2.5e21");
}

TEST(NumberWithin, GivenLittleRoom_ThenItIsRoundedAndLosesTheZeroBeforeThePoint) {
  EXPECT_EQ(number_within(0.011309733552923255, 10), ".011309734");
  EXPECT_EQ(number_within(-0.9849070494963617, 10), "-.98490705");
  EXPECT_EQ(number_within(1.0178760197630929e-05, 10), "1.01788e-5");
  EXPECT_EQ(number_within(2.0 / 3, 3), ".67");
}

TEST(NumberWithin, GivenNoRoomForADigit_ThenItIsRefused) {
  EXPECT_THROW((void)number_within(-1e-12, 4), std::invalid_argument);
}

TEST(NumberWithin, GivenNumbersOfManySizes_ThenTheyFitAndAreRightToTheDigitsThatFit) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-9, 9);
  for (int i = 0; i < 20000; ++i) {
    const double value = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random));
    const std::string narrow = number_within(value, 10), wide = number_within(value, 19);
    ASSERT_LE(narrow.size(), 10U);
    ASSERT_LE(wide.size(), 19U);
    // Sign, point and exponent take at most five of the characters.
    ASSERT_NEAR(std::strtod(narrow.c_str(), nullptr), value, 5e-5 * std::abs(value)) << narrow;
    ASSERT_NEAR(std::strtod(wide.c_str(), nullptr), value, 5e-14 * std::abs(value)) << wide;
  }
}

TEST(FixedCard, PutsValuesAtTheRightEndOfTheirFields) {
  FixedCard card;
  card.whole(12).word("Y", 5).blank(3).real(0.5, 10).real(1.0 / 3, 6, 6);
  EXPECT_EQ(card.text(), "        12    Y          0.5.33333");
}

TEST(FixedCard, GivenAWordLongerThanItsField_ThenItIsRefused) {
  EXPECT_THROW(FixedCard().word("12345678901"), std::invalid_argument);
  EXPECT_THROW(FixedCard().whole(123456789012), std::invalid_argument);
}

TEST(CardsOfNumbers, FillsLinesAndEndsEach) {
  EXPECT_EQ(cards_of_numbers({1, 2, 3}, 2, 4), "   1   2\n   3\n");
  EXPECT_EQ(cards_of_numbers({1, 2}, 2, 4), "   1   2\n");
}

const std::vector<std::size_t> kWidths{5, 5, 10};

TEST(FixedFields, ReadsWhatStandsInEachFieldAndNothingAsZero) {
  const FixedFields fields("deck", 7, "   12       1.5e-3", kWidths);
  EXPECT_EQ(fields.whole(0), 12);
  EXPECT_TRUE(fields.blank(1));
  EXPECT_EQ(fields.real(1), 0);
  EXPECT_EQ(fields.real(2), 1.5e-3);
  EXPECT_EQ(FixedFields("deck", 7, "", kWidths).whole(2), 0);
}

TEST(FixedFields, GivenAValueThatDoesNotStandInItsField_ThenItIsRefusedWithItsLine) {
  const FixedFields fields("deck", 7, "  1 2 1.5", kWidths);
  EXPECT_THAT([&] { (void)fields.whole(0); }, ThrowsMessage<InputError>("deck, line 7: \"1 2\" is not a whole number"));
  EXPECT_THAT([&] { (void)fields.whole(1); }, ThrowsMessage<InputError>(HasSubstr("\"1.5\" is not a whole number")));
  EXPECT_THAT([] { FixedFields("deck", 8, "    1    2         3  4", kWidths); },
              ThrowsMessage<InputError>(HasSubstr("deck, line 8: \"4\" stands behind column 20")));
}

}  // namespace
}  // namespace knitmech::exchange
