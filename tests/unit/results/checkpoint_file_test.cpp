#include "results/checkpoint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "../../support/member_check.h"
#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/checkpoint_writer.h"
#include "results/history_file.h"
#include "results/run_folder.h"
#include "sample_run.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

model::HistoryRow row_at(double strain) {
  model::HistoryRow row;
  row.time = 10 * strain / 3;
  row.strain = strain;
  row.contacts = 7;
  row.step = 1e-7 / 3;
  return row;
}

model::RunOutcome ended(model::RunStatus status) {
  model::RunOutcome outcome;
  outcome.status = status;
  return outcome;
}

class CheckpointFile : public testing::Test {
 protected:
  const test::TemporaryFolder temporary_;
  const fs::path dir_ = temporary_.path() / "run";
  const fs::path file_ = dir_ / kCheckpointFile;
  const model::Model model_ = test::two_yarn_model();

  /// A run with two rows and a frame, which goes on for a row and a frame after its checkpoint.
  Checkpoint run_beyond_a_checkpoint() {
    RunFolder folder(dir_, "title = \"x\"\n", model_);
    folder.add_history(row_at(0));
    folder.add_frame(test::awkward_frame(model_, 0));
    folder.add_history(row_at(0.1));
    Checkpoint checkpoint{"title = \"x\"\n", folder.record(), std::string("solver\n\0state", 13)};
    write_checkpoint(dir_, checkpoint);
    folder.add_history(row_at(0.2));
    folder.add_frame(test::awkward_frame(model_, 1));
    return checkpoint;
  }

  [[nodiscard]] std::string complaint() const {
    try {
      static_cast<void>(read_checkpoint(dir_));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(CheckpointFile, IsReadAsItWasWritten) {
  const Checkpoint written = run_beyond_a_checkpoint();
  const Checkpoint read = read_checkpoint(dir_);
  EXPECT_EQ(read.case_text, written.case_text);
  EXPECT_EQ(read.solver, written.solver);
  ASSERT_EQ(read.record.history.size(), 2U);
  EXPECT_EQ(history_line(read.record.history[1]), history_line(row_at(0.1)));
  ASSERT_EQ(read.record.frames.size(), 1U);
  EXPECT_EQ(read.record.frames[0].strain, written.record.frames[0].strain);
  EXPECT_EQ(read.record.contacts->elastic_slip_ratio, written.record.contacts->elastic_slip_ratio);
  for (std::size_t i = 0; i < written.record.peaks.size(); ++i) {
    ASSERT_TRUE(read.record.peaks[i].has_value());
    EXPECT_EQ(read.record.peaks[i]->value, written.record.peaks[i]->value);
    EXPECT_EQ(read.record.peaks[i]->element, written.record.peaks[i]->element);
  }
}

TEST_F(CheckpointFile, GivenARunThatGoesOn_ThenTheFolderIsThatOfARunThatNeverEnded) {
  static_cast<void>(run_beyond_a_checkpoint());
  test::write_text(dir_ / "history.csv.partial", "half a");
  test::write_text(dir_ / "frames" / "frame_0002.vtp.partial", "half a");
  const std::string frame = read_file(dir_ / "frames" / "frame_0000.vtp");
  // When the run is taken up, then all is as it was at the checkpoint.
  RunFolder folder(dir_, read_checkpoint(dir_).record, model_);
  EXPECT_EQ(read_history(dir_ / "history.csv").size(), 2U);
  EXPECT_EQ(read_file(dir_ / "frames" / "frame_0000.vtp"), frame);
  for (const char* gone : {"frame_0001.vtp", "contacts_0001.vtp", "contacts_0001.csv", "frame_0002.vtp.partial"}) {
    EXPECT_FALSE(fs::exists(dir_ / "frames" / gone)) << gone;
  }
  EXPECT_FALSE(fs::exists(dir_ / "history.csv.partial"));
  EXPECT_EQ(read_file(dir_ / "frames" / "frames.pvd").find("frame_0001"), std::string::npos);
  EXPECT_THAT(read_file(dir_ / "summary.json"), HasSubstr("\"running\""));
  EXPECT_TRUE(fs::exists(file_));
  // When it goes on to its end, then its files are those of a run at one go.
  folder.add_history(row_at(0.2));
  folder.add_frame(test::awkward_frame(model_, 1));
  folder.finish({});
  const fs::path at_one_go = temporary_.path() / "whole";
  RunFolder whole(at_one_go, "title = \"x\"\n", model_);
  whole.add_history(row_at(0));
  whole.add_frame(test::awkward_frame(model_, 0));
  whole.add_history(row_at(0.1));
  whole.add_history(row_at(0.2));
  whole.add_frame(test::awkward_frame(model_, 1));
  whole.finish({});
  for (const char* name : {"case.toml", "history.csv", "summary.json", "frames/frames.pvd", "frames/frame_0001.vtp"}) {
    EXPECT_EQ(read_file(dir_ / name), read_file(at_one_go / name)) << name;
  }
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(CheckpointFile, GivenAFileCutOffAnywhere_ThenItIsDamaged) {
  static_cast<void>(run_beyond_a_checkpoint());
  const std::string whole = read_file(file_);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    test::write_text(file_, whole.substr(0, length));
    ASSERT_THAT(complaint(), AllOf(HasSubstr("its checkpoint.bin is damaged"), HasSubstr("start it anew"))) << length;
  }
  test::write_text(file_, whole + "x");
  EXPECT_THAT(complaint(), HasSubstr("is damaged"));
}

TEST_F(CheckpointFile, GivenAnyByteWrong_ThenItIsRefused) {
  static_cast<void>(run_beyond_a_checkpoint());
  const std::string whole = read_file(file_);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] ^ 1);
    test::write_text(file_, wrong);
    ASSERT_THAT(complaint(), HasSubstr("cannot go on")) << at;
  }
}

