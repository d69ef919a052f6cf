#include "results/run_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/constants.h"
#include "results/contact_file.h"
#include "results/history_file.h"
#include "sample_run.h"
#include "vtk_xml_reader.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

class RunFolderTest : public testing::Test {
 protected:
  const test::TemporaryFolder temporary_;
  const fs::path dir_ = temporary_.path() / "runs" / "first";
  const model::Model model_ = test::two_yarn_model();

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(dir_)) {
      if (entry.is_regular_file()) {
        names.push_back(fs::relative(entry.path(), dir_).string());
      }
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  [[nodiscard]] json summary() const { return json::parse(read_file(dir_ / "summary.json")); }
};

model::HistoryRow row_at(double strain) {
  model::HistoryRow row;
  row.time = 10 * strain;
  row.strain = strain;
  row.external_work = row.internal_energy = strain * strain;
  row.force_top = row.force_bottom = strain;
  return row;
}

TEST_F(RunFolderTest, SaysByHowMuchTiesGaveWayInMillimetresAndDiametersIfThereAreAny) {
  model::RunOutcome outcome;
  outcome.largest_tie_stretch = 0.003;
  {
    RunFolder without_ties(dir_, "", model_);
    without_ties.finish(outcome);
  }
  EXPECT_TRUE(summary().at("largest").at("tie_stretch_mm").is_null());
  EXPECT_TRUE(summary().at("largest").at("tie_stretch_ratio").is_null());

  model::Model tied = model_;
  tied.ties = {{{0, 0.5}, {3, 0.5}}};
  RunFolder with_ties(dir_, "", tied);
  with_ties.finish(outcome);
  EXPECT_EQ(summary().at("largest").at("tie_stretch_mm"), 0.003);
  EXPECT_NEAR(summary().at("largest").at("tie_stretch_ratio").get<double>(), 0.003 / 0.12, 1e-15);
}

TEST_F(RunFolderTest, IsTakenByNoOtherRunWhileOneWritesIt) {
  {
    RunFolder first(dir_, "[loop]", model_);
    EXPECT_TRUE(may_be_written(dir_));
    EXPECT_THAT([&] { RunFolder(dir_, "[other]", model_); },
                ThrowsMessage<InputError>(HasSubstr("the folder of a run under way")));
    EXPECT_EQ(read_file(dir_ / "case.toml"), "[loop]");
  }
  EXPECT_FALSE(may_be_written(dir_));
  EXPECT_NO_THROW(RunFolder(dir_, "[other]", model_));
}

TEST_F(RunFolderTest, GivenAFileOfYarns_ThenACopyLiesBesideTheCaseUntilARunWithoutOne) {
  const curves::YarnFile yarns{
      .path = "my/swatch.bcc", .ending = ".bcc", .bytes = std::string("BCC\0x", 5), .lines = {}};
  { const RunFolder folder(dir_, "[first]", model_, &yarns); }
  EXPECT_EQ(read_file(dir_ / "yarns.bcc"), yarns.bytes);
  { const RunFolder folder(dir_, "[second]", model_); }
  EXPECT_FALSE(fs::exists(dir_ / "yarns.bcc"));
}

TEST_F(RunFolderTest, HoldsTheFilesOfARun) {
  // Given a run of three rows and two frames.
  RunFolder folder(dir_, "title = \"x\"\n", model_);
  folder.add_history(row_at(0));
  folder.add_frame(test::awkward_frame(model_, 0));
  folder.add_history(row_at(0.1));
  folder.add_history(row_at(0.2));
  folder.add_frame(test::awkward_frame(model_, 1));
  folder.log("first line");
  folder.log("second line");
  folder.finish(model::RunOutcome{});
  // Then the folder holds these files, and no temporary one.
  EXPECT_THAT(files(),
              ElementsAre("case.toml", "frames/contacts.pvd", "frames/contacts_0000.csv", "frames/contacts_0000.vtp",
                          "frames/contacts_0001.csv", "frames/contacts_0001.vtp", "frames/frame_0000.vtp",
                          "frames/frame_0001.vtp", "frames/frames.pvd", "history.csv", "log.txt", "summary.json"));
  EXPECT_EQ(read_file(dir_ / "case.toml"), "title = \"x\"\n");
  EXPECT_EQ(read_file(dir_ / "log.txt"), "first line\nsecond line\n");
  const std::vector<model::HistoryRow> history = read_history(dir_ / "history.csv");
  ASSERT_EQ(history.size(), 3U);
  EXPECT_EQ(history[1].strain, 0.1);
  EXPECT_TRUE(test::read_vtk_xml(read_file(dir_ / "frames" / "frame_0001.vtp")).well_formed);
  EXPECT_THAT(read_file(dir_ / "frames" / "frames.pvd"), HasSubstr("file=\"frame_0001.vtp\""));
  EXPECT_THAT(read_file(dir_ / "frames" / "contacts.pvd"), HasSubstr("file=\"contacts_0001.vtp\""));
}

