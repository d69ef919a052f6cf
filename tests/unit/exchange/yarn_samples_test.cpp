#include "exchange/yarn_samples.h"

#include <gtest/gtest.h>

#include "exchange/constants.h"
#include "yarn_rows.h"

namespace knitmech::exchange {
namespace {

using model::CurvePiece;

/// The farthest that chords between samples are from the curve, by looking at it closely.
double largest_chord_error(YarnRow row, const std::vector<YarnSample>& samples) {
  constexpr int kLooks = 64;
  double largest = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const YarnSample& from = samples[i];
    const double end = samples[i + 1].piece == from.piece ? samples[i + 1].parameter : 1;
    const Eigen::Vector3d chord = (samples[i + 1].point - from.point).normalized();
    for (int k = 1; k < kLooks; ++k) {
      const double u = from.parameter + (end - from.parameter) * k / kLooks;
      const Eigen::Vector3d away = row[from.piece].point(u) - from.point;
      largest = std::max(largest, (away - away.dot(chord) * chord).norm());
    }
  }
  return largest;
}

TEST(YarnSamples, GivenAStraightYarn_ThenTheyAreItsNodes) {
  const std::vector<CurvePiece> pieces = straight_pieces();
  const std::vector<YarnSample> samples = samples_of(pieces);
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_EQ(samples[3].point, pieces[2].end);
  EXPECT_EQ(samples[3].piece, 2U);
  EXPECT_EQ(samples[3].parameter, 1);
  EXPECT_TRUE(samples[1].tangent.isApprox(Eigen::Vector3d(1, 2, 2) / 3, 1e-12));
}

TEST(YarnSamples, GivenABend_ThenTheChordsAreAsNearAsTheBoundSays) {
  for (const double radius : {0.01, 0.06, 0.3}) {
    const std::vector<CurvePiece> pieces = helix_pieces(1, 0.2, 1, radius, 8);
    const std::vector<YarnSample> samples = samples_of(pieces);
    const double error = largest_chord_error(pieces, samples);
    EXPECT_LE(error, kChordErrorShare * radius);
    EXPECT_GE(error, kChordErrorShare * radius / 4) << "no more points than are of use: one step less of few is coarse";
  }
}

TEST(YarnSamples, GivenAYarnWithoutThickness_ThenTheStepsEndSomewhere) {
  std::vector<CurvePiece> pieces = helix_pieces(1, 0, 1, 1e-30);
  EXPECT_EQ(steps_of(pieces[0]), kMostStepsPerElement);
}

TEST(YarnSamples, GivenANumberOfSteps_ThenEveryElementHasThem) {
  const std::vector<CurvePiece> pieces = straight_pieces();
  const std::vector<YarnSample> samples = samples_of(pieces, 4);
  ASSERT_EQ(samples.size(), 13U);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d expected = static_cast<double>(i) / 12 * pieces[2].end;
    EXPECT_LT((samples[i].point - expected).norm(), 1e-14) << i;
  }
}

TEST(YarnRows, GivenABreak_ThenThereAreTwo) {
  std::vector<CurvePiece> pieces = helix_pieces(1, 0, 1, 0.1);
  EXPECT_EQ(yarn_rows(pieces).size(), 1U);
  pieces[10].continues_piece_before = false;
  const std::vector<YarnRow> rows = yarn_rows(pieces);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].size(), 10U);
  EXPECT_EQ(rows[1].size(), pieces.size() - 10);
  EXPECT_EQ(yarn_rows({}).size(), 0U);
}

}  // namespace
}  // namespace knitmech::exchange
