#include "picture/side_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <sstream>
#include <vector>

#include "../../support/straight_yarn.h"
#include "base/errors.h"

namespace knitmech::picture {
namespace {

using testing::HasSubstr;

struct Place {
  double x, y;
};

/// The points of every line of a profile: yarns, then the lowest z, then the highest.
std::vector<std::vector<Place>> lines_of(const std::string& svg) {
  static const std::regex kLine{"<polyline points=\"([^\"]*)\""};
  std::vector<std::vector<Place>> lines;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), kLine); it != std::sregex_iterator(); ++it) {
    std::istringstream text((*it)[1].str());
    std::vector<Place> line;
    Place place{};
    char comma = ' ';
    while (text >> place.x >> comma >> place.y) line.push_back(place);
    lines.push_back(line);
  }
  return lines;
}

class SideProfile : public testing::Test {
 protected:
  const model::Model model_ = test::straight_yarn();
  model::Frame frame_ = test::undeformed(model_);
};

TEST_F(SideProfile, EnclosesAllYarnsBetweenItsLowestAndItsHighestLine) {
  // Given a yarn that is pushed out of plane by 1.5 mm at one node.
  frame_.points[10].z() += 1.5;
  const std::string svg = side_profile_svg(model_, frame_, "3 % strain");
  const auto lines = lines_of(svg);
  ASSERT_EQ(lines.size(), 3U);
  const auto& yarn = lines[0];
  const auto& highest = lines[2];
  const auto by_y = [](const Place& a, const Place& b) { return a.y < b.y; };
  // Then the highest line reaches as far as the yarn does, at the same place along it.
  const Place top_of_yarn = *std::min_element(yarn.begin(), yarn.end(), by_y);
  const Place top_of_line = *std::min_element(highest.begin(), highest.end(), by_y);
  EXPECT_NEAR(top_of_line.y, top_of_yarn.y, 0.2);
  EXPECT_NEAR(top_of_line.x, top_of_yarn.x, 800.0 / 150);
  EXPECT_THAT(svg, HasSubstr(">3 % strain<"));
  EXPECT_THAT(svg, HasSubstr(">z [mm]<"));
  EXPECT_THAT(svg, HasSubstr("times as large as y<"));
}

TEST_F(SideProfile, IsDrawnOfAFlatYarnToo) {
  EXPECT_EQ(lines_of(side_profile_svg(model_, frame_, "")).size(), 3U);
}

TEST_F(SideProfile, AFrameWithoutAnyKnownPositionIsAnInputError) {
  for (Eigen::Vector3d& point : frame_.points) point.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(static_cast<void>(side_profile_svg(model_, frame_, "")), InputError);
}

}  // namespace
}  // namespace knitmech::picture
