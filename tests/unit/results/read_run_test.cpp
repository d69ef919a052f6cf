#include "results/read_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "base/errors.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "results/atomic_file.h"
#include "results/frame_file.h"
#include "results/read_frame.h"
#include "results/run_folder.h"
#include "sample_run.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Different numbers, most without a short decimal form, some of them not finite.
class Numbers {
 public:
  double next() {
    ++count_;
    return std::sqrt(count_) * std::pow(10.0, static_cast<int>(count_) % 9 - 5) * (count_ % 3 == 0 ? -1 : 1);
  }
  Eigen::Vector3d vector() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }

 private:
  unsigned count_ = 1;
};

model::HistoryRow row_at(double strain) {
  model::HistoryRow row;
  row.time = strain / 0.7;
  row.strain = strain;
  row.displacement = 27 * strain;
  row.force_top = strain / 3;
  row.force_bottom = strain / 3.1;
  row.external_work = strain * strain;
  row.contacts = 17;
  row.step = 1e-6 / 3;
  return row;
}

/// A frame of the model with a different number in every field, three contacts and some broken elements.
model::Frame frame_of(const model::Model& model, int index, double strain) {
  Numbers numbers;
  model::Frame frame;
  frame.index = index;
  frame.history = row_at(strain);
  std::vector<bool> is_last(model.nodes.size(), false);
  for (const model::ModelYarn& yarn : model.yarns) {
    is_last[static_cast<std::size_t>(yarn.first_node + yarn.n_nodes - 1)] = true;
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    frame.points.push_back(numbers.vector());
    frame.rotations.emplace_back(numbers.next(), numbers.next(), numbers.next(), numbers.next());
    frame.contact_force.push_back(numbers.vector());
    frame.tie_force.push_back(numbers.vector());
    frame.gap.push_back(i % 5 == 2 ? std::numeric_limits<double>::infinity() : numbers.next());
    for (auto* values :
         {&frame.axial_force, &frame.shear_force, &frame.bending_moment, &frame.torque, &frame.axial_strain,
          &frame.curvature, &frame.stretch_energy, &frame.bending_energy, &frame.twist_energy}) {
      values->push_back(is_last[i] ? 0.0 : numbers.next());
    }
  }
  for (int i = 0; i < 3; ++i) {
    frame.contacts.push_back({.first_yarn = i,
                              .second_yarn = i + 1,
                              .first_place = numbers.next(),
                              .second_place = numbers.next(),
                              .position = numbers.vector(),
                              .normal = numbers.vector(),
                              .gap = numbers.next(),
                              .normal_force = numbers.next(),
                              .friction_force = numbers.vector(),
                              .elastic_slip = numbers.next(),
                              .slip = numbers.next(),
                              .slips = i == 1,
                              .angle = 0.1 + i / 3.0});
  }
  return frame;
}

template <typename Value>
std::string bits(const std::vector<Value>& values) {
  std::string bytes(values.size() * sizeof(Value), '\0');
  std::memcpy(bytes.data(), static_cast<const void*>(values.data()), bytes.size());
  return bytes;
}

/// A run of the first example's fabric with made-up results, as the program would leave it.
class ReadRunTest : public testing::Test {
 protected:
  const test::TemporaryFolder temporary_;
  const fs::path dir_ = temporary_.path() / "run";
  const model::Case input_ = model::read_case_file(KNITMECH_SOURCE_DIR "/examples/01-first-loop/case.toml");
  const model::Model model_ = model::build_model(input_);

  void write_run(const std::vector<model::Frame>& frames, bool is_finished = true) {
    RunFolder folder(dir_, model::write_case(input_), model_);
    for (const model::Frame& frame : frames) {
      folder.add_history(frame.history);
      folder.add_frame(frame);
    }
    folder.add_history(row_at(0.2));
    folder.wait_for_frames();
    if (is_finished) folder.finish(outcome());
  }

  [[nodiscard]] static model::RunOutcome outcome() {
    model::RunOutcome outcome;
    outcome.reason = "a yarn broke";
    outcome.advice = "take a stronger one";
    outcome.strain = 0.2;
    outcome.steps = 123456;
    outcome.mass_scaling = 150;
    outcome.threads = 2;
    outcome.wall_seconds = 8;
    outcome.largest_penetration = 0.001;
    model::Ravelling ravelling;
    ravelling.strain = 0.1;
    ravelling.yarn = 2;
    ravelling.other_yarn = 1;
    ravelling.other_place = 3;
    outcome.ravelled = {ravelling};
    outcome.breaks = {{.strain = 0.15, .element = 7, .axial_strain = 0.3, .axial_force = 1.5, .position = {4, 5, 6}}};
    return outcome;
  }
};

