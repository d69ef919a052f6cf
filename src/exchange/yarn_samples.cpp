#include "exchange/yarn_samples.h"

#include <algorithm>
#include <cmath>

#include "exchange/constants.h"

namespace knitmech::exchange {
namespace {

using model::CurvePiece;

template <class StepsOf>
std::vector<YarnSample> sampled(YarnRow row, const StepsOf& steps_at) {
  std::vector<YarnSample> samples;
  const auto add = [&](std::size_t piece, double u) {
    samples.push_back({row[piece].point(u), row[piece].tangent(u), piece, u});
  };
  for (std::size_t piece = 0; piece < row.size(); ++piece) {
    const int steps = steps_at(row[piece]);
    for (int k = 0; k < steps; ++k) add(piece, static_cast<double>(k) / steps);
  }
  if (!row.empty()) add(row.size() - 1, 1);
  return samples;
}

}  // namespace

std::vector<YarnRow> yarn_rows(const std::vector<CurvePiece>& pieces) {
  std::vector<YarnRow> rows;
  for (auto first = pieces.begin(); first != pieces.end();) {
    const auto last =
        std::find_if(first + 1, pieces.end(), [](const CurvePiece& piece) { return !piece.continues_piece_before; });
    rows.emplace_back(first, last);
    first = last;
  }
  return rows;
}

int steps_of(const CurvePiece& piece) {
  const double bend = std::max(piece.second_derivative(0).norm(), piece.second_derivative(1).norm());
  const double steps = std::ceil(std::sqrt(bend / (8 * kChordErrorShare * piece.radius)));
  return static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(kMostStepsPerElement)));
}

std::vector<YarnSample> samples_of(YarnRow row) {
  return sampled(row, steps_of);
}

std::vector<YarnSample> samples_of(YarnRow row, int steps) {
  return sampled(row, [steps](const CurvePiece&) { return steps; });
}

}  // namespace knitmech::exchange
