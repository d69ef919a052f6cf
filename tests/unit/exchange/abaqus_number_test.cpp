#include "exchange/abaqus_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace knitmech::exchange {
namespace {

double read_back(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

TEST(AbaqusNumber, IsNeverTakenForAnInteger) {
  EXPECT_EQ(abaqus_number(3), "3.");
  EXPECT_EQ(abaqus_number(0), "0.");
  EXPECT_EQ(abaqus_number(-0.12), "-0.12");
  EXPECT_EQ(abaqus_number(1.14e-9), "1.14e-09");
}

// Given coordinates as fabrics have them, when written, then all bits come back from at most 20 characters.
TEST(AbaqusNumber, KeepsAllBitsFromATenthUpward) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-1, 6);
  for (int i = 0; i < 20000; ++i) {
    const double value = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random));
    const std::string text = abaqus_number(value);
    ASSERT_LE(text.size(), 20U) << text;
    ASSERT_EQ(read_back(text), value) << text;
  }
}

TEST(AbaqusNumber, CutsSmallNumbersToTheWidthWithoutChangingTheirSize) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-30, -1);
  for (int i = 0; i < 20000; ++i) {
    const double value = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random));
    const std::string text = abaqus_number(value);
    ASSERT_LE(text.size(), 20U) << text;
    ASSERT_LE(std::abs(read_back(text) - value), 1e-17) << text;
    ASSERT_LE(std::abs(read_back(text) - value), 1e-12 * std::abs(value)) << text;
  }
}

TEST(AbaqusText, IsOneLineOfAscii) {
  EXPECT_EQ(abaqus_text("T\xC3\xBCll\nA*b"), "T??ll?A*b");
}

}  // namespace
}  // namespace knitmech::exchange
