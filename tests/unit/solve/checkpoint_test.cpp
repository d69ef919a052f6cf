// Runs that go on from a checkpoint: 2 wales x 3 courses at N10, bit for bit.

#include "solve/checkpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "../../support/member_check.h"
#include "../model/example_case.h"
#include "base/errors.h"
#include "model/build_model.h"
#include "results/contact_file.h"
#include "results/frame_file.h"
#include "results/history_file.h"
#include "solve/simulate.h"

namespace knitmech {
namespace {

struct Scene {
  const char* name;
  knit::Structure structure;
  model::Centreline centreline;
  double strain;
  bool adapts_pace = false;
  std::optional<double> strength = {};  ///< [N]
  double mass_damping = 0;              ///< [1/s]
};

std::ostream& operator<<(std::ostream& stream, const Scene& scene) {
  return stream << scene.name;
}

const std::vector<Scene> kScenes = {
    {"basic_smooth_paced", knit::Structure::basic, model::Centreline::smooth, 0.12, true},
    {"basic_chords", knit::Structure::basic, model::Centreline::chords, 0.08, false, {}, 5},
    {"tied_smooth", knit::Structure::tied, model::Centreline::smooth, 0.12},
    {"tied_chords_paced", knit::Structure::tied, model::Centreline::chords, 0.2, true},
    {"adjusted_smooth_paced", knit::Structure::adjusted, model::Centreline::smooth, 0.12, true},
    {"adjusted_chords", knit::Structure::adjusted, model::Centreline::chords, 0.12},
    {"tied_smooth_breaking", knit::Structure::tied, model::Centreline::smooth, 0.35, false, 0.015},
    {"tied_chords_breaking_paced", knit::Structure::tied, model::Centreline::chords, 0.35, true, 0.015},
};

model::Model model_of(const Scene& scene) {
  model::Case input = model::example_case();
  input.fabric.wales = 2;
  input.fabric.courses = 3;
  input.fabric.structure = scene.structure;
  input.contact.centreline = scene.centreline;
  input.yarn.strength = scene.strength;
  input.test = {.strain = scene.strain, .speed = 20, .ramp = 0.05, .on_break = model::OnBreak::go_on};
  return model::build_model(input);
}

solve::SimulationSettings settings_of(const Scene& scene) {
  solve::SimulationSettings settings;
  settings.mass_scaling = 2e3;
  settings.mass_damping = scene.mass_damping;
  settings.history_points = 40;
  settings.frames_at = {0.4 * scene.strain};
  settings.adapts_pace = scene.adapts_pace;
  return settings;
}

/// Everything that a run says, in texts that give every number to the last bit.
struct Heard {
  std::vector<std::string> rows, frames;
  std::vector<std::string> checkpoints;
  std::vector<std::size_t> rows_at, frames_at;  ///< of each checkpoint, how many there were
  int views = 0;
  model::RunOutcome outcome;
};

/// \param every rows between two checkpoints; 0: none \param is_watched at every chance
Heard run(const model::Model& model, const solve::SimulationSettings& settings, std::size_t every,
          const std::string& from = {}, bool is_watched = false) {
  Heard heard;
  std::size_t last = 0;
  solve::SimulationCallbacks callbacks;
  callbacks.on_history = [&](const model::HistoryRow& row) { heard.rows.push_back(results::history_line(row)); };
  callbacks.on_frame = [&](const model::Frame& frame) {
    heard.frames.push_back(results::frame_text(model, frame) + results::contact_table_text(model, frame));
  };
  callbacks.wants_checkpoint = [&] { return every > 0 && heard.rows.size() >= last + every; };
  callbacks.on_checkpoint = [&](const std::string& checkpoint) {
    last = heard.rows.size();
    heard.checkpoints.push_back(checkpoint);
    heard.rows_at.push_back(heard.rows.size());
    heard.frames_at.push_back(heard.frames.size());
  };
  callbacks.wants_view = [&] { return is_watched; };
  callbacks.on_view = [&](const model::Frame&) { ++heard.views; };
  heard.outcome = solve::simulate(model, settings, callbacks, from);
  return heard;
}

std::vector<std::string> after(const std::vector<std::string>& all, std::size_t first) {
  return {all.begin() + static_cast<std::ptrdiff_t>(first), all.end()};
}

void expect_same_outcome(const model::RunOutcome& a, const model::RunOutcome& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.strain, b.strain);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.smallest_step, b.smallest_step);
  EXPECT_EQ(a.largest_penetration, b.largest_penetration);
  EXPECT_EQ(a.largest_tie_stretch, b.largest_tie_stretch);
  EXPECT_EQ(a.mass_scaling, b.mass_scaling);
  EXPECT_EQ(a.crossing_checks, b.crossing_checks);
  ASSERT_EQ(a.breaks.size(), b.breaks.size());
  for (std::size_t i = 0; i < a.breaks.size(); ++i) {
    EXPECT_EQ(a.breaks[i].element, b.breaks[i].element);
    EXPECT_EQ(a.breaks[i].strain, b.breaks[i].strain);
    EXPECT_EQ(a.breaks[i].axial_force, b.breaks[i].axial_force);
  }
  ASSERT_EQ(a.ravelled.size(), b.ravelled.size());
  for (std::size_t i = 0; i < a.ravelled.size(); ++i) {
    EXPECT_EQ(a.ravelled[i].strain, b.ravelled[i].strain);
    EXPECT_EQ(a.ravelled[i].yarn, b.ravelled[i].yarn);
    EXPECT_EQ(a.ravelled[i].position, b.ravelled[i].position);
  }
}