TEST_F(ReadRunTest, GivesAFrameBackBitByBit) {
  // Given a run of two frames, of which the second has broken elements: two that follow each other, a yarn's first and
  // the last one of all.
  model::Frame second = frame_of(model_, 1, 0.125);
  second.broken = {0, 7, 8, model_.n_nodes() - 2};
  write_run({frame_of(model_, 0, 0), second});
  // When it is read back.
  const StoredRun run = read_run(dir_);
  const model::Frame frame = read_frame(run, 1);
  // Then all fields are the same.
  EXPECT_EQ(frame.index, 1);
  EXPECT_EQ(bits(frame.points), bits(second.points));
  EXPECT_EQ(bits(frame.rotations), bits(second.rotations));
  EXPECT_EQ(bits(frame.contact_force), bits(second.contact_force));
  EXPECT_EQ(bits(frame.tie_force), bits(second.tie_force));
  EXPECT_EQ(bits(frame.gap), bits(second.gap));
  for (const auto member :
       {&model::Frame::axial_force, &model::Frame::shear_force, &model::Frame::bending_moment, &model::Frame::torque,
        &model::Frame::axial_strain, &model::Frame::curvature, &model::Frame::stretch_energy,
        &model::Frame::bending_energy, &model::Frame::twist_energy}) {
    EXPECT_EQ(bits(frame.*member), bits(second.*member));
  }
  EXPECT_EQ(frame.broken, second.broken);
  EXPECT_EQ(frame.history.contacts, 17);
  EXPECT_EQ(frame.history.step, second.history.step);
  EXPECT_EQ(frame.history.external_work, second.history.external_work);
  EXPECT_EQ(read_frame(run, 0).broken, std::vector<int>{});
}

TEST_F(ReadRunTest, GivesTheContactsOfAFrameBack) {
  const model::Frame written = frame_of(model_, 0, 0.125);
  write_run({written});
  const model::Frame read = read_frame(read_run(dir_), 0);
  ASSERT_EQ(read.contacts.size(), written.contacts.size());
  for (std::size_t i = 0; i < read.contacts.size(); ++i) {
    const model::ContactRecord& a = read.contacts[i];
    const model::ContactRecord& b = written.contacts[i];
    EXPECT_EQ(a.first_yarn, b.first_yarn);
    EXPECT_EQ(a.second_yarn, b.second_yarn);
    EXPECT_EQ(a.first_place, b.first_place);
    EXPECT_EQ(a.second_place, b.second_place);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.gap, b.gap);
    EXPECT_EQ(a.normal_force, b.normal_force);
    EXPECT_EQ(a.friction_force, b.friction_force);
    EXPECT_EQ(a.elastic_slip, b.elastic_slip);
    EXPECT_EQ(a.slip, b.slip);
    EXPECT_EQ(a.slips, b.slips);
    // The file has degrees, from which radians come back within rounding.
    EXPECT_NEAR(a.angle, b.angle, 4e-16);
  }
}

TEST_F(ReadRunTest, GivesCaseModelHistoryAndFramesBack) {
  write_run({frame_of(model_, 0, 0), frame_of(model_, 1, 0.08), frame_of(model_, 2, 0.2)});
  const StoredRun run = read_run(dir_);
  EXPECT_EQ(model::write_case(run.input), model::write_case(input_));
  EXPECT_EQ(bits(run.model.nodes), bits(model_.nodes));
  ASSERT_EQ(run.history.size(), 4U);
  EXPECT_EQ(run.history[1].strain, 0.08);
  ASSERT_EQ(run.frames.size(), 3U);
  EXPECT_EQ(run.frames[2].index, 2);
  EXPECT_EQ(run.frames[2].strain, 0.2);
  // The nearest frame to a strain, also outside of the test; the first of two that are as near.
  EXPECT_EQ(nearest_frame(run, 0.09).index, 1);
  EXPECT_EQ(nearest_frame(run, 0.04).index, 0);
  EXPECT_EQ(nearest_frame(run, 7).index, 2);
}

