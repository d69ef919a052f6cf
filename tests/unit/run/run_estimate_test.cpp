#include "run/run_estimate.h"

#include <gtest/gtest.h>

#include <string>

#include "results/atomic_file.h"
#include "run/run_case.h"

namespace knitmech::run {
namespace {

/// The main example with other values for some keys.
LoadedCase main_example(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = results::read_file(std::string(KNITMECH_SOURCE_DIR) + "/examples/02-wale-tension/case.toml");
  for (const auto& [before, after] : changes) text.replace(text.find(before), before.size(), after);
  return load_case_text(text, "case");
}

double steps_of(const LoadedCase& loaded) {
  return static_cast<double>(
      solve::simulate(loaded.model, resolved_settings(loaded, 1), solve::SimulationCallbacks{}).steps);
}

const std::vector<std::pair<std::string, std::string>> kSmall{{"wales = 9", "wales = 3"},
                                                              {"courses = 15", "courses = 4"}};

TEST(RunEstimate, IsNearTheStepsOfAnAdaptedRun) {
  // Given a fabric to which nothing was fitted, with the mass and the speed that the program chooses.
  const LoadedCase loaded = main_example(kSmall);
  const double steps = steps_of(loaded);
  EXPECT_GT(estimate_run(loaded).steps, 0.6 * steps);
  EXPECT_LT(estimate_run(loaded).steps, 1.6 * steps);
}

TEST(RunEstimate, IsNearTheStepsOfARunWithItsOwnMass) {
  auto changes = kSmall;
  changes.emplace_back("[output]", "[solver]\nmass_scaling = 2000\n\n[output]");
  const LoadedCase loaded = main_example(changes);
  const double steps = steps_of(loaded);
  EXPECT_GT(estimate_run(loaded).steps, 0.6 * steps);
  EXPECT_LT(estimate_run(loaded).steps, 1.6 * steps);
}

TEST(RunEstimate, GrowsWithTheFabricAndTheStrain) {
  const RunEstimate small = estimate_run(main_example(kSmall));
  const RunEstimate usual = estimate_run(main_example({}));
  const RunEstimate far = estimate_run(main_example({{"strain = 0.22", "strain = 0.42"}}));
  EXPECT_GT(usual.seconds, 5 * small.seconds);
  EXPECT_GT(far.seconds, 2 * usual.seconds);
}

}  // namespace
}  // namespace knitmech::run
