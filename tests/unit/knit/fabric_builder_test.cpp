#include "knit/fabric_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/errors.h"
#include "example_loop.h"
#include "knit/erc.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

FabricLayout small_layout() {
  FabricLayout layout = example_layout();
  layout.wales = 3;
  layout.courses = 2;
  return layout;
}

long nodes_of(const Fabric& fabric) {
  long n = 0;
  for (const YarnCurve& yarn : fabric.yarns) n += static_cast<long>(yarn.points.size());
  return n;
}

struct Counts {
  int elements_per_erc;
  long elements;
  long nodes;
};

class StandardMesh : public testing::TestWithParam<Counts> {};
INSTANTIATE_TEST_SUITE_P(OfTheExample, StandardMesh,
                         testing::Values(Counts{10, 2700, 2715}, Counts{20, 5400, 5415}, Counts{30, 8100, 8115}));

TEST_P(StandardMesh, HasTheCountsOfNineWalesAndFifteenCourses) {
  FabricLayout layout = example_layout();
  layout.elements_per_erc = GetParam().elements_per_erc;
  const Fabric fabric = build_fabric(layout);
  EXPECT_EQ(fabric.yarns.size(), 15U);
  EXPECT_EQ(nodes_of(fabric), GetParam().nodes);
  EXPECT_EQ(nodes_of(fabric) - static_cast<long>(fabric.yarns.size()), GetParam().elements);
}

TEST(FabricBuilder, HeadMiddlesLieOnTheWalesAndFootMiddlesHalfWayBetween) {
  // Given 3 wales and N = 10, a course has its heads at nodes 10, 30, 50 and its feet at 0, 20, 40, 60.
  const Fabric fabric = build_fabric(small_layout());
  const double back = -0.02 * 3.5 * 3.5;
  for (int course = 0; course < 2; ++course) {
    const auto& points = fabric.yarns[static_cast<std::size_t>(course)].points;
    for (int wale = 0; wale < 3; ++wale) {
      const Vector3d head(3.9 * wale, 3.5 + 5.0 * course, back);
      EXPECT_LT((points[static_cast<std::size_t>(10 + 20 * wale)] - head).norm(), 1e-13);
    }
    for (int foot = 0; foot <= 3; ++foot) {
      const Vector3d middle(3.9 * (foot - 0.5), -3.5 + 5.0 * course, back);
      EXPECT_LT((points[static_cast<std::size_t>(20 * foot)] - middle).norm(), 1e-13);
    }
  }
}

TEST(FabricBuilder, EveryStitchIsItsOwnMirrorImage) {
  const YarnCurve yarn = build_fabric(small_layout()).yarns.front();
  for (std::size_t i = 0; i <= 10; ++i) {
    const Vector3d& left = yarn.points[30 - i];
    const Vector3d& right = yarn.points[30 + i];
    EXPECT_NEAR(left.x() + right.x(), 2 * 3.9, 1e-13);
    EXPECT_EQ(left.y(), right.y());
    EXPECT_EQ(left.z(), right.z());
  }
}

TEST(FabricBuilder, TangentsPointAlongTheYarn) {
  const YarnCurve yarn = build_fabric(small_layout()).yarns.back();
  for (std::size_t i = 1; i + 1 < yarn.points.size(); ++i) {
    const Vector3d along = (yarn.points[i + 1] - yarn.points[i - 1]).normalized();
    EXPECT_NEAR(yarn.tangents[i].norm(), 1, 1e-14);
    EXPECT_GT(yarn.tangents[i].dot(along), 0.9) << "node " << i;
  }
}

TEST(FabricBuilder, ChordsOfAFineMeshAreAsLongAsTheArc) {
  FabricLayout layout = small_layout();
  layout.elements_per_erc = 400;
  const YarnCurve yarn = build_fabric(layout).yarns.front();
  double chords = 0;
  for (std::size_t i = 0; i + 1 < yarn.points.size(); ++i) chords += (yarn.points[i + 1] - yarn.points[i]).norm();
  EXPECT_NEAR(chords, yarn.arc_length.back(), 1e-5 * chords);
}

