#include "curves/write_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "base/errors.h"

namespace knitmech::curves {
namespace {

template <typename Number>
Number at(const std::string& bytes, std::size_t place) {
  Number value{};
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

Eigen::Vector3d point(const std::string& bytes, std::size_t place) {
  return {at<float>(bytes, place), at<float>(bytes, place + 4), at<float>(bytes, place + 8)};
}

std::vector<YarnLine> two_yarns() {
  return {{.points = {{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0.25}}, .radius = 0.125},
          {.points = {{0, 3, 0}, {1, 3, 0}}, .radius = 0.125}};
}

TEST(CsvText, GivenTwoYarns_ThenOneLinePerPointWithTheYarnsNumberFromOne) {
  EXPECT_EQ(csv_text(two_yarns()),
            "yarn,x_mm,y_mm,z_mm,radius_mm\n"
            "1,0,0,0,0.125\n1,1,0.5,0,0.125\n1,2,0,0.25,0.125\n2,0,3,0,0.125\n2,1,3,0,0.125\n");
}

TEST(CsvText, GivenAYarnWithoutRadius_ThenThereIsNoSuchColumn) {
  std::vector<YarnLine> yarns = two_yarns();
  yarns[1].radius = 0;
  EXPECT_EQ(csv_text(yarns).substr(0, 20), "yarn,x_mm,y_mm,z_mm\n");
}

// The layout that cemyuksel.com/cyCodeBase/soln/using_bcc_files.html gives for the head and for each curve.
TEST(BccText, GivenTwoOpenYarns_ThenHeadAndCurvesStandWhereTheFormatSays) {
  const std::string bytes = bcc_text(two_yarns());
  EXPECT_EQ(bytes.substr(0, 3), "BCC");
  EXPECT_EQ(at<std::uint8_t>(bytes, 3), 0x44);
  EXPECT_EQ(bytes.substr(4, 2), "C0");
  EXPECT_EQ(at<std::uint8_t>(bytes, 6), 3);
  EXPECT_EQ(at<std::uint64_t>(bytes, 8), 2U);
  EXPECT_EQ(at<std::uint64_t>(bytes, 16), 9U);  // 3 + 2 and 2 + 2
  EXPECT_EQ(at<std::int32_t>(bytes, 64), 5);
  EXPECT_EQ(point(bytes, 68), Eigen::Vector3d(-1, -0.5, 0));  // the mirror of the second in the first
  EXPECT_EQ(point(bytes, 68 + 2 * 12), Eigen::Vector3d(1, 0.5, 0));
  EXPECT_EQ(point(bytes, 68 + 4 * 12), Eigen::Vector3d(3, -0.5, 0.5));
  EXPECT_EQ(at<std::int32_t>(bytes, 68 + 5 * 12), 4);
  EXPECT_EQ(bytes.size(), 64U + 2 * 4 + 9 * 12);
}

TEST(BccText, GivenAClosedYarn_ThenItsCountIsNegativeAndNoPointIsAdded) {
  const std::string bytes = bcc_text({{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .closed = true}});
  EXPECT_EQ(at<std::int32_t>(bytes, 64), -3);
  EXPECT_EQ(bytes.size(), 64U + 4 + 3 * 12);
}

// The chunks and their order are those of github.com/textiles-lab/smobj, README.md.
TEST(YarnsText, GivenTwoYarns_ThenTheChunksStandWhereTheFormatSays) {
  const std::string bytes = yarns_text(two_yarns());
  EXPECT_EQ(bytes.substr(0, 4), "f3..");
  EXPECT_EQ(at<std::uint32_t>(bytes, 4), 5U * 12);
  std::size_t place = 8 + 5 * 12;
  EXPECT_EQ(bytes.substr(place, 4), "src.");
  EXPECT_EQ(at<std::uint32_t>(bytes, place + 4), 5U * 4);
  place += 8 + 5 * 4;
  EXPECT_EQ(bytes.substr(place, 4), "yarn");
  EXPECT_EQ(at<std::uint32_t>(bytes, place + 4), 2U * 16);
  EXPECT_EQ(at<std::uint32_t>(bytes, place + 8 + 16), 3U);  // the second yarn's first point
  EXPECT_EQ(at<std::uint32_t>(bytes, place + 8 + 20), 5U);
  EXPECT_EQ(at<float>(bytes, place + 8 + 24), 0.125F);
  place += 8 + 2 * 16;
  EXPECT_EQ(bytes.substr(place, 9), std::string("strs\1\0\0\0", 8) + "1");
  place += 9;
  EXPECT_EQ(bytes.substr(place, 4), "unit");
  EXPECT_EQ(at<std::uint32_t>(bytes, place + 4), 12U);
  EXPECT_EQ(at<float>(bytes, place + 8 + 8), 1.0F);
  place += 8 + 12;
  EXPECT_EQ(bytes.substr(place), std::string("chk.\0\0\0\0", 8));
}

// An arc with the corner c between the middles of c's chords passes at half its parameter through
// (c_before + 6 c + c_after) / 8, by de Casteljau.
TEST(YarnsText, GivenPointsOnABend_ThenTheArcsOfAReaderPassThroughThem) {
  std::vector<YarnLine> yarns(1);
  for (int i = 0; i <= 20; ++i) {
    yarns[0].points.push_back({std::cos(0.3 * i), std::sin(0.3 * i), 0.1 * i});
  }
  const std::string bytes = yarns_text(yarns);
  const auto corner = [&](std::size_t i) { return point(bytes, 8 + 12 * i); };
  EXPECT_LT((corner(0) - yarns[0].points[0]).norm(), 1e-6);
  EXPECT_LT((corner(20) - yarns[0].points[20]).norm(), 1e-6);
  for (std::size_t i = 1; i < 20; ++i) {
    const Eigen::Vector3d on_arc = (corner(i - 1) + 6 * corner(i) + corner(i + 1)) / 8;
    EXPECT_LT((on_arc - yarns[0].points[i]).norm(), 1e-6) << i;  // 32-bit numbers near 1
    EXPECT_GT((corner(i) - yarns[0].points[i]).norm(), 1e-3) << i;
  }
}

TEST(YarnsText, GivenAClosedYarn_ThenItEndsWhereItBeginsAndItsArcsPassThroughItsPoints) {
  std::vector<YarnLine> yarns(1);
  yarns[0].closed = true;
  for (int i = 0; i < 7; ++i) {
    yarns[0].points.push_back({std::cos(2 * std::numbers::pi * i / 7), std::sin(2 * std::numbers::pi * i / 7), 0});
  }
  const std::string bytes = yarns_text(yarns);
  ASSERT_EQ(at<std::uint32_t>(bytes, 4), 8U * 12);
  const auto corner = [&](std::size_t i) { return point(bytes, 8 + 12 * i); };
  EXPECT_EQ(corner(7), corner(0));
  for (std::size_t i = 0; i < 7; ++i) {
    const Eigen::Vector3d on_arc = (corner((i + 6) % 7) + 6 * corner(i) + corner(i + 1)) / 8;
    EXPECT_LT((on_arc - yarns[0].points[i]).norm(), 1e-6) << i;
  }
}

TEST(BinaryTexts, GivenACoordinateBeyond32Bits_ThenItIsRefused) {
  const std::vector<YarnLine> yarns = {{.points = {{0, 0, 0}, {1e39, 0, 0}}}};
  EXPECT_THROW(static_cast<void>(bcc_text(yarns)), InputError);
  EXPECT_THROW(static_cast<void>(yarns_text(yarns)), InputError);
}

}  // namespace
}  // namespace knitmech::curves
