#include "knit/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "base/segment_distance.h"
#include "example_loop.h"
#include "knit/constants.h"
#include "knit/fabric_builder.h"

namespace knitmech::knit {
namespace {

std::optional<Approach> find(const std::vector<Approach>& approaches, Neighbours kind) {
  const auto found = std::find_if(approaches.begin(), approaches.end(),
                                  [&](const Approach& approach) { return approach.neighbours == kind; });
  if (found == approaches.end()) return std::nullopt;
  return *found;
}

std::vector<Approach> approaches_of(const FabricLayout& layout, int pieces = kCurvePieces) {
  return closest_approaches(make_erc(layout.loop), layout, kExampleDiameter, pieces);
}

double segment_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& a_end, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& b_end) {
  const Eigen::Vector3d u = a_end - a;
  const Eigen::Vector3d v = b_end - b;
  const ClosestPoints at =
      closest_points({a.x(), a.y(), a.z()}, {u.x(), u.y(), u.z()}, {b.x(), b.y(), b.z()}, {v.x(), v.y(), v.z()});
  return (a + at.s * u - b - at.t * v).norm();
}

/// Least distance of two yarns over all pairs of their elements, without any use of periodicity.
double distance_by_force(const YarnCurve& a, const YarnCurve& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < a.points.size(); ++i) {
    for (std::size_t j = 0; j + 1 < b.points.size(); ++j) {
      least = std::min(least, segment_distance(a.points[i], a.points[i + 1], b.points[j], b.points[j + 1]));
    }
  }
  return least;
}

class ElementsPerErc : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(StandardMeshes, ElementsPerErc, testing::Values(10, 20, 30));

TEST_P(ElementsPerErc, GapOfTheNextCourseIsThatOfAllPairsOfElements) {
  // Given a fabric of 4 x 2 stitches, the 3 x 3 stitches of the search give what trying every pair gives.
  FabricLayout layout = example_layout();
  layout.wales = 4;
  layout.courses = 2;
  layout.elements_per_erc = GetParam();
  const Fabric fabric = build_fabric(layout);
  const auto next = find(approaches_of(layout, GetParam()), Neighbours::next_course);
  ASSERT_TRUE(next);
  EXPECT_NEAR(next->gap, distance_by_force(fabric.yarns[0], fabric.yarns[1]) - kExampleDiameter, 1e-12);
}

TEST(Clearance, GapOfFurtherCoursesIsThatOfAllPairsOfElements) {
  // Given courses so close that the second neighbour reaches down between the loops, T = 3 mm with H = 7 mm.
  FabricLayout layout = example_layout();
  layout.wales = 4;
  layout.courses = 3;
  layout.course_spacing = 3;
  const Fabric fabric = build_fabric(layout);
  const auto further = find(approaches_of(layout, 10), Neighbours::further_course);
  ASSERT_TRUE(further);
  EXPECT_NEAR(further->gap, distance_by_force(fabric.yarns[0], fabric.yarns[2]) - kExampleDiameter, 1e-12);
  EXPECT_EQ(further->b.course - further->a.course, 2);
}

TEST(Clearance, OfNeighbouringHeadsIsTheSpaceBetweenThem) {
  // Given heads 2 (l1 + R1) = 2.6 mm wide in stitches of 3.9 mm, 3.9 - 2.6 - 0.12 mm is left at the same height.
  const auto wale = find(approaches_of(example_layout()), Neighbours::next_wale);
  ASSERT_TRUE(wale);
  EXPECT_NEAR(wale->gap, 3.9 - 2.6 - 0.12, 1e-4);
  EXPECT_EQ(wale->a.piece, ErcPiece::head_arc);
  EXPECT_EQ(wale->b.piece, ErcPiece::head_arc);
  EXPECT_EQ(std::abs(wale->a.wale - wale->b.wale), 1);
  EXPECT_GE(std::min(wale->a.wale, wale->b.wale), 0);
}

TEST(Clearance, WithinALoopIsTheSpaceBetweenItsLegs) {
  // Given feet 2 (l2 + R2) = 2.4 mm wide, the loop narrows to 3.9 - 2.4 mm between its own foot arcs.
  const auto loop = find(approaches_of(example_layout()), Neighbours::same_loop);
  ASSERT_TRUE(loop);
  EXPECT_NEAR(loop->gap, 3.9 - 2.4 - 0.12, 1e-4);
  EXPECT_NEAR(loop->point.x(), 0, 1e-3);
  EXPECT_EQ(loop->a.piece, ErcPiece::foot_arc);
  EXPECT_EQ(loop->a.wale, loop->b.wale);
}

