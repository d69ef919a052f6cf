#include "picture/contact_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <vector>

#include "../../support/straight_yarn.h"
#include "base/errors.h"

namespace knitmech::picture {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Disc {
  double x, y, radius;
  bool slips;
};

/// The filled discs of a map, in their order: those of the legend first.
std::vector<Disc> discs(const std::string& svg) {
  static const std::regex kDisc{"<circle cx=\"([\\d.]+)\" cy=\"([\\d.]+)\" r=\"([\\d.]+)\" fill=\"#(0072b2|e69f00)\""};
  std::vector<Disc> found;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), kDisc); it != std::sregex_iterator(); ++it) {
    found.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), (*it)[4] == "e69f00"});
  }
  return found;
}

class ContactMap : public testing::Test {
 protected:
  const model::Model model_ = test::straight_yarn();
  model::Frame frame_ = test::undeformed(model_);

  void add_contact(double x, double y, double force, bool slips) {
    model::ContactRecord contact;
    contact.position = {x, y, 0.3};
    contact.normal_force = force;
    contact.slips = slips;
    frame_.contacts.push_back(contact);
  }
};

TEST_F(ContactMap, ShowsEachContactAtItsPlaceWithAnAreaLikeItsForce) {
  // Given three contacts, of 0.01 N, 0.04 N and 0.02 N, the second one slips.
  add_contact(0, 2, 0.01, false);
  add_contact(1, 6, 0.04, true);
  add_contact(0, 10, 0.02, false);
  const std::vector<Disc> found = discs(contact_map_svg(model_, frame_, "22 % strain"));
  // Then behind the two of the legend they stand in the order of their forces.
  ASSERT_EQ(found.size(), 2 + 3U);
  const Disc &large = found[2], &middle = found[3], &small = found[4];
  EXPECT_TRUE(large.slips);
  EXPECT_FALSE(middle.slips);
  EXPECT_NEAR(large.radius / small.radius, 2, 0.02);
  EXPECT_NEAR(large.radius / middle.radius, std::sqrt(2.0), 0.02);
  // And lengths are as in the fabric: 4 mm up are four times 1 mm to the right.
  EXPECT_GT(small.y, large.y) << "y points upwards";
  EXPECT_NEAR(small.y - large.y, 4 * (large.x - small.x), 0.1);
  EXPECT_NEAR(small.y - middle.y, 2 * (small.y - large.y), 0.1);
}

TEST_F(ContactMap, TheLegendCountsAndHasADiscOfARoundForce) {
  add_contact(0, 2, 0.045, false);
  add_contact(0, 4, 0.01, true);
  add_contact(0, 6, 0.01, true);
  const std::string svg = contact_map_svg(model_, frame_, "5 % strain, <1 mN");
  EXPECT_THAT(svg, HasSubstr(">stick: 1<"));
  EXPECT_THAT(svg, HasSubstr(">slip: 2<"));
  EXPECT_THAT(svg, HasSubstr(">20 mN<"));
  EXPECT_THAT(svg, HasSubstr(">5 % strain, &lt;1 mN<"));
  // The disc of 20 mN is to that of 45 mN as the roots of the forces.
  static const std::regex kReference{"r=\"([\\d.]+)\" fill=\"none\""};
  std::smatch reference;
  ASSERT_TRUE(std::regex_search(svg, reference, kReference));
  EXPECT_NEAR(std::stod(reference[1]) / discs(svg)[2].radius, std::sqrt(20.0 / 45.0), 0.01);
}

TEST_F(ContactMap, LinesHaveOnlyThePointsThatTheyNeed) {
  // Given a straight yarn, then two points are enough.
  static const std::regex kLine{"<polyline points=\"[\\d.,]+ [\\d.,]+\" "};
  EXPECT_TRUE(std::regex_search(contact_map_svg(model_, frame_, ""), kLine));
}

TEST_F(ContactMap, LeavesOutWhatIsNotFinite) {
  add_contact(std::numeric_limits<double>::quiet_NaN(), 2, 0.01, false);
  add_contact(0, 2, std::numeric_limits<double>::infinity(), false);
  const std::string svg = contact_map_svg(model_, frame_, "");
  EXPECT_THAT(svg, HasSubstr("no contact bears a force"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_TRUE(discs(svg).empty());
}

TEST_F(ContactMap, AFrameWithoutAnyKnownPositionIsAnInputError) {
  for (Eigen::Vector3d& point : frame_.points) point.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(static_cast<void>(contact_map_svg(model_, frame_, "")), InputError);
}

}  // namespace
}  // namespace knitmech::picture
