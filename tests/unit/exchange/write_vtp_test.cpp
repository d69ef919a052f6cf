#include "exchange/write_vtp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "../../support/straight_yarn.h"
#include "deck_models.h"
#include "exchange/yarn_samples.h"
#include "results/vtk_reader.h"

namespace knitmech::exchange {
namespace {

results::VtkReader reader_of(const model::Model& model, const std::vector<model::CurvePiece>& pieces) {
  return {"yarns.vtp", vtp_text(model, pieces, 0.125)};
}

// The arrays of whole numbers are read in tests/geometry.
TEST(YarnLinesVtp, GivenAFabric_ThenEveryPointTellsItsPlaceOnTheYarn) {
  const model::Model model = model::build_model(fabric_case(3, 2));
  const std::vector<model::CurvePiece> pieces = model::yarn_curves(model);
  const results::VtkReader reader = reader_of(model, pieces);
  const std::size_t n = reader.n_points();
  ASSERT_EQ(reader.n_lines(), 2U);
  ASSERT_EQ(n, samples_of(yarn_rows(pieces)[0]).size() + samples_of(yarn_rows(pieces)[1]).size());
  EXPECT_EQ(reader.numbers("FieldData", "strain", 1)[0], 0.125);
  const auto points = reader.numbers("Points", "points_mm", 3 * n);
  const auto radii = reader.numbers("PointData", "tube_radius_mm", n);
  const auto arc_lengths = reader.numbers("PointData", "arc_length_mm", n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(radii[i], 0.06);
    if (i == 0 || arc_lengths[i] == 0) continue;
    // Between neighbours the yarn is as long as the way from one to the other, and a chord is a little shorter.
    const double way = std::hypot(points[3 * i] - points[3 * i - 3], points[3 * i + 1] - points[3 * i - 2],
                                  points[3 * i + 2] - points[3 * i - 1]);
    EXPECT_NEAR(way, arc_lengths[i] - arc_lengths[i - 1], 0.03 * way) << i;
  }
  EXPECT_NEAR(arc_lengths.back(), 6 * model.half_stitch_length, 1e-9) << "three stitches";
}

TEST(YarnLinesVtp, GivenAYarnThatWasMovedAndHasBroken_ThenItHasTwoLinesAndItsDisplacement) {
  const model::Model model = test::straight_yarn();
  model::Frame frame = test::undeformed(model);
  for (Eigen::Vector3d& point : frame.points) point += Eigen::Vector3d(1, 0.5, -2);
  frame.broken = {4};
  const results::VtkReader reader = reader_of(model, model::yarn_curves(model, frame));
  ASSERT_EQ(reader.n_points(), 11U);
  ASSERT_EQ(reader.n_lines(), 2U);
  EXPECT_EQ(reader.integers("Lines", "offsets", 2), (std::vector<std::int64_t>{5, 11}));
  const auto displacements = reader.numbers("PointData", "displacement_mm", 33);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_DOUBLE_EQ(displacements[3 * i], 1);
    EXPECT_DOUBLE_EQ(displacements[3 * i + 1], 0.5);
    EXPECT_DOUBLE_EQ(displacements[3 * i + 2], -2);
  }
}

}  // namespace
}  // namespace knitmech::exchange
