#include "study/run_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <map>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "study_fixture.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kHeights = "[loop.height]\nvalues = [\"7 mm\", \"7.1 mm\", \"7.2 mm\"]";

std::vector<VariantState> run_here(const StudyFolder& folder, const std::string& text, int jobs,
                                   const StudyListener& listener = {}) {
  return run_study(folder.study(text), {.folder = folder.path() / "out", .jobs = jobs, .threads = 1}, listener);
}

std::string history_of(const StudyFolder& folder, const std::string& name) {
  return results::read_file(folder.path() / "out" / "runs" / name / "history.csv");
}

TEST(RunStudy, GivenThreeCasesWhenRunSideBySideThenEachIsTheRunThatItIsAlone) {
  const StudyFolder together, alone;
  const auto states = run_here(together, kHeights, 3);
  ASSERT_EQ(states.size(), 3U);
  for (const VariantState& state : states) EXPECT_EQ(state.standing, Standing::completed) << state.reason;
  (void)run_here(alone, kHeights, 1);
  for (const VariantState& state : states) {
    EXPECT_TRUE(history_of(together, state.variant.name) == history_of(alone, state.variant.name));
  }
  EXPECT_TRUE(history_of(together, "height-7mm") != history_of(together, "height-7.2mm"));
}

TEST(RunStudy, GivenAStudyThatIsDoneWhenRunAgainThenNothingIsRunAndTheTableIsTheSame) {
  const StudyFolder folder;
  (void)run_here(folder, kHeights, 2);
  const std::string table = results::read_file(folder.path() / "out" / "table.csv");
  StudyListener listener;
  listener.on_history = [](const VariantState&, const model::HistoryRow&) { FAIL() << "something is run"; };
  const auto states = run_here(folder, kHeights, 2, listener);
  for (const VariantState& state : states) EXPECT_TRUE(state.was_done);
  EXPECT_EQ(results::read_file(folder.path() / "out" / "table.csv"), table);
}

TEST(RunStudy, GivenABaseCaseThatHasChangedWhenRunAgainThenTheRunsAreMadeAnew) {
  const StudyFolder folder;
  (void)run_here(folder, kHeights, 2);
  Study study = folder.study(kHeights);
  study.base.fabric.course_spacing = 5.1;
  const auto states = run_study(study, {.folder = folder.path() / "out", .jobs = 2, .threads = 1}, {});
  for (const VariantState& state : states) EXPECT_FALSE(state.was_done);
}

TEST(RunStudy, GivenAStudyThatIsInterruptedWhenRunAgainThenItEndsAsIfItHadNotBeen) {
  const StudyFolder whole, broken;
  (void)run_here(whole, kHeights, 1);
  std::atomic<int> rows = 0;
  StudyListener listener;
  listener.on_history = [&](const VariantState&, const model::HistoryRow&) { ++rows; };
  listener.keep_going = [&] { return rows < 50; };
  const auto states = run_here(broken, kHeights, 1, listener);
  EXPECT_EQ(states[0].standing, Standing::completed);
  EXPECT_EQ(states[1].standing, Standing::pending);
  EXPECT_EQ(states[2].standing, Standing::pending);
  EXPECT_TRUE(fs::exists(states[1].folder / "checkpoint.bin"));
  std::map<std::string, double> first_strain;
  StudyListener second;
  second.on_history = [&](const VariantState& state, const model::HistoryRow& row) {
    first_strain.emplace(state.variant.name, row.strain);
  };
  (void)run_here(broken, kHeights, 1, second);
  EXPECT_FALSE(first_strain.contains("height-7mm"));
  EXPECT_GT(first_strain.at("height-7.1mm"), 0);  // goes on, does not begin anew
  for (const char* name : {"height-7mm", "height-7.1mm", "height-7.2mm"}) {
    EXPECT_TRUE(history_of(whole, name) == history_of(broken, name)) << name;
  }
}

TEST(RunStudy, GivenImpossibleCasesWhenRunThenTheOthersAreDoneAndTheTableSaysWhy) {
  const StudyFolder folder;
  const auto states = run_here(folder, "[loop.height]\nvalues = [\"7 mm\", \"-1 mm\", \"4 mm\"]", 2);
  EXPECT_EQ(states[0].standing, Standing::completed);
  EXPECT_EQ(states[1].standing, Standing::impossible);
  EXPECT_THAT(states[1].reason, HasSubstr("loop.height must be greater than 0 mm"));
  EXPECT_EQ(states[2].standing, Standing::impossible);
  EXPECT_THAT(states[2].reason, HasSubstr("do not interlock"));
  const std::string table = results::read_file(folder.path() / "out" / "table.csv");
  EXPECT_THAT(table, HasSubstr("height-4mm,impossible,4 mm"));
  EXPECT_THAT(table, HasSubstr("do not interlock"));
}

TEST(RunStudy, GivenAFolderWithSomethingElseWhenRunThenItIsRefusedAndLeftAlone) {
  const StudyFolder folder;
  fs::create_directories(folder.path() / "out");
  folder.write("out/thesis.txt", "years of work");
  EXPECT_THROW((void)run_here(folder, kHeights, 1), InputError);
  EXPECT_EQ(results::read_file(folder.path() / "out" / "thesis.txt"), "years of work");
  EXPECT_FALSE(fs::exists(folder.path() / "out" / "runs"));
}

}  // namespace
}  // namespace knitmech::study