TEST_F(RunFolderTest, HoldsTheContactsOfEachFrameForTablesAndForParaView) {
  // Given a frame with three contacts and one with two.
  RunFolder folder(dir_, "", model_);
  const model::Frame three = test::awkward_frame(model_, 0);
  model::Frame two = test::awkward_frame(model_, 1);
  two.contacts.pop_back();
  // When they are written.
  folder.add_frame(three);
  folder.add_frame(two);
  folder.wait_for_frames();
  // Then each has the table and the points of its own contacts.
  const fs::path frames = dir_ / "frames";
  EXPECT_EQ(read_file(frames / "contacts_0000.csv"), contact_table_text(model_, three));
  EXPECT_EQ(read_file(frames / "contacts_0001.csv"), contact_table_text(model_, two));
  EXPECT_EQ(test::read_vtk_xml(read_file(frames / "contacts_0000.vtp")).piece.at("NumberOfPoints"), "3");
  EXPECT_EQ(test::read_vtk_xml(read_file(frames / "contacts_0001.vtp")).piece.at("NumberOfPoints"), "2");
}

TEST_F(RunFolderTest, TheSummaryNamesTheStagesAndMeasuresTheCurveAtTheFrames) {
  // Given a curve whose strain energy, the square of the strain, reaches 0.03 EI / l of its half stitches at 0.1.
  model::Model model = model_;
  model.half_stitch_length = 0.5;
  const double n_half_stitches = (0.2 + 0.6) / 0.5;  // the last nodes of the two yarns
  model.sections.front().bending_stiffness = 0.1 * 0.1 / kToeEnergy * 0.5 / n_half_stitches;
  RunFolder folder(dir_, "", model);
  for (int i = 0; i <= 20; ++i) {
    model::HistoryRow row = row_at(0.01 * i);
    row.width = 10 - 2 * row.strain;
    folder.add_history(row);
    model::Frame frame = test::awkward_frame(model, i / 20);
    frame.history = row;
    if (i % 20 == 0) folder.add_frame(frame);
  }
  folder.finish(model::RunOutcome{});
  // Then the toe ends there, the bending stage at the end; the force rises by 1 N, 0.1 N/mm, per unit of strain.
  const json stages = summary().at("stages");
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[0].at("name"), "toe");
  EXPECT_NEAR(stages[0].at("to_strain").get<double>(), 0.1, 1e-3);
  EXPECT_EQ(stages[1].at("name"), "bending");
  EXPECT_EQ(stages[1].at("to_strain"), 0.2);
  EXPECT_NEAR(stages[1].at("slope_N").get<double>(), 1, 1e-12);
  EXPECT_NEAR(stages[1].at("slope_N_per_mm").get<double>(), 0.1, 1e-13);
  const json measures = summary().at("measures");
  EXPECT_TRUE(measures.at("stretch_strain").is_null());
  ASSERT_EQ(measures.at("at").size(), 2U);
  EXPECT_TRUE(measures.at("at")[0].at("poissons_ratio").is_null());
  EXPECT_NEAR(measures.at("at")[1].at("poissons_ratio").get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(measures.at("at")[1].at("force_N_per_mm").get<double>(), 0.02, 1e-12);
}

