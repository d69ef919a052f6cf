#include "exchange/abaqus_deck.h"

namespace knitmech::exchange {

double AbaqusDeck::Amplitude::value(double time) const {
  if (points.empty()) return 0;
  if (time <= points.front().first) return points.front().second;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [time_a, value_a] = points[i - 1];
    const auto [time_b, value_b] = points[i];
    if (time <= time_b) return value_a + (value_b - value_a) * (time - time_a) / (time_b - time_a);
  }
  return points.back().second;
}

}  // namespace knitmech::exchange
