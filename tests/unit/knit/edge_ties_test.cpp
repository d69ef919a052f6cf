#include "knit/edge_ties.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "example_loop.h"
#include "knit/fabric_builder.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

FabricLayout layout_of(int wales, int courses) {
  FabricLayout layout = example_layout();
  layout.wales = wales;
  layout.courses = courses;
  layout.structure = Structure::tied;
  return layout;
}

/// The point of the true centreline: half stitches run in turn from foot to head and from head to foot.
Vector3d point_of(const Erc& erc, const FabricLayout& layout, const PlaceOnYarn& place) {
  const int wale = static_cast<int>(place.arc_length / (2 * erc.length));
  const double from_head = place.arc_length - (2 * wale + 1) * erc.length;
  Vector3d point = point_at_arc_length(erc, std::abs(from_head)).position;
  if (from_head < 0) point.x() *= -1;
  return point + Vector3d(wale * layout.loop.width, place.yarn * layout.course_spacing, 0);
}

struct TiedPoints {
  YarnTie tie;
  Vector3d lower, upper;
};

std::vector<TiedPoints> tied_points(const FabricLayout& layout) {
  const Erc erc = make_erc(layout.loop);
  std::vector<TiedPoints> points;
  for (const YarnTie& tie : edge_ties(erc, layout)) {
    points.push_back({tie, point_of(erc, layout, tie.lower), point_of(erc, layout, tie.upper)});
  }
  return points;
}

TEST(EdgeTies, GivenAFabric_ThenBothPlacesOfATieLieAboveEachOther) {
  // Straight pieces of an ERC of 8.65 mm in 128 leave an arc of R >= 1 mm by at most h^2 / (8 R) = 0.0006 mm each; the
  // yarns cross at some 30 degrees and more, so the crossing is off by no more than a few times that.
  for (const TiedPoints& tied : tied_points(layout_of(4, 3))) {
    EXPECT_LT((tied.lower - tied.upper).head<2>().norm(), 0.002);
    EXPECT_GT(std::abs(tied.lower.z() - tied.upper.z()), kExampleDiameter);
  }
}

TEST(EdgeTies, GivenAFabric_ThenEachEdgeStitchIsTiedToTheCourseAboveAtFourPlacesAndNoOtherStitch) {
  const FabricLayout layout = layout_of(4, 3);
  std::map<std::pair<int, int>, int> ties_of_stitch;  // course, wale
  for (const TiedPoints& tied : tied_points(layout)) {
    EXPECT_EQ(tied.tie.upper.yarn, tied.tie.lower.yarn + 1);
    const int wale = static_cast<int>(std::lround(0.5 * (tied.lower.x() + tied.upper.x()) / layout.loop.width));
    ++ties_of_stitch[{tied.tie.lower.yarn, wale}];
  }
  const std::map<std::pair<int, int>, int> expected = {{{0, 0}, 4}, {{0, 3}, 4}, {{1, 0}, 4}, {{1, 3}, 4}};
  EXPECT_EQ(ties_of_stitch, expected);
}

TEST(EdgeTies, GivenPlainJersey_ThenTheUpperYarnLiesInFrontAtTheHeadAndTheLowerAtTheFeet) {
  // As the interlocking of jersey asks for: two crossings of either kind in every stitch.
  int upper_in_front = 0, lower_in_front = 0;
  for (const TiedPoints& tied : tied_points(layout_of(1, 2))) {
    const double above_mid_height = tied.lower.y() - 0.5 * 5.0;  // of both courses together
    EXPECT_EQ(tied.upper.z() > tied.lower.z(), above_mid_height > 0) << tied.lower.transpose();
    ++(tied.upper.z() > tied.lower.z() ? upper_in_front : lower_in_front);
  }
  EXPECT_EQ(upper_in_front, 2);
  EXPECT_EQ(lower_in_front, 2);
}

TEST(EdgeTies, GivenAFabric_ThenTheLeftAndTheRightEdgeAreMirrorImages) {
  const FabricLayout layout = layout_of(5, 2);
  const double middle = 0.5 * (layout.wales - 1) * layout.loop.width;
  const std::vector<TiedPoints> all = tied_points(layout);
  for (const TiedPoints& tied : all) {
    int mirrors = 0;
    for (const TiedPoints& other : all) {
      const auto mirrored = [&](Vector3d point) {
        point.x() = 2 * middle - point.x();
        return point;
      };
      const bool is_mirror =
          (mirrored(tied.lower) - other.lower).norm() < 1e-12 && (mirrored(tied.upper) - other.upper).norm() < 1e-12;
      mirrors += is_mirror ? 1 : 0;
    }
    EXPECT_EQ(mirrors, 1) << tied.lower.transpose();
  }
}

TEST(EdgeTies, GivenAnotherMesh_ThenThePlacesAreTheSame) {
  const Erc erc = make_erc(example_loop());
  FabricLayout coarse = layout_of(3, 3);
  FabricLayout fine = coarse;
  fine.elements_per_erc = 37;
  const std::vector<YarnTie> a = edge_ties(erc, coarse);
  const std::vector<YarnTie> b = edge_ties(erc, fine);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].lower.arc_length, b[i].lower.arc_length);
    EXPECT_EQ(a[i].upper.arc_length, b[i].upper.arc_length);
  }
}

TEST(EdgeTies, GivenOneWale_ThenItsOnlyStitchesAreTiedOnce) {
  EXPECT_EQ(tied_points(layout_of(1, 4)).size(), 3U * 4U);
}

TEST(EdgeTies, GivenOneCourse_ThenThereIsNothingToTie) {
  EXPECT_TRUE(tied_points(layout_of(4, 1)).empty());
}

TEST(EdgeTies, GivenTheStructures_ThenOnlyATiedFabricHasThem) {
  FabricLayout layout = layout_of(4, 3);
  EXPECT_EQ(build_fabric(layout).ties.size(), 2U * 2U * 4U);
  for (const Structure structure : {Structure::basic, Structure::adjusted}) {
    layout.structure = structure;
    EXPECT_TRUE(build_fabric(layout).ties.empty());
  }
}

}  // namespace
}  // namespace knitmech::knit