class CheckpointOf : public testing::TestWithParam<Scene> {};

TEST_P(CheckpointOf, ARun_GivenThatItGoesOnFromThere_OnAnyNumberOfThreads_ThenEveryRowAndFrameIsTheSameToTheLastBit) {
  const model::Model model = model_of(GetParam());
  const solve::SimulationSettings settings = settings_of(GetParam());
  const Heard whole = run(model, settings, 0);
  const Heard watched = run(model, settings, 9);
  ASSERT_EQ(whole.outcome.status, model::RunStatus::completed) << whole.outcome.reason;
  ASSERT_GE(watched.checkpoints.size(), 3U);
  EXPECT_EQ(watched.rows, whole.rows);
  EXPECT_EQ(watched.frames, whole.frames);
  ASSERT_EQ(whole.outcome.breaks.empty(), !GetParam().strength);
  for (std::size_t k = 0; k < watched.checkpoints.size(); ++k) {
    SCOPED_TRACE(k);
    solve::SimulationSettings other_threads = settings;
    other_threads.threads = 1 + static_cast<int>(k);
    const Heard resumed = run(model, other_threads, 0, watched.checkpoints[k]);
    EXPECT_EQ(resumed.rows, after(whole.rows, watched.rows_at[k]));
    EXPECT_EQ(resumed.frames, after(whole.frames, watched.frames_at[k]));
    EXPECT_EQ(resumed.outcome.threads, other_threads.threads);
    expect_same_outcome(resumed.outcome, whole.outcome);
    EXPECT_GT(resumed.outcome.wall_seconds, 0);
  }
}

TEST_P(CheckpointOf, ARun_GivenThatSomeoneWatchesIt_AndItGoesOn_ThenEveryRowAndFrameIsTheSameToTheLastBit) {
  const model::Model model = model_of(GetParam());
  const solve::SimulationSettings settings = settings_of(GetParam());
  const Heard whole = run(model, settings, 0);
  const Heard watched = run(model, settings, 15, {}, true);
  EXPECT_EQ(whole.views, 0);
  EXPECT_GT(watched.views, 20);
  EXPECT_EQ(watched.rows, whole.rows);
  EXPECT_EQ(watched.frames, whole.frames);
  expect_same_outcome(watched.outcome, whole.outcome);
  ASSERT_FALSE(watched.checkpoints.empty());
  const Heard resumed = run(model, settings, 0, watched.checkpoints.front(), true);
  EXPECT_EQ(resumed.rows, after(whole.rows, watched.rows_at.front()));
  EXPECT_EQ(resumed.frames, after(whole.frames, watched.frames_at.front()));
}

