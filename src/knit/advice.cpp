#include "knit/advice.h"

#include <fmt/format.h>

#include <cmath>

namespace knitmech::knit {
namespace {

/// Size of one unit in the fourth digit of a value.
double fourth_digit(double value) {
  return std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
}

}  // namespace

std::string at_least(double value) {
  if (value == 0) return "0";
  const double unit = fourth_digit(value);
  return fmt::format("{:.5g}", std::ceil(value / unit * (1 - 1e-12)) * unit);
}

std::string at_most(double value) {
  if (value == 0) return "0";
  const double unit = fourth_digit(value);
  return fmt::format("{:.5g}", std::floor(value / unit * (1 + 1e-12)) * unit);
}

}  // namespace knitmech::knit
