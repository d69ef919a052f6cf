#pragma once

#include <string>

namespace knitmech::test {

/// One row of docs/verification.md: a number of the program against its reference.
struct Comparison {
  std::string chapter = {};   ///< its name in tests/verification/page.md
  std::string of = {};        ///< the case: what was computed, in a few words
  std::string quantity = {};  ///< what is compared, with its unit
  std::string source = {};    ///< where the reference comes from
  double reference = 0;       ///< found independently of the program
  double computed = 0;        ///< by the program
  double tolerance = 0;       ///< largest relative error that passes [-]
  double scale = 0;           ///< what errors are related to; 0: the reference itself
  std::string remark = {};    ///< what a reader must know of this row
};

/// Fails the running test unless the computed number is within its tolerance, and records the row for the page: a line
/// of tab-separated fields (chapter, case, quantity, source, reference, computed, error, tolerance, remark) in
/// <build tree>/verification/<test>.tsv. Every run of a test writes its file anew.
void verify(const Comparison& row);

}  // namespace knitmech::test
