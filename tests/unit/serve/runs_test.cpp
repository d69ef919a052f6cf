// Small runs, really run: 2 x 2 stitches.

#include "serve/runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/case_file.h"
#include "runs_fixture.h"
#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

template <typename Call>
int refused_with(Call&& call) {
  try {
    call();
  } catch (const Refusal& refusal) {
    return refusal.status();
  }
  return 0;
}

TEST_F(RunsTest, GivenACase_ThenItsRunIsCompletedAndAllOfItIsThere) {
  Runs runs(root_);
  const std::string id = runs.start(case_text(), "my run");
  EXPECT_EQ(id, "my-run");
  wait_for_end(runs, id);
  const Json one = head(runs, id);
  EXPECT_EQ(one.at("status"), "completed") << one;
  EXPECT_EQ(one.at("title"), "Small");
  EXPECT_NEAR(one.at("strain").get<double>(), 0.02, 1e-4);
  EXPECT_EQ(one.at("target_strain"), 0.02);
  EXPECT_EQ(one.at("frames"), 3);
  EXPECT_EQ(one.at("can_go_on"), false);
  EXPECT_GT(one.at("seconds").get<double>(), 0);
  const Json all = detail(runs, id);
  EXPECT_EQ(all.at("frame_list").size(), 3U);
  EXPECT_EQ(all.at("frame_list")[2].at("index"), 2);
  EXPECT_EQ(all.at("case_text"), text_of(id, "case.toml"));
  EXPECT_TRUE(all.at("report").get<bool>());
  EXPECT_TRUE(fs::exists(root_ / id / "report.html"));
  EXPECT_TRUE(fs::exists(root_ / id / "pictures" / "frame_0000.png"));
  EXPECT_EQ(all.at("mass_scaling"), 100);
  EXPECT_THAT(all.at("quality").at("crossings").get<std::string>(), HasSubstr("All crossings were kept"));
  EXPECT_GT(all.at("nodes").get<int>(), all.at("elements").get<int>());
  // Reference: the row at the start in the file itself.
  const Json columns = history(runs, id).at("columns");
  EXPECT_EQ(all.at("width"), columns.at("width_mm")[0]);
  EXPECT_EQ(one.at("rows"), columns.at("strain").size());
}

TEST_F(RunsTest, GivenTheSameNameAgainAndAgain_ThenEachRunHasAFolderOfItsOwn) {
  Runs runs(root_, kQuick);
  EXPECT_EQ(runs.start(long_case_text(), "a"), "a");
  EXPECT_EQ(runs.start(long_case_text(), "a"), "a-2");
  EXPECT_EQ(runs.start(long_case_text(), "a"), "a-3");
  EXPECT_EQ(runs.start(long_case_text(), "../..//"), "run");
  EXPECT_EQ(runs.start(long_case_text(), ".hid\nden ä"), "hidden-");
  EXPECT_EQ(runs.start(long_case_text(), std::string(500, 'x')), std::string(80, 'x'));
  for (const Json& one : Json::parse(runs.list_json())) runs.stop(one.at("id"));
}

TEST_F(RunsTest, GivenManyStartsAtTheSameTime_ThenNoFolderIsGivenTwice) {
  Runs runs(root_, kQuick);
  std::vector<std::string> ids(6);
  {
    std::vector<std::jthread> threads;
    threads.reserve(ids.size());
    for (std::string& id : ids) threads.emplace_back([&] { id = runs.start(case_text(), "same"); });
  }
  for (const std::string& id : ids) wait_for_end(runs, id);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
  for (const std::string& id : ids) EXPECT_EQ(status(runs, id), "completed");
}

TEST_F(RunsTest, GivenAMistakeInTheCase_ThenItIsToldWithItsKey_AndNothingIsLeft) {
  Runs runs(root_, kQuick);
  std::string text = case_text();
  text.replace(text.find("height = \"7 mm\""), 15, "height = \"7 kg\"");
  try {
    static_cast<void>(runs.start(text, "wrong"));
    FAIL() << "must not start";
  } catch (const model::CaseFileError& error) {
    EXPECT_EQ(error.key(), "loop.height");
    EXPECT_EQ(error.line(), 3);
  }
  // A geometry that cannot be is found only when the model is built.
  text = case_text();
  text.replace(text.find("head_radius = \"1.1 mm\""), 22, "head_radius = \"5 mm\"");
  EXPECT_THROW(static_cast<void>(runs.start(text, "wrong")), model::CaseFileError);
  EXPECT_EQ(n_folders(), 0U);
  EXPECT_EQ(runs.list_json(), "[]");
}

TEST_F(RunsTest, GivenAWatchedRun_ThenLiveViewsArriveOneAfterTheOther) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(long_case_text(), "watched");
  double strain = 0;
  for (int number = 1; number <= 3; ++number) {
    static_cast<void>(detail(runs, id));
    wait_until("a live view", [&] { return head(runs, id).at("live").get<int>() >= number; });
    const ReadBlob view(runs.live_blob(id));
    EXPECT_TRUE(view.head().at("index").is_null());
    EXPECT_GE(view.head().at("live").get<int>(), number);
    EXPECT_EQ(view.floats("positions").size(), 3 * detail(runs, id).at("nodes").get<std::size_t>());
    EXPECT_GE(view.head().at("strain").get<double>(), strain);
    strain = view.head().at("strain").get<double>();
  }
  runs.stop(id);
}