TEST_F(RunFolderTest, TheSummaryCountsAndJudges) {
  RunFolder folder(dir_, "", model_);
  for (int i = 0; i <= 20; ++i) {
    folder.add_history(row_at(0.01 * i));
  }
  model::RunOutcome outcome;
  outcome.status = model::RunStatus::interrupted;
  outcome.strain = 0.2;
  outcome.steps = 1000;
  outcome.largest_penetration = 0.012;
  outcome.mass_scaling = 100;
  outcome.wall_seconds = 2;
  folder.finish(outcome);
  const json document = summary();
  EXPECT_EQ(document["format"], "knitmech-run");
  EXPECT_EQ(document["status"], "interrupted");
  EXPECT_EQ(document["title"], "two yarns");
  EXPECT_EQ(document["model"]["yarns"], 2);
  EXPECT_EQ(document["model"]["nodes"], 7);
  EXPECT_EQ(document["model"]["elements"], 5);
  EXPECT_EQ(document["model"]["degrees_of_freedom"], 42);
  EXPECT_EQ(document["output"]["history_rows"], 21);
  EXPECT_EQ(document["solver"]["mass_scaling"], 100);
  EXPECT_EQ(document["solver"]["element_steps_per_s"], 2500);
  EXPECT_EQ(document["final"]["strain"], 0.2);
  EXPECT_EQ(document["final"]["force_top_N"], 0.2);
  EXPECT_EQ(document["largest"]["penetration_mm"], 0.012);
  EXPECT_EQ(document["quality"]["quasi_static"], true);
  EXPECT_NEAR(document["quality"]["penetration_ratio"].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(document["quality"]["crossings_kept"], true);
}

TEST_F(RunFolderTest, TheSummaryOfAFailedRunWithoutHistoryHasNullsAndNoNotANumber) {
  RunFolder folder(dir_, "", model_);
  model::RunOutcome outcome;
  outcome.status = model::RunStatus::failed;
  outcome.reason = "the step collapsed";
  outcome.advice = "use less mass scaling";
  folder.finish(outcome);
  const json document = summary();
  EXPECT_EQ(document["status"], "failed");
  EXPECT_EQ(document["reason"], "the step collapsed");
  EXPECT_EQ(document["advice"], "use less mass scaling");
  EXPECT_TRUE(document["final"]["force_top_N"].is_null());
  EXPECT_TRUE(document["quality"]["kinetic_ratio"].is_null());
  EXPECT_TRUE(document["solver"]["element_steps_per_s"].is_null());
}

TEST_F(RunFolderTest, TheSummarySumsUpTheContactsOfTheLastFrame) {
  // Given a frame with contacts, then one with a contact that slips and one that sticks, and a history in which the
  // elastic slip and the normal force were largest before the end.
  RunFolder folder(dir_, "", model_);
  folder.add_frame(test::awkward_frame(model_, 0));
  model::Frame last = test::awkward_frame(model_, 1);
  last.contacts = {{.first_yarn = 0, .second_yarn = 1, .normal_force = 0.5, .elastic_slip = 0.0006},
                   {.first_yarn = 1, .second_yarn = 1, .normal_force = 0.25, .slips = true}};
  folder.add_frame(last);
  for (const auto& [normal_force, elastic_slip] : {std::pair{0.1, 0.0}, {2.0, 0.0012}, {0.75, 0.0006}}) {
    model::HistoryRow row = row_at(0.1);
    row.normal_force = normal_force;
    row.largest_elastic_slip = elastic_slip;
    folder.add_history(row);
  }
  // When the run ends.
  folder.finish({});
  // Then the summary has the contacts of the end, the diameter being the 0.12 mm of the thinner yarn, and the largest
  // of the whole run.
  const json document = summary();
  const json& contact = document["contact"];
  EXPECT_EQ(contact["contacts"], 2);
  EXPECT_EQ(contact["normal_force_N"], 0.75);
  EXPECT_EQ(contact["slipping_share"], 0.5);
  EXPECT_EQ(contact["elastic_slip_mm"], 0.0006);
  EXPECT_DOUBLE_EQ(contact["elastic_slip_ratio"].get<double>(), 0.005);
  EXPECT_EQ(document["largest"]["contact_normal_force_N"], 2.0);
  EXPECT_EQ(document["quality"]["elastic_slip_mm"], 0.0012);
  EXPECT_DOUBLE_EQ(document["quality"]["elastic_slip_ratio"].get<double>(), 0.01);
}

TEST_F(RunFolderTest, TheSummaryOfARunWithoutFramesKnowsNoContacts) {
  RunFolder folder(dir_, "", model_);
  folder.finish({});
  const json document = summary();
  const json& contact = document["contact"];
  for (const char* key : {"contacts", "normal_force_N", "slipping_share", "elastic_slip_mm", "elastic_slip_ratio"}) {
    ASSERT_TRUE(contact.contains(key)) << key;
    EXPECT_TRUE(contact[key].is_null()) << key;
  }
}

TEST_F(RunFolderTest, ARunThatIsKilledKeepsWhatWasThereAtItsLastFrame) {
  {
    RunFolder folder(dir_, "", model_);
    folder.add_history(row_at(0));
    folder.add_history(row_at(0.1));
    folder.add_frame(test::awkward_frame(model_, 0));
    folder.add_history(row_at(0.2));
  }  // never finished
  EXPECT_GE(read_history(dir_ / "history.csv").size(), 2U);
  EXPECT_EQ(summary()["status"], "running");
}

TEST_F(RunFolderTest, AnOlderRunIsClearedOfItsOwnFilesOnly) {
  {
    RunFolder older(dir_, "older", model_);
    older.log("older");
    older.add_history(row_at(0.3));
    older.add_frame(test::awkward_frame(model_, 0));
    older.add_frame(test::awkward_frame(model_, 7));
  }
  test::write_text(dir_ / "notes.txt", "mine");
  test::write_text(dir_ / "frames" / "frame_final.vtp", "mine");
  test::write_text(dir_ / "frames" / "contacts_of_course_3.csv", "mine");
  for (const char* name : {"frame_0003.vtp", "contacts_0003.vtp", "contacts_0003.csv", "contacts.pvd"}) {
    test::write_text(dir_ / "frames" / (std::string{name} + ".partial"), "left by a killed run");
  }
  const RunFolder newer(dir_, "newer", model_);
  EXPECT_THAT(files(),
              ElementsAre("case.toml", "frames/contacts.pvd", "frames/contacts_of_course_3.csv",
                          "frames/frame_final.vtp", "frames/frames.pvd", "history.csv", "notes.txt", "summary.json"));
  EXPECT_THAT(read_file(dir_ / "frames" / "contacts.pvd"), Not(HasSubstr("contacts_0000.vtp")));
  EXPECT_EQ(read_file(dir_ / "case.toml"), "newer");
  EXPECT_TRUE(read_history(dir_ / "history.csv").empty());
}

TEST_F(RunFolderTest, AForeignFolderIsNeverTouched) {
  // Given folders with a user's files, also with names and JSON like ours.
  fs::create_directories(dir_);
  for (const std::string text : {"", "not json", "[1, 2]", "{\"format\": \"other\"}"}) {
    test::write_text(dir_ / "case.toml", "mine");
    test::write_text(dir_ / "summary.json", text);
    EXPECT_THAT([&] { RunFolder(dir_, "", model_); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(dir_.string()), HasSubstr("not a KnitMech run"))));
    EXPECT_THAT(files(), ElementsAre("case.toml", "summary.json"));
    EXPECT_EQ(read_file(dir_ / "case.toml"), "mine");
    EXPECT_EQ(read_file(dir_ / "summary.json"), text);
  }
  // An empty folder is fine.
  fs::create_directories(temporary_.path() / "empty");
  EXPECT_NO_THROW(RunFolder(temporary_.path() / "empty", "", model_));
}

