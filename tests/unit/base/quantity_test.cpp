#include "base/quantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "base/errors.h"

namespace knitmech::base {
namespace {

using testing::HasSubstr;

std::string message_of(std::string_view text, Dimension dimension) {
  try {
    (void)parse_quantity(text, dimension);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

struct Written {
  const char* text;
  Dimension dimension;
  double internal;
};

class QuantityTest : public testing::TestWithParam<Written> {};

TEST_P(QuantityTest, IsReadInInternalUnits) {
  EXPECT_EQ(parse_quantity(GetParam().text, GetParam().dimension), GetParam().internal) << GetParam().text;
}

// The internal units are mm, N, s, t; the factors follow from the prefixes of the SI.
INSTANTIATE_TEST_SUITE_P(
    Units, QuantityTest,
    testing::Values(
        Written{"0.12 mm", Dimension::length, 0.12}, Written{"120 um", Dimension::length, 0.12},
        Written{"120 µm", Dimension::length, 0.12}, Written{"0.7 cm", Dimension::length, 7},
        Written{"-1 m", Dimension::length, -1000}, Written{"0.02 /mm", Dimension::inverse_length, 0.02},
        Written{"0.02 1/mm", Dimension::inverse_length, 0.02}, Written{"0.02 mm^-1", Dimension::inverse_length, 0.02},
        Written{"20 /m", Dimension::inverse_length, 0.02}, Written{"1700 MPa", Dimension::pressure, 1700},
        Written{"1.7 GPa", Dimension::pressure, 1700}, Written{"1700 N/mm²", Dimension::pressure, 1700},
        Written{"1140 kg/m^3", Dimension::density, 1.14e-9}, Written{"1140 kg/m³", Dimension::density, 1.14e-9},
        Written{"2 g/cm^3", Dimension::density, 2e-9}, Written{"5 mm/s", Dimension::speed, 5},
        Written{"300 mm/min", Dimension::speed, 5}, Written{"0.5 s", Dimension::time, 0.5},
        Written{"500ms", Dimension::time, 0.5}, Written{"3 /min", Dimension::inverse_time, 0.05},
        Written{"250 cN", Dimension::force, 2.5}, Written{"0.5 N mm^2", Dimension::bending_stiffness, 0.5},
        Written{"0.5 N*mm^2", Dimension::bending_stiffness, 0.5},
        Written{"0.5 N·mm²", Dimension::bending_stiffness, 0.5},
        Written{"0.5 N mm2", Dimension::bending_stiffness, 0.5}, Written{"2 N m^2", Dimension::bending_stiffness, 2e6},
        Written{"16 N/mm", Dimension::stiffness, 16}, Written{"16000 N/m", Dimension::stiffness, 16},
        Written{"20 tex", Dimension::linear_density, 20e-12}, Written{"200 dtex", Dimension::linear_density, 20e-12},
        Written{"180 den", Dimension::linear_density, 20e-12}, Written{"20 g/m", Dimension::linear_density, 20e-9},
        Written{" +1.5e-1 mm ", Dimension::length, 0.15}, Written{"0.1", Dimension::number, 0.1}));

TEST(Quantity, WithoutUnitIsRefusedWithTheUnitsThatFit) {
  EXPECT_EQ(message_of("7", Dimension::length),
            "\"7\" has no unit; write a length as a number and a unit, one of mm, um, cm, m");
}

TEST(Quantity, WithAUnitOfAnotherDimensionSaysWhatThatMeasures) {
  const std::string message = message_of("7 MPa", Dimension::length);
  EXPECT_THAT(message, HasSubstr("\"MPa\", which is for a pressure or modulus"));
  EXPECT_THAT(message, HasSubstr("mm, um, cm, m"));
}

TEST(Quantity, WithAnUnknownUnitNamesTheUnitsThatFit) {
  EXPECT_THAT(message_of("7 inch", Dimension::length), HasSubstr("has the unit \"inch\"; write a length"));
}

TEST(Quantity, DistinguishesCapitalLettersInUnits) {
  EXPECT_THAT(message_of("1700 mpa", Dimension::pressure), HasSubstr("MPa"));
}

TEST(Quantity, WithADecimalCommaIsRefusedByName) {
  EXPECT_THAT(message_of("0,12 mm", Dimension::length), HasSubstr("decimal point"));
}

TEST(Quantity, MustBeFinite) {
  EXPECT_THAT(message_of("nan mm", Dimension::length), HasSubstr("finite number"));
  EXPECT_THAT(message_of("inf mm", Dimension::length), HasSubstr("finite number"));
  EXPECT_THAT(message_of("1e999 mm", Dimension::length), HasSubstr("finite number"));
  EXPECT_THAT(message_of("1e307 m", Dimension::length), HasSubstr("too large"));
}

TEST(Quantity, MustBeginWithANumber) {
  EXPECT_THAT(message_of("", Dimension::length), HasSubstr("finite number"));
  EXPECT_THAT(message_of("mm", Dimension::length), HasSubstr("finite number"));
  EXPECT_THAT(message_of("+-1 mm", Dimension::length), HasSubstr("finite number"));
}

TEST(Quantity, WithAUnitWhereAPureNumberIsDueIsRefused) {
  EXPECT_THAT(message_of("22 %", Dimension::number), HasSubstr("pure number"));
}

TEST(Quantity, IsWrittenInTheFirstUnitOfItsDimension) {
  EXPECT_EQ(format_quantity(0.12, Dimension::length), "0.12 mm");
  EXPECT_EQ(format_quantity(1.14e-9, Dimension::density), "1140 kg/m^3");
  EXPECT_EQ(format_quantity(1700, Dimension::pressure), "1700 MPa");
  EXPECT_EQ(format_quantity(0.1, Dimension::number), "0.1");
  EXPECT_EQ(format_quantity(0, Dimension::inverse_time), "0 /s");
}

TEST(Quantity, ComesBackFromTextWithTheSameBits) {
  // Given values of every size, when each is written and read again, then not one bit has changed.
  std::mt19937_64 random(20240501);
  std::uniform_real_distribution<double> exponent(-200, 200);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    for (const Dimension dimension : {Dimension::number, Dimension::length, Dimension::density, Dimension::speed}) {
      const std::string text = format_quantity(value, dimension);
      ASSERT_EQ(parse_quantity(text, dimension), value) << text;
    }
  }
}

}  // namespace
}  // namespace knitmech::base
