#include "base/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace knitmech::base {

std::string duration_text(double seconds) {
  constexpr long kMinute = 60;
  constexpr long kHour = 3600;
  const long whole = std::lround(std::max(seconds, 0.0));
  if (whole < kMinute) return fmt::format("{} s", whole);
  if (whole < kHour) return fmt::format("{} min {} s", whole / kMinute, whole % kMinute);
  return fmt::format("{} h {} min", whole / kHour, whole % kHour / kMinute);
}

std::string percent_text(double ratio) {
  return fmt::format("{:.3g} %", 100 * ratio);
}

std::string force_text(double force) {
  constexpr double kLeastInNewton = 0.1;
  return std::abs(force) < kLeastInNewton ? fmt::format("{:.3g} mN", 1000 * force) : fmt::format("{:.3g} N", force);
}

std::string per_width_text(double force) {
  return force_text(force) + "/mm";
}

}  // namespace knitmech::base
