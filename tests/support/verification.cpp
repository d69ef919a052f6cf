#include "verification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace knitmech::test {

namespace {

/// File of the running test, emptied by its first row.
std::ofstream rows_of_running_test() {
  static std::string written_last;
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::replace(name.begin(), name.end(), '/', '.');
  const std::filesystem::path folder = KNITMECH_VERIFICATION_ROWS;
  std::filesystem::create_directories(folder);
  const bool is_first = name != written_last;
  written_last = name;
  return std::ofstream{folder / (name + ".tsv"), is_first ? std::ios::trunc : std::ios::app};
}

}  // namespace

void verify(const Comparison& row) {
  const double scale = row.scale > 0 ? row.scale : std::abs(row.reference);
  const double error = (row.computed - row.reference) / scale;
  EXPECT_LE(std::abs(error), row.tolerance) << row.chapter << ", " << row.of << ": " << row.quantity << " is "
                                            << row.computed << " instead of " << row.reference;
  std::ofstream file = rows_of_running_test();
  file.precision(17);
  file << row.chapter << '\t' << row.of << '\t' << row.quantity << '\t' << row.source << '\t' << row.reference << '\t'
       << row.computed << '\t' << error << '\t' << row.tolerance << '\t' << row.remark << '\n';
  file.flush();
  EXPECT_TRUE(file.good()) << "the row could not be recorded";
}

}  // namespace knitmech::test
