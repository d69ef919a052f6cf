#include "serve/stored_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/case_file.h"
#include "results/read_frame.h"
#include "results/run_folder.h"
#include "results/summary.h"
#include "run/load_case.h"
#include "runs_fixture.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A run that has ended.
class StoredRun : public RunsTest {
 protected:
  StoredRun() {
    Runs runs(root_, kQuick);
    wait_for_end(runs, runs.start(case_text(), "stored"));
  }
  void spoil(const char* file, const std::string& text) const { std::ofstream(root_ / "stored" / file) << text; }
};

TEST_F(StoredRun, GivenADamagedSummary_ThenTheRunIsListedAsDamagedWithTheReason) {
  Runs runs(root_, kQuick);
  spoil("summary.json", "{\"format\": \"knitmech-run\", ");
  const Json one = head(runs, "stored");
  EXPECT_EQ(one.at("status"), "damaged");
  EXPECT_THAT(one.at("message").get<std::string>(), HasSubstr("damaged"));
  EXPECT_EQ(detail(runs, "stored").at("status"), "damaged");
  spoil("summary.json", "{\"format\": \"knitmech-run\", \"schema\": 99}");
  EXPECT_THAT(head(runs, "stored").at("message").get<std::string>(), HasSubstr("another version"));
}

TEST_F(StoredRun, GivenACaseThatIsDamagedSince_ThenTheRunIsDamaged_AndSaysWhere) {
  Runs runs(root_, kQuick);
  EXPECT_EQ(status(runs, "stored"), "completed");
  spoil("case.toml", "[loop");
  const Json one = head(runs, "stored");
  EXPECT_EQ(one.at("status"), "damaged");
  EXPECT_THAT(one.at("message").get<std::string>(), HasSubstr("case.toml"));
}

TEST_F(StoredRun, GivenARunWhoseProgramWasKilled_ThenItIsInterrupted_ButNotWhileAnotherProgramWritesIt) {
  Runs runs(root_, kQuick);
  const auto loaded = run::load_case_text(case_text(), "case.toml");
  {
    const results::RunFolder under_way(root_ / "killed", case_text(), loaded.model);
    EXPECT_EQ(status(runs, "killed"), "running");
  }
  // Its summary still says that it runs, as a killed program leaves it.
  EXPECT_EQ(status(runs, "killed"), "interrupted");
  EXPECT_FALSE(head(runs, "killed").at("can_go_on").get<bool>());  // there is no checkpoint yet
  std::ofstream(root_ / "killed" / "checkpoint.bin") << "something";
  EXPECT_TRUE(head(runs, "killed").at("can_go_on").get<bool>());
}

TEST_F(StoredRun, GivenFoldersOfOtherThings_ThenTheyAreNotListed) {
  fs::create_directories(root_ / "empty");
  fs::create_directories(root_ / "other");
  std::ofstream(root_ / "other" / "summary.json") << "{\"format\": \"something else\"}";
  std::ofstream(root_ / "file") << "text";
  Runs runs(root_, kQuick);
  EXPECT_EQ(Json::parse(runs.list_json()).size(), 1U);
}

TEST_F(StoredRun, GivenARunThatIsReadTwice_ThenTheSecondTimeItIsStillInMemory_UntilItChanges) {
  StoredRuns stored(root_);
  const auto first = stored.read("stored");
  EXPECT_EQ(stored.read("stored"), first);
  fs::copy(root_ / "stored", root_ / "b", fs::copy_options::recursive);
  fs::copy(root_ / "stored", root_ / "c", fs::copy_options::recursive);
  static_cast<void>(stored.read("b"));
  EXPECT_EQ(stored.read("stored"), first);
  static_cast<void>(stored.read("c"));
  EXPECT_EQ(stored.read("stored"), first);
  fs::last_write_time(root_ / "stored" / "summary.json", fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_NE(stored.read("stored"), first);
}

TEST_F(StoredRun, GivenARunThatATerminalHasJustBegun_ThenItIsRunningButNotOurs) {
  // Given a run folder as it is before the first row.
  const run::LoadedCase loaded = run::load_case_text(case_text(), "case.toml");
  const results::RunFolder folder(root_ / "theirs", case_text(), loaded.model);
  Runs runs(root_, kQuick);
  const Json one = head(runs, "theirs");
  EXPECT_EQ(one.at("status"), "running") << one;
  EXPECT_EQ(one.at("active"), false);
  EXPECT_EQ(one.at("rows"), 0);
  const Json all = detail(runs, "theirs");
  EXPECT_TRUE(all.at("quality").is_null());
  EXPECT_EQ(all.at("nodes"), loaded.model.n_nodes());
  EXPECT_EQ(history(runs, "theirs").at("columns").at("strain").size(), 0U);
}

}  // namespace
}  // namespace knitmech::serve