TEST_F(RunFolderTest, AFileInThePlaceOfTheFolderIsRefused) {
  test::write_text(temporary_.path() / "file", "mine");
  EXPECT_THAT([&] { RunFolder(temporary_.path() / "file", "", model_); },
              ThrowsMessage<InputError>(HasSubstr("is a file")));
  EXPECT_THAT([&] { RunFolder(temporary_.path() / "file" / "below", "", model_); },
              ThrowsMessage<FileError>(HasSubstr("below")));
  EXPECT_EQ(read_file(temporary_.path() / "file"), "mine");
}

TEST_F(RunFolderTest, AFolderThatVanishesIsAFileError) {
  RunFolder folder(dir_, "", model_);
  fs::remove_all(dir_);
  EXPECT_THAT([&] { folder.add_frame(test::awkward_frame(model_, 0)); },
              ThrowsMessage<FileError>(HasSubstr("history.csv")));
  EXPECT_THAT([&] { folder.log("line"); }, ThrowsMessage<FileError>(HasSubstr("log.txt")));
  EXPECT_THAT([&] { folder.finish({}); }, ThrowsMessage<FileError>(HasSubstr("history.csv")));
}

TEST_F(RunFolderTest, AFrameThatCannotBeWrittenIsAFileErrorOfTheNextCall) {
  // Given a disk that is full when the frame is written, beside the run.
  RunFolder folder(dir_, "", model_);
  fs::create_symlink("/dev/full", dir_ / "frames" / "frame_0000.vtp.partial");
  folder.add_frame(test::awkward_frame(model_, 0));
  // Then whoever waits for it learns why, and so does the run with its next row, and its end.
  const auto says_why = ThrowsMessage<FileError>(AllOf(HasSubstr("frame_0000.vtp"), HasSubstr("No space left")));
  EXPECT_THAT([&] { folder.wait_for_frames(); }, says_why);
  EXPECT_THAT([&] { folder.add_history(row_at(0.1)); }, says_why);
  EXPECT_THAT([&] { folder.finish({}); }, says_why);
  // And the run is not called finished.
  EXPECT_EQ(summary()["status"], "running");
}

TEST_F(RunFolderTest, AFullDiskWhileLoggingIsAFileError) {
  RunFolder folder(dir_, "", model_);
  fs::create_symlink("/dev/full", dir_ / "log.txt");
  EXPECT_THAT([&] { folder.log("line"); },
              ThrowsMessage<FileError>(AllOf(HasSubstr("log.txt"), HasSubstr("No space left"))));
}

}  // namespace
}  // namespace knitmech::results