TEST(Clearance, FindsALoopThatTouchesItself) {
  // Given feet so wide that the legs of one loop overlap by 0.02 mm at its neck: 3.9 - 2 (0.2 + R2) = 0.1.
  FabricLayout layout = example_layout();
  layout.loop.foot_radius = 1.7;
  const auto loop = find(approaches_of(layout), Neighbours::same_loop);
  ASSERT_TRUE(loop);
  EXPECT_NEAR(loop->gap, -0.02, 1e-4);
}

TEST(Clearance, FindsLoopsOfNeighbouringWalesThatTouch) {
  FabricLayout layout = example_layout();
  layout.loop.head_radius = 1.7;
  const auto wale = find(approaches_of(layout), Neighbours::next_wale);
  ASSERT_TRUE(wale);
  EXPECT_NEAR(wale->gap, -0.02, 1e-4);
}

TEST(Clearance, AnArcOfTheYarnItselfIsNoOverlap) {
  // Given tight arcs of the yarn's own diameter, the yarn does not overlap itself where it merely bends.
  FabricLayout layout = example_layout();
  layout.loop.head_radius = kExampleDiameter;
  layout.loop.foot_radius = kExampleDiameter;
  layout.courses = 1;
  const auto least = least_gap(approaches_of(layout));
  ASSERT_TRUE(least);
  EXPECT_GT(least->gap, 0);
}

TEST(Clearance, NeverFallsAsTheLoopGetsDeeper) {
  FabricLayout layout = example_layout();
  double before = -kExampleDiameter;
  for (const double p : {0.005, 0.01, 0.02, 0.04, 0.08}) {
    layout.loop.out_of_plane = p;
    const double gap = find(approaches_of(layout), Neighbours::next_course).value().gap;
    EXPECT_GT(gap, before);
    before = gap;
  }
}

TEST(Clearance, FlatCoursesCrossEachOther) {
  FabricLayout layout = example_layout();
  layout.loop.out_of_plane = 0;
  EXPECT_NEAR(find(approaches_of(layout), Neighbours::next_course).value().gap, -kExampleDiameter, 1e-12);
}

TEST(Clearance, OnlyNeighboursThatTheFabricHasCount) {
  FabricLayout layout = example_layout();
  layout.wales = 1;
  layout.courses = 1;
  const auto approaches = approaches_of(layout);
  EXPECT_FALSE(find(approaches, Neighbours::next_course));
  EXPECT_FALSE(find(approaches, Neighbours::next_wale));
  EXPECT_TRUE(find(approaches, Neighbours::same_loop));
}

TEST(Clearance, DoesNotDependOnTheSizeOfALargeFabric) {
  FabricLayout large = example_layout();
  large.wales = 300;
  large.courses = 300;
  EXPECT_EQ(least_gap(approaches_of(large)).value().gap, least_gap(approaches_of(example_layout())).value().gap);
}

TEST(Clearance, PlaceLiesHalfWayBetweenTheTwoYarns) {
  // Given the crossing of the head of course 1 with the leg of course 2, the place lies between the two curves in z.
  const auto next = find(approaches_of(example_layout()), Neighbours::next_course).value();
  EXPECT_EQ(next.a.course, 0);
  EXPECT_EQ(next.b.course, 1);
  const double y = next.point.y();
  const double z_lower = -0.02 * y * y;
  const double z_upper = -0.02 * (y - 5) * (y - 5);
  EXPECT_NEAR(next.point.z(), 0.5 * (z_lower + z_upper), 0.01);
}

TEST(Clearance, LeastGapOfNothingIsNothing) {
  EXPECT_FALSE(least_gap({}));
}

TEST(Clearance, PlacesAreDescribedFromOne) {
  EXPECT_EQ(describe(Place{.course = 0, .wale = 2, .piece = ErcPiece::foot_arc}), "the foot arc of course 1, wale 3");
}

}  // namespace
}  // namespace knitmech::knit
