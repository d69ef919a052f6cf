// Any number of threads gives the same results to the last bit.

#include "solve/threads.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "../model/example_case.h"
#include "base/blocks.h"
#include "model/build_model.h"
#include "solve/constants.h"
#include "solve/explicit_solver.h"
#include "solve/simulate.h"

namespace knitmech {
namespace {

/// All numbers that a run tells, bit by bit.
class Numbers {
 public:
  void add(double value) { bits_.push_back(std::bit_cast<std::uint64_t>(value)); }
  void add(const std::vector<double>& values) {
    for (const double value : values) add(value);
  }
  template <int rows>
  void add(const std::vector<Eigen::Matrix<double, rows, 1>>& vectors) {
    for (const auto& vector : vectors) {
      for (const double value : vector) add(value);
    }
  }
  void add(const model::VectorArray& of) {
    for (const auto* values : {&of.x, &of.y, &of.z}) add(*values);
  }
  void add(const model::State& state) {
    add(state.time);
    for (const auto* vectors : {&state.position, &state.velocity, &state.angular_velocity}) add(*vectors);
    for (const auto* values : {&state.rotation.w, &state.rotation.x, &state.rotation.y, &state.rotation.z}) {
      add(*values);
    }
  }
  void add(const model::HistoryRow& row) {
    for (const double value :
         {row.time, row.displacement, row.strain, row.force_top, row.force_bottom, row.external_work,
          row.internal_energy, row.stretch_energy, row.kinetic_energy, row.contact_energy, row.friction_loss,
          row.damping_loss, row.break_loss, row.width, static_cast<double>(row.contacts), row.normal_force,
          row.largest_elastic_slip, row.largest_penetration, row.step}) {
      add(value);
    }
  }
  void add(const model::ContactRecord& contact) {
    add(std::vector{static_cast<double>(contact.first_yarn), static_cast<double>(contact.second_yarn),
                    contact.first_place, contact.second_place, contact.gap, contact.normal_force, contact.elastic_slip,
                    contact.slip, static_cast<double>(contact.slips), contact.angle});
    add(std::vector{contact.position, contact.normal, contact.friction_force});
  }
  void add(const model::Frame& frame) {
    add(frame.history);
    add(frame.points);
    add(frame.rotations);
    for (const auto* field :
         {&frame.axial_force, &frame.shear_force, &frame.bending_moment, &frame.torque, &frame.axial_strain,
          &frame.curvature, &frame.stretch_energy, &frame.bending_energy, &frame.twist_energy, &frame.gap}) {
      add(*field);
    }
    add(frame.contact_force);
    add(frame.tie_force);
    for (const model::ContactRecord& contact : frame.contacts) add(contact);
    for (const int element : frame.broken) add(element);
  }
  [[nodiscard]] bool operator==(const Numbers&) const = default;

