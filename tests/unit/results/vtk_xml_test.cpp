#include "results/vtk_xml.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "vtk_xml_reader.h"

namespace knitmech::results {
namespace {

std::string file_with(const std::string& array) {
  return "<VTKFile><PolyData><PointData>" + array + "</PointData></PolyData></VTKFile>";
}

/// Values with all digits, among them some that are no numbers.
std::vector<double> values_of(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(std::sqrt(2.0 + static_cast<double>(i)));
  if (!values.empty()) values.front() = std::nan("");
  return values;
}

class VtkArrayOfAnyLength : public testing::TestWithParam<std::size_t> {};

TEST_P(VtkArrayOfAnyLength, ReadsBackBitByBit) {
  // Given an array of no, a few, just as many, or more numbers than go into one compressed block of 1 MiB.
  const std::vector<double> values = values_of(GetParam());
  // When it is written, and read by a reader that knows the format only.
  const test::VtkFile file = test::read_vtk_xml(file_with(vtk_array("x", values)));
  // Then no bit has changed.
  const std::vector<double>& found = file.arrays.at("PointData/x").values;
  ASSERT_EQ(found.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint64_t>(found[i]), std::bit_cast<std::uint64_t>(values[i])) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, VtkArrayOfAnyLength, testing::Values(0, 1, 131072, 131073, 300000));

TEST(VtkArray, GivenWhatRepeatsItself_ThenTheTextIsSmall) {
  // 800 kB of the same number: deflate makes at best 1032 bytes of it one (zlib.net, technical details).
  EXPECT_LT(vtk_array("x", std::vector<double>(100000, 0.06)).size(), 20000U);
}

}  // namespace
}  // namespace knitmech::results
