#include "exchange/yarn_samples.h"

#include <algorithm>
#include <cmath>

#include "exchange/constants.h"

namespace knitmech::exchange {
namespace {

using model::CurvePiece;

Eigen::Vector3d mirrored(const Eigen::Vector3d& vector, const Eigen::Vector3d& normal, double squared_length) {
  return squared_length > 0 ? Eigen::Vector3d(vector - (2 * vector.dot(normal) / squared_length) * normal) : vector;
}

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

Eigen::Vector3d carried_across(const Eigen::Vector3d& across, const YarnSample& from, const YarnSample& to) {
  const Eigen::Vector3d chord = to.point - from.point;
  const double chord_squared = chord.squaredNorm();
  const Eigen::Vector3d across_there = mirrored(across, chord, chord_squared);
  const Eigen::Vector3d tangent_there = mirrored(from.tangent, chord, chord_squared);
  const Eigen::Vector3d turn = to.tangent - tangent_there;
  const Eigen::Vector3d result = mirrored(across_there, turn, turn.squaredNorm());
  return (result - result.dot(to.tangent) * to.tangent).normalized();  // rounding does not add up
}

}  // namespace knitmech::exchange