TEST_F(ReadRunTest, GivesTheSummaryBack) {
  model::Frame frame = frame_of(model_, 0, 0);
  frame.axial_force.assign(model_.nodes.size(), 0.0);
  frame.axial_force[7] = -2.5;
  write_run({frame});
  const RunSummary summary = read_run(dir_).summary;
  EXPECT_EQ(summary.title, input_.title);
  EXPECT_EQ(summary.status, "completed");
  EXPECT_EQ(summary.reason, "a yarn broke");
  EXPECT_EQ(summary.advice, "take a stronger one");
  EXPECT_EQ(summary.model.yarns, 5);
  EXPECT_EQ(summary.model.nodes, 505);
  EXPECT_EQ(summary.model.elements, 500);
  EXPECT_EQ(summary.model.gauge_length, model_.test.gauge_length);
  EXPECT_EQ(summary.mass_scaling, 150);
  EXPECT_EQ(summary.threads, 2);
  EXPECT_EQ(summary.steps, 123456);
  EXPECT_EQ(summary.wall_seconds, 8);
  EXPECT_EQ(summary.element_steps_per_s, 500.0 * 123456 / 8);
  EXPECT_EQ(summary.strain, 0.2);
  EXPECT_EQ(summary.tie_stretch, std::nullopt);
  ASSERT_TRUE(summary.contacts);
  EXPECT_EQ(summary.contacts->contacts, 3);
  ASSERT_TRUE(summary.quality);
  EXPECT_THAT(summary.quality->verdict, HasSubstr("."));
  EXPECT_EQ(summary.quality->penetration, 0.001);
  ASSERT_TRUE(summary.largest_in_yarns[0]);
  EXPECT_EQ(summary.largest_in_yarns[0]->value, -2.5);
  EXPECT_EQ(summary.largest_in_yarns[0]->place.part, place_of_element(model_, 7).part);
  ASSERT_EQ(summary.breaks.size(), 1U);
  EXPECT_EQ(summary.breaks[0].axial_force, 1.5);
  EXPECT_EQ(summary.breaks[0].position, Eigen::Vector3d(4, 5, 6));
  ASSERT_EQ(summary.ravelled.size(), 1U);
  EXPECT_EQ(summary.ravelled[0].place.course, 3);
}

TEST_F(ReadRunTest, ReadsARunThatIsStillUnderWay) {
  write_run({frame_of(model_, 0, 0)}, /*is_finished=*/false);
  const StoredRun run = read_run(dir_);
  EXPECT_EQ(run.summary.status, "running");
  EXPECT_EQ(run.summary.steps, std::nullopt);
  EXPECT_FALSE(run.summary.quality);
  EXPECT_EQ(read_frame(run, 0).contacts.size(), 3U);
}

TEST_F(ReadRunTest, SaysWhatAFolderLacks) {
  const auto reading = [this] { return read_run(dir_); };
  EXPECT_THAT(reading, ThrowsMessage<InputError>("There is no folder " + dir_.string() + "."));
  fs::create_directories(dir_.parent_path());
  test::write_text(dir_, "x");
  EXPECT_THAT(reading, ThrowsMessage<InputError>(EndsWith("is a file; give the folder of a run.")));
  fs::remove(dir_);
  fs::create_directories(dir_);
  EXPECT_THAT(reading, ThrowsMessage<InputError>(EndsWith("is not the folder of a run: it has no summary.json.")));
  test::write_text(dir_ / "summary.json", "{\"format\": \"other\"}");
  EXPECT_THAT(reading, ThrowsMessage<InputError>(HasSubstr("is not the summary of a KnitMech run")));
  test::write_text(dir_ / "summary.json", "{\"format\": \"knitmech-run\", \"schema\": 99}");
  EXPECT_THAT(reading, ThrowsMessage<InputError>(HasSubstr("another version")));
}

TEST_F(ReadRunTest, SaysThatNoFrameIsStored) {
  write_run({}, /*is_finished=*/false);
  EXPECT_THAT([this] { return read_run(dir_); }, ThrowsMessage<InputError>(HasSubstr("it is under way")));
  write_run({});
  EXPECT_THAT([this] { return read_run(dir_); }, ThrowsMessage<InputError>(HasSubstr("it ended before")));
}