 private:
  std::vector<std::uint64_t> bits_;
};

struct Results {
  Numbers numbers;
  model::HistoryRow last;
  std::size_t n_broken = 0;
};

/// A hundred rows of history, three frames and the last state.
Results run(const model::Model& model, int threads, int steps, double mass_damping) {
  solve::ExplicitSolver solver(model, {.mass_scaling = 1e4,
                                       .bulk_viscosity = 0.06,
                                       .mass_damping = mass_damping,
                                       .step_factor = 0.9,
                                       .threads = threads});
  Results results;
  for (int step = 0; step <= steps; ++step) {
    if (step % (steps / 100) == 0) {
      results.last = solver.history();
      results.numbers.add(results.last);
    }
    if (step % (steps / 2) == 0) results.numbers.add(solver.frame(0, results.last));
    solver.step();
  }
  results.numbers.add(solver.state());
  results.n_broken = solver.broken().size();
  return results;
}

/// 8 x 6 stitches, which have a block for every thread that is tried, pulled so fast that much happens in a few steps.
model::Case fast_case() {
  model::Case input = model::example_case();
  input.fabric.wales = 8;
  input.fabric.courses = 6;
  input.test.speed = 1000;
  input.test.ramp = 1e-3;
  return input;
}

/// Returns the run on one thread.
Results expect_same_on_all(const model::Model& model, int steps, double mass_damping) {
  EXPECT_GE(base::n_blocks(model.nodes.size()), 7U);
  Results alone = run(model, 1, steps, mass_damping);
  for (const int threads : {2, 3, 7}) {
    EXPECT_TRUE(run(model, threads, steps, mass_damping).numbers == alone.numbers) << threads << " threads";
  }
  return alone;
}

TEST(Threads, GivenAFabricWithSmoothContactAndSoftEdgeYarns_ThenEveryNumberIsTheSame) {
  model::Case input = fast_case();
  input.fabric.structure = knit::Structure::adjusted;
  const Results alone = expect_same_on_all(model::build_model(input), 300, 0);
  EXPECT_GT(alone.last.contacts, 0);
  EXPECT_GT(alone.last.friction_loss, 0);
  EXPECT_GT(alone.last.damping_loss, 0);
}

TEST(Threads, GivenATiedFabricWithContactOnChordsAndMassDamping_ThenEveryNumberIsTheSame) {
  model::Case input = fast_case();
  input.fabric.structure = knit::Structure::tied;
  input.contact.centreline = model::Centreline::chords;
  const Results alone = expect_same_on_all(model::build_model(input), 600, 20);
  EXPECT_GT(alone.last.contacts, 0);
  EXPECT_GT(alone.last.friction_loss, 0);
}

TEST(Threads, GivenAMeasuredCurveAndYarnsThatBreak_ThenEveryNumberIsTheSame) {
  model::Case input = fast_case();
  input.contact.centreline = model::Centreline::chords;
  input.yarn.youngs_modulus.reset();
  input.yarn.curve_strains = {0, 0.02, 0.05};
  input.yarn.curve_forces = {0, 0.4, 0.8};
  input.yarn.strength = 0.1;
  input.test.on_break = model::OnBreak::go_on;
  const Results alone = expect_same_on_all(model::build_model(input), 500, 0);
  EXPECT_GT(alone.n_broken, 0U);
  EXPECT_GT(alone.last.break_loss, 0);
}

TEST(Threads, GivenANumberOfThreads_ThenTheOutcomeTellsItAndTheHistoryIsThatOfOneThread) {
  const auto history = [](std::optional<int> threads, int told) {
    model::Case input = fast_case();
    input.test.strain = 1e-3;
    Numbers numbers;
    solve::SimulationSettings settings;
    settings.mass_scaling = 1e4;
    settings.history_points = 10;
    settings.threads = threads;
    const model::RunOutcome outcome =
        solve::simulate(model::build_model(input), settings,
                        {.on_history = [&](const model::HistoryRow& row) { numbers.add(row); },
                         .on_frame = [&](const model::Frame& frame) { numbers.add(frame); },
                         .keep_going = {}});
    EXPECT_EQ(outcome.threads, told);
    return numbers;
  };
  const Numbers alone = history(1, 1);
  EXPECT_TRUE(history(3, 3) == alone);
  EXPECT_TRUE(history(std::nullopt, solve::automatic_threads(model::build_model(fast_case()))) == alone);
}

TEST(AutomaticThreads, GivenProcessorsAndElements_ThenNoThreadHasLessThanItsShareAndThereIsAtLeastOne) {
  constexpr int kShare = solve::kElementsPerThread;
  EXPECT_EQ(solve::automatic_threads(100 * kShare, 8), 8);
  EXPECT_EQ(solve::automatic_threads(3 * kShare, 8), 3);
  EXPECT_EQ(solve::automatic_threads(3 * kShare - 1, 8), 2);
  EXPECT_EQ(solve::automatic_threads(1, 8), 1);
  EXPECT_EQ(solve::automatic_threads(100 * kShare, 0), 1);  // processors not known
}

}  // namespace
}  // namespace knitmech