TEST(FabricBuilder, MiddlesLieOnTheLoopHalfWayBetweenTheNodes) {
  const FabricLayout layout = small_layout();
  const Erc erc = make_erc(layout.loop);
  const YarnCurve yarn = build_fabric(layout).yarns.back();
  ASSERT_EQ(yarn.middles.size(), yarn.points.size());
  for (std::size_t i = 0; i + 1 < yarn.points.size(); ++i) {
    // Given N = 10, the yarn comes from a foot to the head of a wale in ten elements and goes on to the next foot in
    // ten, the mirror image.
    const std::size_t wale = i / 20;
    const double from_head = (static_cast<double>(i % 20) - 9.5) * erc.length / 10;
    Vector3d on_loop = point_at_arc_length(erc, std::abs(from_head)).position;
    if (from_head < 0) on_loop.x() *= -1;
    EXPECT_LT((yarn.middles[i] - on_loop - Vector3d(3.9 * static_cast<double>(wale), 5, 0)).norm(), 1e-12)
        << "element " << i;
  }
  EXPECT_EQ(yarn.middles.back(), yarn.points.back());
}

TEST(FabricBuilder, ArcLengthGrowsByTheSameStepFromNodeToNode) {
  const Fabric fabric = build_fabric(small_layout());
  const YarnCurve& yarn = fabric.yarns.front();
  EXPECT_NEAR(fabric.erc_length, 8.64887592209499603, 2e-14);
  for (std::size_t i = 0; i < yarn.arc_length.size(); ++i) {
    EXPECT_NEAR(yarn.arc_length[i], static_cast<double>(i) * fabric.erc_length / 10, 1e-12);
  }
}

TEST(FabricBuilder, DistancesToHeadAndFootAddUpToTheErc) {
  const Fabric fabric = build_fabric(small_layout());
  const YarnCurve& yarn = fabric.yarns.front();
  for (std::size_t i = 0; i < yarn.points.size(); ++i) {
    EXPECT_NEAR(yarn.from_head[i] + yarn.from_foot[i], fabric.erc_length, 1e-13);
  }
  EXPECT_EQ(yarn.from_foot[0], 0);
  EXPECT_EQ(yarn.from_head[10], 0);
  EXPECT_EQ(yarn.from_foot[20], 0);
  EXPECT_NEAR(yarn.from_head[13], 0.3 * fabric.erc_length, 1e-13);
  EXPECT_NEAR(yarn.from_head[8], 0.2 * fabric.erc_length, 1e-13);
}

TEST(FabricBuilder, ASharedFootNodeBelongsToTheWaleOnItsLeft) {
  const YarnCurve yarn = build_fabric(small_layout()).yarns.front();
  EXPECT_EQ(yarn.wale[0], 0);
  EXPECT_EQ(yarn.wale[20], 0);
  EXPECT_EQ(yarn.wale[21], 1);
  EXPECT_EQ(yarn.wale[40], 1);
  EXPECT_EQ(yarn.wale[60], 2);
}

TEST(FabricBuilder, CoursesAreTheSameCurveShiftedByTheSpacing) {
  const Fabric fabric = build_fabric(small_layout());
  const YarnCurve& lower = fabric.yarns[0];
  const YarnCurve& upper = fabric.yarns[1];
  EXPECT_THAT(lower.course, testing::Each(0));
  EXPECT_THAT(upper.course, testing::Each(1));
  for (std::size_t i = 0; i < lower.points.size(); ++i) {
    EXPECT_LT((upper.points[i] - lower.points[i] - Vector3d(0, 5, 0)).norm(), 1e-14);
  }
}

TEST(FabricBuilder, OneElementPerHalfLoopIsEnoughToBuild) {
  FabricLayout layout = small_layout();
  layout.elements_per_erc = 1;
  EXPECT_EQ(nodes_of(build_fabric(layout)), 2 * 1 * 3 * 2 + 2);
}

TEST(FabricBuilder, RefusesAFabricWithoutWalesCoursesOrElements) {
  for (int FabricLayout::*count : {&FabricLayout::wales, &FabricLayout::courses, &FabricLayout::elements_per_erc}) {
    FabricLayout layout = small_layout();
    layout.*count = 0;
    EXPECT_THROW((void)build_fabric(layout), InputError);
  }
}

}  // namespace
}  // namespace knitmech::knit