TEST_F(ReadRunTest, SaysThatTheCaseWasChangedSince) {
  write_run({frame_of(model_, 0, 0)});
  model::Case other = input_;
  other.fabric.wales += 1;
  test::write_text(dir_ / "case.toml", model::write_case(other));
  EXPECT_THAT([this] { return read_run(dir_); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("case.toml"), HasSubstr("changed since"))));
}

TEST_F(ReadRunTest, NamesTheFramesThatThereAre) {
  write_run({frame_of(model_, 0, 0), frame_of(model_, 1, 0.1)});
  const StoredRun run = read_run(dir_);
  EXPECT_THAT([&run] { return read_frame(run, 7); },
              ThrowsMessage<InputError>(EndsWith("has no frame 7; it has 0 to 1.")));
  EXPECT_THROW(static_cast<void>(read_frame(run, -1)), InputError);
}

TEST_F(ReadRunTest, NamesTheMissingFile) {
  write_run({frame_of(model_, 0, 0)});
  const StoredRun run = read_run(dir_);
  fs::remove(dir_ / "frames" / "contacts_0000.csv");
  EXPECT_THAT([&run] { return read_frame(run, 0); }, ThrowsMessage<FileError>(HasSubstr("contacts_0000.csv")));
  fs::remove(dir_ / "history.csv");
  EXPECT_THAT([this] { return read_run(dir_); }, ThrowsMessage<FileError>(HasSubstr("history.csv")));
}

TEST_F(ReadRunTest, TakesNoFrameOfAnotherModel) {
  // Given a frame of a model of two yarns in place of that of the run.
  write_run({frame_of(model_, 0, 0)});
  const model::Model other = test::two_yarn_model();
  const StoredRun run = read_run(dir_);
  const fs::path file = dir_ / "frames" / "frame_0000.vtp";
  test::write_text(file, frame_text(other, test::awkward_frame(other, 0)));
  // Then reading it says so.
  EXPECT_THAT(
      [&run] { return read_frame(run, 0); },
      ThrowsMessage<InputError>(AllOf(HasSubstr(file.string()), HasSubstr("7 points"), HasSubstr("505 nodes"))));
}

/// Reads a run with its frame. \return what is wrong; empty if nothing is. Any other exception fails the test.
std::string complaint(const fs::path& dir) {
  try {
    static_cast<void>(read_frame(read_run(dir), 0));
    return "";
  } catch (const InputError& error) {
    return error.what();
  } catch (const FileError& error) {
    return error.what();
  }
}

class DamagedRunTest : public ReadRunTest, public testing::WithParamInterface<const char*> {};

TEST_P(DamagedRunTest, IsRefusedWithTheNameOfTheFileOrReadAsItStands) {
  // Given a run of which one file is cut off, at places all over it.
  write_run({frame_of(model_, 0, 0)});
  const fs::path file = dir_ / GetParam();
  const std::string whole = read_file(file);
  ASSERT_EQ(complaint(dir_), "");
  constexpr std::size_t kPlaces = 20;
  std::size_t n_refused = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    test::write_text(file, whole.substr(0, whole.size() * i / kPlaces));
    // Then it is read as what is left, or refused in a sentence; the program never crashes.
    const std::string said = complaint(dir_);
    if (said.empty()) continue;
    ++n_refused;
    EXPECT_THAT(said, HasSubstr(file.filename().string()));
  }
  EXPECT_GT(n_refused, 0U);
  // And the same with a bit turned over, at places in a fixed order.
  std::uint32_t state = 12345;
  for (unsigned i = 0; i < 80; ++i) {
    state = state * 1664525U + 1013904223U;
    std::string damaged = whole;
    char& letter = damaged[state % damaged.size()];
    letter = static_cast<char>(letter ^ static_cast<char>(1U << (i % 8)));
    test::write_text(file, damaged);
    const std::string said = complaint(dir_);
    EXPECT_TRUE(said.empty() || said.find(dir_.string()) != std::string::npos) << said;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, DamagedRunTest,
                         testing::Values("summary.json", "case.toml", "history.csv", "frames/frames.pvd",
                                         "frames/frame_0000.vtp", "frames/contacts_0000.csv"),
                         [](const auto& one) {
                           std::string name = fs::path(one.param).filename().string();
                           std::erase_if(name, [](char c) { return c == '.' || c == '_'; });
                           return name;
                         });

}  // namespace
}  // namespace knitmech::results
