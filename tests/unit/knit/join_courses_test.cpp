#include "knit/join_courses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "base/errors.h"
#include "base/segment_distance.h"
#include "example_loop.h"
#include "knit/check_fabric.h"
#include "knit/erc.h"
#include "knit/fabric_builder.h"
#include "knit/out_of_plane.h"
#include "knit/turning_arc.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

FabricLayout layout_of(int courses, int elements_per_erc) {
  FabricLayout layout = example_layout();
  layout.wales = 3;
  layout.courses = courses;
  layout.elements_per_erc = elements_per_erc;
  return layout;
}

Fabric fabric_of(FabricLayout layout, Structure structure) {
  layout.structure = structure;
  return build_fabric(layout);
}

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// Node i of a course from the left in the joined yarn.
std::size_t node(const CourseNodes& course, int from_left) {
  return at(course.first_node + (course.runs_left ? course.n_nodes - 1 - from_left : from_left));
}

class JoinedCourses : public testing::TestWithParam<int> {
 protected:
  const FabricLayout layout_ = layout_of(4, GetParam());
  const Fabric basic_ = fabric_of(layout_, Structure::basic);
  const Fabric joined_ = fabric_of(layout_, Structure::adjusted);
  const YarnCurve& yarn_ = joined_.yarns.front();
};
INSTANTIATE_TEST_SUITE_P(Meshes, JoinedCourses, testing::Values(4, 10, 25));

TEST_P(JoinedCourses, AreOneYarnThatRunsToAndFro) {
  ASSERT_EQ(joined_.yarns.size(), 1U);
  ASSERT_EQ(joined_.courses.size(), 4U);
  const int in_arc = count_arc_elements(make_turning_arc(layout_), joined_.erc_length, GetParam());
  EXPECT_EQ(yarn_.points.size(), at(4 * (2 * GetParam() * 3 + 1) + 3 * (in_arc - 1)));
  for (std::size_t c = 0; c < 4; ++c) {
    const CourseNodes& course = joined_.courses[c];
    const Vector3d way = yarn_.points[at(course.first_node + course.n_nodes - 1)] - yarn_.points[at(course.first_node)];
    EXPECT_EQ(course.runs_left, c % 2 == 1);
    EXPECT_NEAR(way.x(), c % 2 == 1 ? -3 * 3.9 : 3 * 3.9, 1e-12);
    EXPECT_NEAR(way.y(), 0, 1e-12);
  }
}

TEST_P(JoinedCourses, HaveTheirNodesWhereTheyAreWithFreeEdges) {
  for (std::size_t c = 0; c < 4; ++c) {
    const YarnCurve& free = basic_.yarns[c];
    const CourseNodes& course = joined_.courses[c];
    const double side = course.runs_left ? -1 : 1;
    ASSERT_EQ(at(course.n_nodes), free.points.size());
    for (int i = 0; i < course.n_nodes; ++i) {
      const std::size_t here = node(course, i);
      EXPECT_EQ(yarn_.points[here], free.points[at(i)]);
      EXPECT_EQ(yarn_.tangents[here], side * free.tangents[at(i)]);
      EXPECT_EQ(yarn_.course[here], free.course[at(i)]);
      EXPECT_EQ(yarn_.wale[here], free.wale[at(i)]);
      EXPECT_EQ(yarn_.from_head[here], free.from_head[at(i)]);
      EXPECT_EQ(yarn_.from_foot[here], free.from_foot[at(i)]);
    }
    for (int i = 0; i + 1 < course.n_nodes; ++i) {
      const std::size_t element = std::min(node(course, i), node(course, i + 1));
      EXPECT_EQ(yarn_.middles[element], free.middles[at(i)]);
      EXPECT_EQ(yarn_.turns[element], 0);
    }
  }
}

TEST_P(JoinedCourses, HaveArcsThatBelongToTheLowerCourseAndToNoWale) {
  for (std::size_t i = 0; i < yarn_.points.size(); ++i) {
    if (yarn_.wale[i] != kNoWale) continue;
    const double y = yarn_.points[i].y();
    EXPECT_EQ(yarn_.course[i], static_cast<int>(std::floor((y + 3.5 + 1e-9) / 5)));
    EXPECT_EQ(yarn_.turns[i], 1);
    EXPECT_TRUE(std::isinf(yarn_.from_head[i]) && std::isinf(yarn_.from_foot[i]));
    // The first arc turns at the right edge, the next at the left.
    const bool at_right = yarn_.points[i].x() > 3.9;
    EXPECT_EQ(at_right, yarn_.course[i] % 2 == 0);
  }
  EXPECT_EQ(std::count(yarn_.wale.begin(), yarn_.wale.end(), kNoWale),
            std::count(yarn_.turns.begin(), yarn_.turns.end(), 1) - 3);
}

/// Distance from the outline of a turning arc: both straight pieces along x and, beyond l2 outside the edge, the points
/// that are R away from a straight line along y.
double off_the_arc(const Vector3d& point, const FabricLayout& layout) {
  const double edge = point.x() > 3.9 ? 2.5 * 3.9 : -0.5 * 3.9;
  const double outwards = std::abs(point.x() - edge);
  const double foot = std::floor((point.y() + 3.5 + 1e-9) / 5) * 5 - 3.5;
  const double up = point.y() - foot;
  const double flat = layout.loop.foot_flat, radius = layout.loop.foot_radius;
  if (outwards <= flat) return std::min(std::abs(up), std::abs(5 - up));
  const double on_axis = std::clamp(up, radius, 5 - radius);
  return std::abs(std::hypot(outwards - flat, up - on_axis) - radius);
}

