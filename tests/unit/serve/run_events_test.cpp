#include <gtest/gtest.h>

#include <cmath>
#include <future>

#include "results/summary.h"
#include "runs_fixture.h"
#include "serve/run_board.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kForEver = 2min;

/// Waits until an event of a run is told that fits.
template <typename Fits>
RunEvent wait_for_event(Runs& runs, std::uint64_t& seen, const std::string& id, Fits&& fits) {
  for (int i = 0; i < 2000; ++i) {
    for (const RunEvent& event : runs.wait_for_changes(seen, 1s)) {
      if (Json::parse(event.data).at("id") == id && fits(event)) return event;
    }
  }
  throw std::runtime_error("waited in vain for an event of " + id);
}

TEST_F(RunsTest, GivenNoRuns_ThenTheStateNowIsToldAtOnce) {
  Runs runs(root_, kQuick);
  std::uint64_t seen = 0;
  EXPECT_TRUE(runs.wait_for_changes(seen, kForEver).empty());
  EXPECT_GT(seen, 0U);
  EXPECT_TRUE(runs.wait_for_changes(seen, 20ms).empty());
}

TEST_F(RunsTest, GivenSomeoneWhoWaits_ThenANewRunAndItsEndAreTold) {
  Runs runs(root_, kQuick);
  std::uint64_t seen = 0;
  static_cast<void>(runs.wait_for_changes(seen, kForEver));
  auto waiting = std::async(std::launch::async, [&] { return runs.wait_for_changes(seen, kForEver); });
  const std::string id = runs.start(case_text(), "new");
  const std::vector<RunEvent> events = waiting.get();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].name, "run");
  EXPECT_EQ(Json::parse(events[0].data).at("id"), id);
  const RunEvent end = wait_for_event(runs, seen, id, [](const RunEvent& event) {
    return event.name == "run" && !Json::parse(event.data).at("active").get<bool>();
  });
  EXPECT_EQ(Json::parse(end.data).at("status"), "completed");
  EXPECT_EQ(Json::parse(end.data), head(runs, id));
  std::uint64_t of_another_page = 0;
  ASSERT_EQ(runs.wait_for_changes(of_another_page, kForEver).size(), 1U);
}

TEST_F(RunsTest, GivenAPause_ThenItIsToldOnceAndNothingAfterIt) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(long_case_text(), "paused");
  std::uint64_t seen = 0;
  wait_for_event(runs, seen, id, [](const RunEvent& event) { return Json::parse(event.data).at("rows") > 3; });
  runs.pause(id);
  // Frames are written beside the run, so the first may come late.
  wait_for_event(runs, seen, id, [](const RunEvent& event) {
    const Json paused = Json::parse(event.data);
    return paused.at("status") == "paused" && paused.at("frames") == 1;
  });
  EXPECT_TRUE(runs.wait_for_changes(seen, 300ms).empty());
  runs.stop(id);
}

TEST_F(RunsTest, GivenARunThatAnotherProgramHasMade_ThenItIsTold_AndSoIsThatItIsGone) {
  {
    Runs other(top_ / "elsewhere", kQuick);
    wait_for_end(other, other.start(case_text(), "theirs"));
  }
  fs::create_directories(root_);
  Runs runs(root_, kQuick);
  std::uint64_t seen = 0;
  EXPECT_TRUE(runs.wait_for_changes(seen, kForEver).empty());
  fs::rename(top_ / "elsewhere" / "theirs", root_ / "theirs");
  const RunEvent come = wait_for_event(runs, seen, "theirs", [](const RunEvent&) { return true; });
  EXPECT_EQ(come.name, "run");
  EXPECT_EQ(Json::parse(come.data).at("status"), "completed");
  fs::rename(root_ / "theirs", top_ / "elsewhere" / "theirs");
  const RunEvent gone = wait_for_event(runs, seen, "theirs", [](const RunEvent&) { return true; });
  EXPECT_EQ(gone.name, "gone");
  EXPECT_EQ(Json::parse(gone.data), (Json{{"id", "theirs"}}));
  std::uint64_t of_another_page = 0;
  EXPECT_TRUE(runs.wait_for_changes(of_another_page, kForEver).empty());
}

TEST(RunBoard, GivenSeveralChangesOfARun_ThenTheLatestIsToldOnce) {
  RunBoard board;
  std::map<std::string, RunHead> heads = {{"a", {.id = "a"}}, {"b", {.id = "b"}}};
  board.set(heads);
  std::uint64_t seen = 0;
  EXPECT_EQ(board.since(seen).size(), 2U);
  for (const std::size_t rows : {3U, 7U, 12U}) {
    heads["b"].rows = rows;
    board.set(heads);
  }
  const std::vector<RunEvent> events = board.since(seen);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(Json::parse(events[0].data).at("rows"), 12);
  EXPECT_TRUE(board.since(seen).empty());
  board.set({});
  board.set({{"a", {.id = "a"}}});
  const std::vector<RunEvent> last = board.since(seen);
  ASSERT_EQ(last.size(), 2U);
  EXPECT_EQ(last[0].name, "gone");
  EXPECT_EQ(last[1].name, "run");
}

TEST(RunJson, GivenNumbersThatAreNone_ThenTheyAreNull) {
  model::HistoryRow row;
  row.force_top = std::nan("");
  row.width = INFINITY;
  row.contacts = 7;
  const Json columns = Json::parse(history_json({row}, 2)).at("columns");
  EXPECT_TRUE(columns.at("force_top_N")[0].is_null());
  EXPECT_TRUE(columns.at("width_mm")[0].is_null());
  EXPECT_EQ(columns.at("contacts")[0], 7);
}

}  // namespace
}  // namespace knitmech::serve