TEST_F(RunsTest, GivenARunThatNobodyWatches_ThenThereAreNoViews) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(long_case_text(), "alone");
  wait_until("some rows", [&] { return head(runs, id).at("rows").get<int>() > 100; });
  EXPECT_EQ(head(runs, id).at("live"), 0);
  EXPECT_EQ(refused_with([&] { static_cast<void>(runs.live_blob(id)); }), 404);
  runs.stop(id);
}

TEST_F(RunsTest, GivenAPause_ThenNoRowsCome_AndWithResumeTheyDo) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(long_case_text(), "paused");
  wait_until("some rows", [&] { return n_rows(runs, id) > 3; });
  runs.pause(id);
  runs.pause(id);
  // Frames are written beside the run, so the first may come late.
  wait_until("the pause", [&] { return status(runs, id) == "paused" && head(runs, id).at("frames") == 1; });
  const std::size_t rows = n_rows(runs, id);
  const Json paused = head(runs, id);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(head(runs, id), paused);
  EXPECT_TRUE(paused.at("active").get<bool>());
  EXPECT_GE(paused.at("live").get<int>(), 1);  // the state in which it stands still
  EXPECT_EQ(n_rows(runs, id), rows);
  runs.resume(id);
  wait_until("further rows", [&] { return n_rows(runs, id) > rows + 3; });
  runs.stop(id);
  wait_for_end(runs, id);
  EXPECT_EQ(status(runs, id), "interrupted");
}

TEST_F(RunsTest, GivenARunStoppedTwice_WhilePausedToo_ThatGoesOn_ThenItsHistoryHasTheSameBits) {
  Runs runs(root_, kQuick);
  const std::string text = case_text("0.1", "[0.05]", "5");
  const std::string whole = runs.start(text, "whole");
  wait_for_end(runs, whole);
  const std::string id = runs.start(text, "parts");
  wait_until("some rows", [&] { return n_rows(runs, id) > 20; });
  runs.stop(id);
  wait_for_end(runs, id);
  const Json first = head(runs, id);
  ASSERT_EQ(first.at("status"), "interrupted");
  ASSERT_TRUE(first.at("can_go_on").get<bool>());
  EXPECT_FALSE(detail(runs, id).at("report").get<bool>());
  runs.resume(id);
  wait_until("further rows", [&] { return status(runs, id) == "running" && n_rows(runs, id) > 60; });
  runs.pause(id);
  wait_for_status(runs, id, "paused");
  runs.stop(id);
  wait_for_end(runs, id);
  EXPECT_GT(head(runs, id).at("seconds").get<double>(), first.at("seconds").get<double>());
  runs.resume(id);
  wait_for_end(runs, id);
  EXPECT_EQ(status(runs, id), "completed");
  EXPECT_EQ(text_of(id, "history.csv"), text_of(whole, "history.csv"));
  EXPECT_EQ(runs.frame_blob(id, 1), runs.frame_blob(whole, 1));
}

TEST_F(RunsTest, GivenRowsFromARowOn_ThenTheyAreThoseOfTheWholeHistory_AlsoWhileItRuns) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(long_case_text(), "rows");
  wait_until("some rows", [&] { return n_rows(runs, id) > 10; });
  const Json early = history(runs, id, 4);
  runs.stop(id);
  wait_for_end(runs, id);
  const Json all = history(runs, id);
  EXPECT_EQ(early.at("from"), 4);
  for (const auto& [name, column] : early.at("columns").items()) {
    ASSERT_GT(column.size(), 6U);
    for (std::size_t i = 0; i < column.size(); ++i) EXPECT_EQ(column[i], all.at("columns").at(name)[i + 4]);
  }
  EXPECT_EQ(all.at("columns").size(), 19U);
  EXPECT_EQ(history(runs, id, 100000).at("columns").at("strain").size(), 0U);
}

TEST_F(RunsTest, GivenTwoProcessors_ThenTwoRunsGoAtOnceAndTheThirdWaitsForItsTurn) {
  Runs runs(root_, {.at_once = 2, .pictures = false});
  const std::string first = runs.start(long_case_text(), "first");
  const std::string second = runs.start(long_case_text(), "second");
  const std::string third = runs.start(long_case_text(), "third");
  wait_until("rows of both", [&] { return n_rows(runs, first) > 2 && n_rows(runs, second) > 2; });
  EXPECT_EQ(status(runs, third), "waiting");
  EXPECT_EQ(n_rows(runs, third), 0U);
  EXPECT_EQ(detail(runs, third).at("frame_list").size(), 0U);
  EXPECT_EQ(refused_with([&] { runs.pause(third); }), 409);
  // A run that stands still lets another go; it has to wait for its turn then.
  runs.pause(first);
  wait_for_status(runs, third, "running");
  runs.resume(first);
  wait_for_status(runs, first, "waiting");
  runs.stop(second);
  wait_for_status(runs, first, "running");
  runs.stop(first);
  runs.stop(third);
}