TEST_P(JoinedCourses, HaveTheNodesAndMiddlesOfTheArcsOnTheTrueArcInThePlaneOfTheFeet) {
  const double foot_plane = -0.02 * 3.5 * 3.5;
  for (std::size_t i = 0; i < yarn_.points.size(); ++i) {
    if (yarn_.turns[i] == 0) continue;
    for (const Vector3d& point : {yarn_.points[i], yarn_.middles[i]}) {
      EXPECT_LT(off_the_arc(point, layout_), 1e-12) << point.transpose();
      EXPECT_NEAR(point.z(), foot_plane, 1e-12);
    }
    EXPECT_NEAR(yarn_.tangents[i].norm(), 1, 1e-14);
    // Amid two nodes: both halves are arcs of the same length, whose chords differ by their bends alone.
    const double before = (yarn_.middles[i] - yarn_.points[i]).norm();
    const double behind = (yarn_.points[i + 1] - yarn_.middles[i]).norm();
    const double half = 0.5 * (yarn_.arc_length[i + 1] - yarn_.arc_length[i]);
    EXPECT_LE(std::max(before, behind), half * (1 + 1e-12));
    EXPECT_GE(std::min(before, behind), half * (1 - half * half / 24));
  }
}

TEST_P(JoinedCourses, HaveAnArcLengthThatAscendsAndMatchesTheChords) {
  // A chord of an arc of length h and radius R is shorter by at most h^3 / (24 R^2); the loop's least radius is 1 mm.
  for (std::size_t i = 0; i + 1 < yarn_.points.size(); ++i) {
    const double arc = yarn_.arc_length[i + 1] - yarn_.arc_length[i];
    const double chord = (yarn_.points[i + 1] - yarn_.points[i]).norm();
    ASSERT_GT(arc, 0) << i;
    ASSERT_LE(chord, arc * (1 + 1e-12)) << i;
    ASSERT_GE(chord, arc - arc * arc * arc / 24 * 1.02) << i;
  }
  const double stitches = 4 * 3 * 2 * joined_.erc_length;
  EXPECT_NEAR(yarn_.arc_length.back(), stitches + 3 * (0.4 + std::numbers::pi + 3), 1e-11);
}

TEST(JoinCourses, GivenOneCourse_ThenItStaysAsItIs) {
  const Fabric joined = fabric_of(layout_of(1, 10), Structure::adjusted);
  const Fabric basic = fabric_of(layout_of(1, 10), Structure::basic);
  EXPECT_EQ(joined.yarns.front().points, basic.yarns.front().points);
  EXPECT_EQ(joined.yarns.front().arc_length, basic.yarns.front().arc_length);
}

/// A loop of any shape that makes a fabric without overlaps; empty if these numbers make none.
std::optional<FabricLayout> random_fabric(std::mt19937& random, double diameter) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  FabricLayout layout;
  layout.loop.height = between(3, 9);
  layout.loop.width = between(1.5, 5);
  layout.loop.head_radius = between(0.4, 1.5);
  layout.loop.foot_radius = between(0.4, 1.5);
  layout.loop.head_flat = between(0, 0.4);
  layout.loop.foot_flat = between(0, 0.4);
  layout.course_spacing = between(0.2, 0.95) * layout.loop.height;
  layout.wales = 2;
  layout.courses = 4;
  layout.elements_per_erc = 40;
  layout.structure = Structure::adjusted;
  try {
    layout.loop.out_of_plane = automatic_out_of_plane(layout, diameter);
    check_fabric(layout, diameter);
  } catch (const InputError&) {
    return std::nullopt;
  }
  return layout;
}

Vector3 plain(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// Least distance of the elements of the arcs to all other yarn, pair by pair. Yarn counts as other beyond the length
/// pi D / 2 along it: a yarn that bends no more tightly than its own thickness cannot come nearer than D before.
double least_distance_of_arcs(const YarnCurve& yarn, double diameter) {
  double least = std::numeric_limits<double>::infinity();
  const double apart = std::numbers::pi / 2 * diameter;
  for (std::size_t i = 0; i + 1 < yarn.points.size(); ++i) {
    if (yarn.turns[i] == 0) continue;
    for (std::size_t j = 0; j + 1 < yarn.points.size(); ++j) {
      const bool is_near =
          yarn.arc_length[j] < yarn.arc_length[i + 1] + apart && yarn.arc_length[j + 1] > yarn.arc_length[i] - apart;
      if (is_near) continue;
      const Vector3 a = plain(yarn.points[i]), along_a = plain(yarn.points[i + 1] - yarn.points[i]);
      const Vector3 b = plain(yarn.points[j]), along_b = plain(yarn.points[j + 1] - yarn.points[j]);
      const ClosestPoints at = closest_points(a, along_a, b, along_b);
      least = std::min(least, length(a + at.s * along_a - b - at.t * along_b));
    }
  }
  return least;
}

TEST(JoinCourses, GivenAnyLoopThatMakesAFabric_ThenTheArcsLieClearOfAllOtherYarn) {
  const double diameter = 0.15;
  std::mt19937 random(3);
  int tried = 0;
  for (int trial = 0; trial < 4000 && tried < 60; ++trial) {
    const std::optional<FabricLayout> layout = random_fabric(random, diameter);
    if (!layout) continue;
    ++tried;
    const Fabric fabric = build_fabric(*layout);
    EXPECT_GE(least_distance_of_arcs(fabric.yarns.front(), diameter), diameter)
        << "trial " << trial << ": H " << layout->loop.height << ", L " << layout->loop.width << ", T "
        << layout->course_spacing << " mm";
  }
  EXPECT_EQ(tried, 60);
}

}  // namespace
}  // namespace knitmech::knit
