#include "curves/read_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/errors.h"
#include "curves/write_lines.h"

namespace knitmech::curves {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string with(std::string bytes, std::size_t place, auto value) {
  std::memcpy(bytes.data() + place, &value, sizeof value);
  return bytes;
}

std::string complaint_of(const std::function<YarnLines(std::string_view)>& parse, const std::string& bytes) {
  try {
    static_cast<void>(parse(bytes));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

/// Two wavy yarns whose coordinates 32 bits hold exactly.
std::vector<YarnLine> two_yarns() {
  return {{.points = {{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0.25}, {3, 0.5, 0}}, .radius = 0.125},
          {.points = {{0, 3, 0}, {1, 3.5, 0}, {2.5, 3, 0}}, .radius = 0.125}};
}

TEST(ParseCsv, GivenWhatCsvTextWrote_ThenTheSamePointsComeBackToTheLastBit) {
  std::vector<YarnLine> yarns = two_yarns();
  yarns[0].points[1].x() = 1.0 / 3;
  const YarnLines lines = parse_csv(csv_text(yarns));
  EXPECT_EQ(lines.kind, LineKind::through_points);
  EXPECT_TRUE(lines.in_millimetres);
  ASSERT_EQ(lines.yarns.size(), 2U);
  EXPECT_EQ(lines.yarns[0].points, yarns[0].points);
  EXPECT_EQ(lines.yarns[1].points, yarns[1].points);
  EXPECT_EQ(lines.yarns[1].radius, 0.125);
  EXPECT_FALSE(lines.yarns[0].closed);
}

TEST(ParseCsv, GivenColumnsInOtherOrderAndUnit_ThenLengthsAreInMillimetres) {
  const YarnLines lines = parse_csv("z (um);name;y (um);x (um);yarn\n1,5;a;2;3000;left one\n4;b;5;6;left one\n");
  ASSERT_EQ(lines.yarns.size(), 1U);
  EXPECT_TRUE(lines.in_millimetres);
  EXPECT_LT((lines.yarns[0].points[0] - Eigen::Vector3d(3, 0.002, 0.0015)).norm(), 1e-15);
}

TEST(ParseCsv, GivenNoUnit_ThenTheLengthsStayAsTheyAre) {
  const YarnLines lines = parse_csv("yarn,x,y,z\n1,0,0,0\n1,7,0,0\n");
  EXPECT_FALSE(lines.in_millimetres);
  EXPECT_EQ(lines.yarns[0].points[1].x(), 7);
}

TEST(ParseCsv, GivenAYarnThatEndsWhereItBegins_ThenItIsClosed) {
  const std::vector<YarnLine> yarns = {{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .closed = true}};
  const YarnLines lines = parse_csv(csv_text(yarns));
  EXPECT_TRUE(lines.yarns[0].closed);
  EXPECT_EQ(lines.yarns[0].points, yarns[0].points);
}

TEST(ParseCsv, GivenATableThatIsNone_ThenTheComplaintSaysWhatAndWhere) {
  const std::string head = "yarn,x_mm,y_mm,z_mm\n";
  const auto complaint = [](const std::string& text) { return complaint_of(parse_csv, text); };
  EXPECT_THAT(complaint(""), HasSubstr("is empty"));
  EXPECT_THAT(complaint("yarn,x_mm,y_mm\n"), HasSubstr("line 1: names no column z"));
  EXPECT_THAT(complaint("yarn,x_mm,y_mm,z_cm\n"), HasSubstr("another unit than x"));
  EXPECT_THAT(complaint("yarn,x_mm,y_mm,z\n"), HasSubstr("another unit than x"));
  EXPECT_THAT(complaint("yarn,x_ft,y_ft,z_ft\n"), AllOf(HasSubstr("\"ft\" is no unit"), HasSubstr("mm, um, cm")));
  EXPECT_THAT(complaint("yarn,x_mm,x_mm,y_mm,z_mm\n"), HasSubstr("two columns are named x"));
  EXPECT_THAT(complaint(head), HasSubstr("has no yarn"));
  EXPECT_THAT(complaint(head + "1,0,0,0\n"), HasSubstr("yarn 1 has 1 point, but needs at least 2"));
  EXPECT_THAT(complaint(head + "1,0,0\n"), HasSubstr("line 2: has 3 cells"));
  EXPECT_THAT(complaint(head + "1,0,0,0\n1,0,what,0\n"), AllOf(HasSubstr("line 3"), HasSubstr("\"what\"")));
  EXPECT_THAT(complaint(head + "1,0,nan,0\n"), HasSubstr("no finite number"));
  EXPECT_THAT(complaint(head + ",0,0,0\n"), HasSubstr("line 2: says no yarn"));
  EXPECT_THAT(complaint(head + "1,0,0,0\n1,1,0,0\n1,1e12,0,0\n"), HasSubstr("yarn 1, point 3"));
  EXPECT_THAT(complaint(head + "1,0,0,0\n1,1,0,0\n2,0,1,0\n2,1,1,0\n1,2,0,0\n"),
              AllOf(HasSubstr("line 6"), HasSubstr("other yarns came between")));
  EXPECT_THAT(complaint("BCC\x44" + std::string(100, '\0')), HasSubstr("is not a text file"));
}

TEST(ParseBcc, GivenWhatBccTextWrote_ThenTheInnerPointsAreThoseOfTheYarns) {
  const std::vector<YarnLine> yarns = two_yarns();
  const YarnLines lines = parse_bcc(bcc_text(yarns));
  EXPECT_EQ(lines.kind, LineKind::inner_points);
  EXPECT_FALSE(lines.in_millimetres);
  ASSERT_EQ(lines.yarns.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<Eigen::Vector3d>& points = lines.yarns[i].points;
    EXPECT_EQ(std::vector(points.begin() + 1, points.end() - 1), yarns[i].points);
  }
}

TEST(ParseBcc, GivenAPolyline_ThenItsPointsLieOnTheCentreline) {
  std::string bytes = bcc_text(two_yarns());
  bytes.replace(4, 2, "PL");
  EXPECT_EQ(parse_bcc(bytes).kind, LineKind::through_points);
}

TEST(ParseBcc, GivenANegativeCount_ThenTheYarnIsClosed) {
  const std::vector<YarnLine> yarns = {{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .closed = true}};
  const YarnLines lines = parse_bcc(bcc_text(yarns));
  EXPECT_TRUE(lines.yarns[0].closed);
  EXPECT_EQ(lines.yarns[0].points, yarns[0].points);
}

TEST(ParseBcc, GivenADamagedFile_ThenTheComplaintSaysWhatAndWhere) {
  const std::string bytes = bcc_text(two_yarns());
  const auto complaint = [](const std::string& text) { return complaint_of(parse_bcc, text); };
  EXPECT_THAT(complaint("yarn,x"), HasSubstr("does not begin with the letters BCC"));
  EXPECT_THAT(complaint("BCC"), HasSubstr("ends within its head"));
  EXPECT_THAT(complaint(with(bytes, 3, std::uint8_t{0x88})), HasSubstr("32 bits"));
  EXPECT_THAT(complaint(with(bytes, 6, std::uint8_t{2})), HasSubstr("in 2 dimensions"));
  EXPECT_THAT(complaint(std::string(bytes).replace(4, 2, "C1")), HasSubstr("of the type \"C1\""));
  EXPECT_THAT(complaint(with(bytes, 8, std::numeric_limits<std::uint64_t>::max())), HasSubstr("its head speaks of"));
  EXPECT_THAT(complaint(with(bytes, 16, std::uint64_t{1} << 60)), HasSubstr("its head speaks of"));
  EXPECT_THAT(complaint(with(bytes, 64, std::numeric_limits<std::int32_t>::min())),
              AllOf(HasSubstr("yarn 1 at byte 64"), HasSubstr("2147483648 points")));
  EXPECT_THAT(complaint(with(bytes, 64, std::int32_t{1000})), HasSubstr("more than the file holds"));
  EXPECT_THAT(complaint(with(bytes, 64, std::int32_t{0})), HasSubstr("is damaged"));
  EXPECT_THAT(complaint(with(bytes, 68 + 12, std::numeric_limits<float>::quiet_NaN())),
              AllOf(HasSubstr("yarn 1, point 2"), HasSubstr("is no place")));
  EXPECT_THAT(complaint(bytes + "more"), HasSubstr("its head speaks of"));
}

TEST(ParseYarns, GivenWhatYarnsTextWrote_ThenYarnsAndRadiiComeBack) {
  const YarnLines lines = parse_yarns(yarns_text(two_yarns()));
  EXPECT_EQ(lines.kind, LineKind::midpoints);
  ASSERT_EQ(lines.yarns.size(), 2U);
  EXPECT_EQ(lines.yarns[0].points.size(), 4U);
  EXPECT_EQ(lines.yarns[1].points.back(), Eigen::Vector3d(2.5, 3, 0));
  EXPECT_EQ(lines.yarns[1].radius, 0.125);
}

TEST(ParseYarns, GivenAFileWithoutTheLastChunks_ThenItIsRead) {
  const std::string bytes = yarns_text(two_yarns());
  EXPECT_EQ(parse_yarns(bytes.substr(0, bytes.find("strs"))).yarns.size(), 2U);
}

TEST(ParseYarns, GivenADamagedFile_ThenTheComplaintSaysWhatAndWhere) {
  const std::string bytes = yarns_text(two_yarns());
  const std::size_t infos = bytes.find("yarn") + 8;
  const auto complaint = [](const std::string& text) { return complaint_of(parse_yarns, text); };
  EXPECT_THAT(complaint(""), HasSubstr("ends where the chunk \"f3..\" is due"));
  EXPECT_THAT(complaint("some text"), AllOf(HasSubstr("\"f3..\" is due"), HasSubstr("\"some\" is there")));
  EXPECT_THAT(complaint(with(bytes, 4, std::uint32_t{0xffffffff})), HasSubstr("should have 4294967295 bytes"));
  EXPECT_THAT(complaint(with(bytes, 4, std::uint32_t{83})), HasSubstr("no multiple of 12"));
  EXPECT_THAT(complaint(with(bytes, 4, std::uint32_t{72})), HasSubstr("\"src.\" is due here"));
  EXPECT_THAT(complaint(with(bytes, infos + 4, std::uint32_t{99})), HasSubstr("from point 0 to point 99 of 7"));
  EXPECT_THAT(complaint(with(bytes, infos + 4, std::uint32_t{7})), HasSubstr("yarn 2 has points of other yarns"));
  EXPECT_THAT(complaint(with(bytes, infos + 4, std::uint32_t{1})), HasSubstr("yarn 1 has 1 point"));
  EXPECT_THAT(complaint(with(bytes, infos + 8, -1.0F)), HasSubstr("radius of -1"));
  EXPECT_THAT(complaint(with(bytes, 8, std::numeric_limits<float>::infinity())), HasSubstr("yarn 1, point 1"));
  EXPECT_THAT(complaint(bytes + "more"), HasSubstr("goes on behind its last chunk"));
}

struct Format {
  const char* name;
  YarnLines (*parse)(std::string_view);
  std::string (*text)(const std::vector<YarnLine>&);
};

class EveryFormat : public testing::TestWithParam<Format> {};

// What is cut off or changed anywhere either still reads, as yarns that obey the rules, or ends in one sentence.
// Nothing else may come out: no other exception, no crash, no size that the file does not bear out.
void expect_yarns_or_a_sentence(const Format& format, const std::string& bytes) {
  try {
    const YarnLines lines = format.parse(bytes);
    ASSERT_FALSE(lines.yarns.empty());
    std::size_t n_points = 0;
    for (const YarnLine& yarn : lines.yarns) {
      ASSERT_GE(yarn.points.size(), 2U);
      n_points += yarn.points.size();
      for (const Eigen::Vector3d& point : yarn.points) ASSERT_TRUE(point.allFinite());
    }
    ASSERT_LE(n_points, bytes.size());
  } catch (const InputError& error) {
    ASSERT_GT(std::string(error.what()).size(), 5U);
  }
}

TEST_P(EveryFormat, GivenAFileCutOffAtAnyLength_ThenItIsYarnsOrASentence) {
  const std::string bytes = GetParam().text(two_yarns());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    expect_yarns_or_a_sentence(GetParam(), bytes.substr(0, length));
  }
}

TEST_P(EveryFormat, GivenAnyFlippedBit_ThenItIsYarnsOrASentence) {
  const std::string bytes = GetParam().text(two_yarns());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    expect_yarns_or_a_sentence(GetParam(), flipped);
  }
}

TEST_P(EveryFormat, GivenBytesThatAreShuffled_ThenItIsYarnsOrASentence) {
  const std::string bytes = GetParam().text(two_yarns());
  std::mt19937 random(20);
  std::uniform_int_distribution<std::size_t> place(0, bytes.size() - 1);
  for (int i = 0; i < 2000; ++i) {
    std::string shuffled = bytes;
    for (int k = 0; k < 4; ++k) std::swap(shuffled[place(random)], shuffled[place(random)]);
    expect_yarns_or_a_sentence(GetParam(), shuffled);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryFormat,
                         testing::Values(Format{"csv", parse_csv, csv_text}, Format{"bcc", parse_bcc, bcc_text},
                                         Format{"yarns", parse_yarns, yarns_text}),
                         [](const testing::TestParamInfo<Format>& info) { return std::string(info.param.name); });

// A binary file of which a part is missing is never taken for a smaller one. (A table may end at any line.)
TEST(BinaryFormats, GivenAFileCutOffAnywhere_ThenItIsRefused) {
  const std::string bcc = bcc_text(two_yarns());
  for (std::size_t length = 0; length < bcc.size(); ++length) {
    EXPECT_THROW(static_cast<void>(parse_bcc(bcc.substr(0, length))), InputError) << length;
  }
  const std::string yarns = yarns_text(two_yarns());
  for (std::size_t length = 0; length < yarns.find("strs"); ++length) {
    EXPECT_THROW(static_cast<void>(parse_yarns(yarns.substr(0, length))), InputError) << length;
  }
}

}  // namespace
}  // namespace knitmech::curves