TEST_F(CheckpointFile, GivenAnotherVersion_ThenTheMessageNamesBoth) {
  static_cast<void>(run_beyond_a_checkpoint());
  std::string text = read_file(file_);
  const std::size_t version = text.find(' ') + 1;
  text.replace(version, text.find(' ', version) - version, "0.0.7");
  test::write_text(file_, text);
  EXPECT_THAT(complaint(), AllOf(HasSubstr("is of KnitMech 0.0.7 and this is "), HasSubstr("start it anew")));
}

TEST_F(CheckpointFile, GivenNothingToResume_ThenTheMessageSaysWhy) {
  EXPECT_THAT(complaint(), HasSubstr("is no folder of a KnitMech run"));
  {
    RunFolder folder(dir_, "", model_);
    EXPECT_THAT(complaint(), HasSubstr("ended before its first checkpoint.bin"));
    folder.finish(ended(model::RunStatus::failed));
    EXPECT_THAT(complaint(), HasSubstr("has failed and would fail again"));
    folder.finish({});
  }
  EXPECT_THAT(complaint(), HasSubstr("is complete; there is nothing to resume"));
}

TEST_F(CheckpointFile, GivenHowARunEnds_ThenItStaysOnlyIfTheRunWasInterrupted) {
  const Checkpoint checkpoint = run_beyond_a_checkpoint();
  RunFolder folder(dir_, checkpoint.record, model_);
  folder.finish(ended(model::RunStatus::interrupted));
  EXPECT_EQ(read_checkpoint(dir_).solver, checkpoint.solver);
  folder.finish(ended(model::RunStatus::failed));
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(CheckpointFile, GivenANewRunInTheFolder_ThenTheOldOneCannotGoOn) {
  static_cast<void>(run_beyond_a_checkpoint());
  const RunFolder anew(dir_, "title = \"y\"\n", model_);
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(CheckpointFile, GivenTheWriter_ThenWhatHasToBeDoneFirstIsAndAFailureIsTold) {
  Checkpoint checkpoint = run_beyond_a_checkpoint();
  fs::remove(file_);
  CheckpointWriter writer(dir_, 0);
  EXPECT_FALSE(writer.is_due());
  bool done_first = false;
  writer.write(checkpoint, [&] { done_first = !fs::exists(file_); });
  checkpoint.solver = "later";
  writer.write(checkpoint, [] {});
  writer.wait();
  EXPECT_TRUE(done_first);
  EXPECT_EQ(read_checkpoint(dir_).solver, "later");
  writer.write(checkpoint, [] { throw FileError("the disk is full"); });
  EXPECT_THAT([&] { writer.wait(); }, ThrowsMessage<FileError>("the disk is full"));
  CheckpointWriter eager(dir_, 1e-9);
  EXPECT_TRUE(eager.is_due());
}

TEST(RunRecord, NamesAllItsMembers) {
  RunRecord record;
  EXPECT_THAT(test::MemberCheck::classes_with_gaps(record), testing::IsEmpty());
}

}  // namespace
}  // namespace knitmech::results
