#pragma once

#include <gtest/gtest.h>

#include <string>

#include "model/case.h"

namespace knitmech::test {

/// Every centreline that the contact knows, as the parameter of a test.
inline auto every_centreline() {
  return testing::Values(model::Centreline::chords, model::Centreline::smooth);
}

inline std::string name_of(model::Centreline centreline) {
  return centreline == model::Centreline::chords ? "chords" : "smooth";
}

inline std::string name_of_parameter(const testing::TestParamInfo<model::Centreline>& parameter) {
  return name_of(parameter.param);
}

/// Makes the tests of a suite that is a testing::TestWithParam<model::Centreline> run with every centreline.
#define KNITMECH_WITH_EVERY_CENTRELINE(suite) \
  INSTANTIATE_TEST_SUITE_P(Contact, suite, test::every_centreline(), test::name_of_parameter)

/// The tolerance of a case that the two centrelines meet differently well [-].
inline double allowed(model::Centreline centreline, double chords, double smooth) {
  return centreline == model::Centreline::chords ? chords : smooth;
}

}  // namespace knitmech::test