TEST_P(CheckpointOf, ASolver_GivenThatAnotherOneGoesOnFromThere_ThenAllThatBothRememberStaysTheSame) {
  const model::Model model = model_of(GetParam());
  const solve::ExplicitSettings settings{2e3, 0.06, GetParam().mass_damping, 0.9, GetParam().adapts_pace};
  solve::ExplicitSolver first(model, settings);
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE(first.strain());
    solve::ExplicitSolver second(model, settings);
    solve::RunProgress progress;
    const std::string checkpoint = solve::checkpoint_of(first, progress);
    solve::go_back_to(checkpoint, second, progress);
    ASSERT_EQ(solve::checkpoint_of(second, progress), checkpoint);
    for (solve::ExplicitSolver* solver : {&first, &second}) {
      for (int i = 0; i < 501; ++i) solver->step();
      static_cast<void>(solver->history());
      for (int i = 0; i < 700; ++i) solver->step();
    }
    ASSERT_EQ(solve::checkpoint_of(second, progress), solve::checkpoint_of(first, progress));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CheckpointOf, testing::ValuesIn(kScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST(Checkpoint, GivenARowForEveryStep_ThenARunGoesOnFromWhereItWasTaken) {
  // Then a checkpoint is taken where a strain has been reached and its row has not been told.
  const Scene& scene = kScenes[1];
  const model::Model model = model_of(scene);
  solve::SimulationSettings settings = settings_of(scene);
  settings.history_points = 100000;
  const Heard whole = run(model, settings, 0);
  const Heard watched = run(model, settings, 400);
  ASSERT_GE(watched.checkpoints.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const Heard resumed = run(model, settings, 0, watched.checkpoints[k]);
    EXPECT_EQ(resumed.rows.size(), whole.rows.size() - watched.rows_at[k]);
    EXPECT_EQ(resumed.rows, after(whole.rows, watched.rows_at[k]));
  }
}

TEST(Checkpoint, GivenTheVeryStepOfABreak_ThenTheRunGoesOnTheSame) {
  // Then the forces are those of the fabric that has just been cut, and are not computed anew.
  const Scene& scene = kScenes[6];
  const model::Model model = model_of(scene);
  const solve::ExplicitSettings settings{2e3, 0.06, 0, 0.9, false};
  solve::ExplicitSolver first(model, settings);
  while (first.broken().empty() && first.strain() < scene.strain) first.step();
  ASSERT_FALSE(first.broken().empty());
  solve::ExplicitSolver second(model, settings);
  solve::RunProgress progress;
  solve::go_back_to(solve::checkpoint_of(first, progress), second, progress);
  EXPECT_EQ(results::history_line(second.history()), results::history_line(first.history()));
  for (solve::ExplicitSolver* solver : {&first, &second}) {
    for (int i = 0; i < 2000; ++i) solver->step();
  }
  EXPECT_EQ(solve::checkpoint_of(second, progress), solve::checkpoint_of(first, progress));
}

TEST(Checkpoint, GivenACallerWhoSaysStop_ThenThereIsOneFromBeforeTheLastReport) {
  const model::Model model = model_of(kScenes[0]);
  const Heard whole = run(model, settings_of(kScenes[0]), 0);
  std::vector<std::string> rows;
  std::string checkpoint;
  std::size_t rows_at = 0;
  solve::SimulationCallbacks callbacks;
  callbacks.on_history = [&](const model::HistoryRow& row) { rows.push_back(results::history_line(row)); };
  callbacks.keep_going = [&](const model::HistoryRow&) { return rows.size() < 20; };
  callbacks.on_checkpoint = [&](const std::string& bytes) {
    checkpoint = bytes;
    rows_at = rows.size();
  };
  const auto outcome = solve::simulate(model, settings_of(kScenes[0]), callbacks);
  EXPECT_EQ(outcome.status, model::RunStatus::interrupted);
  EXPECT_EQ(rows.size(), rows_at + 1);
  const Heard resumed = run(model, settings_of(kScenes[0]), 0, checkpoint);
  EXPECT_EQ(resumed.outcome.status, model::RunStatus::completed);
  EXPECT_EQ(resumed.rows, after(whole.rows, rows_at));
  EXPECT_EQ(resumed.frames.back(), whole.frames.back());
}

TEST(Checkpoint, GivenBytesThatAreNone_ThenTheMessageSaysSo) {
  const model::Model model = model_of(kScenes[0]);
  solve::ExplicitSolver solver(model, {});
  solve::RunProgress progress;
  const std::string good = solve::checkpoint_of(solver, progress);
  for (const std::string& bad : {std::string("x"), good.substr(0, good.size() - 1), good + "x"}) {
    EXPECT_THROW(solve::go_back_to(bad, solver, progress), InputError);
  }
}

TEST(Checkpoint, GivenAllClassesThatItHolds_ThenEachNamesAllItsMembers) {
  const Scene paced = kScenes[3];
  const model::Model model = model_of(paced);
  solve::ExplicitSolver solver(model, {.adapts_pace = true});
  EXPECT_THAT(test::MemberCheck::classes_with_gaps(solver), testing::IsEmpty());
  solve::RunProgress progress;
  EXPECT_THAT(test::MemberCheck::classes_with_gaps(progress), testing::IsEmpty());
}

struct Forgetful {
  double named = 0;
  double forgotten = 0;
  std::vector<int> left_out;
  int last = 0;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(named, base::left_out(left_out), last);
  }
};

struct Outer {
  std::vector<Forgetful> inner;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(inner);
  }
};

TEST(Checkpoint, GivenAClassThatForgetsAMember_ThenTheCheckFindsIt) {
  Outer outer;
  EXPECT_THAT(test::MemberCheck::classes_with_gaps(outer), testing::ElementsAre(testing::HasSubstr("Forgetful")));
}

}  // namespace
}  // namespace knitmech
