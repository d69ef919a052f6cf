#include "run/time_left.h"

namespace knitmech::run {
namespace {

/// Share of the test between two marks, by which the time left is estimated.
constexpr double kMarkInterval = 0.05;

}  // namespace

void TimeLeft::update(double share, double seconds) {
  if (share < mark_.share + kMarkInterval) return;
  earlier_mark_ = mark_;
  mark_ = {share, seconds};
}

std::optional<double> TimeLeft::seconds_left(double share, double seconds) const {
  if (share <= earlier_mark_.share) return std::nullopt;
  return (seconds - earlier_mark_.seconds) * (1 - share) / (share - earlier_mark_.share);
}

}  // namespace knitmech::run