TEST_F(RunsTest, GivenAWaitingRunThatIsStopped_ThenItIsGoneWithoutATrace) {
  Runs runs(root_, {.at_once = 1, .pictures = false});
  const std::string first = runs.start(long_case_text(), "first");
  const std::string second = runs.start(long_case_text(), "second");
  EXPECT_EQ(status(runs, second), "waiting");
  runs.stop(second);
  wait_until("that it is gone", [&] { return head(runs, second).is_null(); });
  EXPECT_FALSE(fs::exists(root_ / second));
  runs.stop(first);
}

TEST_F(RunsTest, GivenThatTheProgramEnds_ThenItsRunsCanBeGoneOnWithByTheNext) {
  std::string id;
  {
    Runs runs(root_, {.at_once = 1, .pictures = false});
    id = runs.start(long_case_text(), "long");
    static_cast<void>(runs.start(long_case_text(), "waits"));
    wait_until("some rows", [&] { return n_rows(runs, id) > 3; });
  }
  Runs runs(root_, kQuick);
  EXPECT_EQ(Json::parse(runs.list_json()).size(), 1U);
  EXPECT_EQ(status(runs, id), "interrupted");
  const std::size_t rows = n_rows(runs, id);
  runs.resume(id);
  wait_until("further rows", [&] { return n_rows(runs, id) > rows; });
  runs.stop(id);
}

TEST_F(RunsTest, GivenAFolderRemovedBehindItsBack_ThenTheRunEndsAndIsGone) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(long_case_text(), "removed");
  wait_until("some rows", [&] { return n_rows(runs, id) > 3; });
  runs.pause(id);
  wait_for_status(runs, id, "paused");
  fs::remove_all(root_ / id);
  EXPECT_EQ(status(runs, id), "paused");
  runs.resume(id);
  wait_until("that it is gone", [&] { return head(runs, id).is_null(); });
  EXPECT_EQ(refused_with([&] { static_cast<void>(runs.detail_json(id)); }), 404);
}

TEST_F(RunsTest, GivenThatItsFilesCannotBeWritten_ThenTheRunHasFailedAndSaysWhy) {
  Runs runs(root_, {.at_once = 1, .pictures = false});
  const std::string first = runs.start(long_case_text(), "first");
  const std::string id = runs.start(case_text(), "spoilt");
  std::ofstream(root_ / id / "foreign.txt") << "not of a run";
  runs.stop(first);
  wait_for_status(runs, id, "failed");
  wait_for_end(runs, id);
  const Json one = head(runs, id);
  EXPECT_THAT(one.at("message").get<std::string>(), HasSubstr("not a KnitMech run"));
  EXPECT_FALSE(one.at("active").get<bool>());
  EXPECT_FALSE(one.at("can_go_on").get<bool>());
  EXPECT_EQ(results::read_file(root_ / id / "foreign.txt"), "not of a run");
}

TEST_F(RunsTest, GivenACommandThatTheStateDoesNotAdmit_ThenItIsRefused) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(case_text(), "done");
  wait_for_end(runs, id);
  EXPECT_EQ(refused_with([&] { runs.pause(id); }), 409);
  EXPECT_EQ(refused_with([&] { runs.stop(id); }), 409);
  EXPECT_EQ(refused_with([&] { runs.resume(id); }), 409);
  EXPECT_EQ(refused_with([&] { static_cast<void>(runs.frame_blob(id, 3)); }), 404);
  EXPECT_EQ(refused_with([&] { static_cast<void>(runs.frame_blob(id, -1)); }), 404);
  EXPECT_EQ(refused_with([&] { static_cast<void>(runs.live_blob(id)); }), 404);
}

TEST_F(RunsTest, GivenThePictureOfAFrame_ThenItIsAPngOfThatSize_AndWrongWordsAreRefused) {
  Runs runs(root_, kQuick);
  const std::string id = runs.start(case_text(), "drawn");
  wait_for_end(runs, id);
  const std::string png = runs.picture_png(
      id, {{"frame", "1"}, {"colour", "contact"}, {"view", "oblique"}, {"width", "300"}, {"height", "200"}});
  ASSERT_GT(png.size(), 24U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  // Bytes 16 to 23 of a PNG file are width and height, the largest byte first.
  EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]), 300);
  EXPECT_EQ(static_cast<unsigned char>(png[22]) * 256 + static_cast<unsigned char>(png[23]), 200);
  using Words = std::map<std::string, std::string>;
  for (const Words& wrong : {Words{{"colour", "contct"}}, Words{{"view", "inside"}}, Words{{"width", "3e9"}},
                             Words{{"height", "-1"}}, Words{{"frame", "12"}}, Words{{"width", "1000000"}}}) {
    EXPECT_THROW(static_cast<void>(runs.picture_png(id, wrong)), InputError) << wrong.begin()->first;
  }
  fs::remove(root_ / id / "report.html");
  runs.write_report(id);
  EXPECT_TRUE(fs::exists(root_ / id / "report.html"));
}

}  // namespace
}  // namespace knitmech::serve
