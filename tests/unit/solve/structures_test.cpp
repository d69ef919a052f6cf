// Small fabrics with tied and joined edges, simulated: 2 wales x 3 courses at N10.

#include <gtest/gtest.h>

#include <vector>

#include "../model/example_case.h"
#include "model/build_model.h"
#include "solve/simulate.h"

namespace knitmech {
namespace {

struct Simulation {
  model::Model model;
  model::RunOutcome outcome;
  std::vector<model::HistoryRow> rows;
  std::vector<model::Frame> frames;
};

Simulation run(knit::Structure structure, double strain) {
  model::Case input = model::example_case();
  input.fabric.structure = structure;
  input.fabric.wales = 2;
  input.fabric.courses = 3;
  input.test.strain = strain;
  input.test.ramp = 0.1;
  Simulation run{model::build_model(input), {}, {}, {}};
  solve::SimulationSettings settings;
  settings.mass_scaling = 1e3;
  settings.bulk_viscosity = 0.06;
  settings.history_points = 50;
  solve::SimulationCallbacks callbacks;
  callbacks.on_history = [&](const model::HistoryRow& row) { run.rows.push_back(row); };
  callbacks.on_frame = [&](const model::Frame& frame) { run.frames.push_back(frame); };
  run.outcome = solve::simulate(run.model, settings, callbacks);
  return run;
}

/// All energies over the work of the grip at the end [-].
double held_over_work(const Simulation& run) {
  const model::HistoryRow& row = run.rows.back();
  return (row.internal_energy + row.kinetic_energy + row.contact_energy + row.friction_loss + row.damping_loss) /
         row.external_work;
}

TEST(Structures, GivenATiedFabric_ThenEnergyIsKeptTheTiesHoldAndNoCrossingIsLost) {
  const Simulation tied = run(knit::Structure::tied, 0.03);
  EXPECT_EQ(tied.outcome.status, model::RunStatus::completed) << tied.outcome.reason;
  EXPECT_NEAR(held_over_work(tied), 1, 0.002);
  EXPECT_EQ(tied.outcome.lost_crossings, 0);
  EXPECT_GT(tied.outcome.largest_tie_stretch, 0);
  EXPECT_LT(tied.outcome.largest_tie_stretch, 0.03 * 0.12);
  const model::HistoryRow& last = tied.rows.back();
  EXPECT_NEAR(last.force_bottom, last.force_top, 0.001 * last.force_top);
}

TEST(Structures, GivenATiedFabric_ThenTheForcesOfTheTiesAreInBalanceAndOnTheTiedElementsAlone) {
  const Simulation tied = run(knit::Structure::tied, 0.03);
  std::vector<bool> is_tied(tied.model.nodes.size());
  for (const model::Tie& tie : tied.model.ties) {
    for (const model::ElementPlace place : {tie.first, tie.second}) {
      is_tied[static_cast<std::size_t>(place.element)] = is_tied[static_cast<std::size_t>(place.element) + 1] = true;
    }
  }
  const std::vector<Eigen::Vector3d>& forces = tied.frames.back().tie_force;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double largest = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    sum += forces[i];
    largest = std::max(largest, forces[i].norm());
    EXPECT_TRUE(is_tied[i] || forces[i].norm() == 0) << "node " << i;
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(sum.norm(), 1e-12 * largest);
}

TEST(Structures, GivenTheSameTest_ThenTheTiedFabricIsStifferThanTheBasicOne) {
  // The toe of the basic fabric is all but free of force; ties take it away.
  const double tied = run(knit::Structure::tied, 0.03).rows.back().external_work;
  const double basic = run(knit::Structure::basic, 0.03).rows.back().external_work;
  EXPECT_GT(tied, 100 * basic);
}

TEST(Structures, GivenAnAdjustedFabric_ThenEnergyIsKeptAndNoCrossingIsLost) {
  const Simulation adjusted = run(knit::Structure::adjusted, 0.05);
  EXPECT_EQ(adjusted.outcome.status, model::RunStatus::completed) << adjusted.outcome.reason;
  EXPECT_NEAR(held_over_work(adjusted), 1, 0.002);
  EXPECT_EQ(adjusted.outcome.lost_crossings, 0);
  EXPECT_EQ(adjusted.outcome.largest_tie_stretch, 0);
  EXPECT_TRUE(adjusted.outcome.ravelled.empty());
}

TEST(Structures, GivenAnAdjustedFabric_ThenTheWidthIsThatOfTheStitchesWithoutTheArcs) {
  // 2 wales of 3.9 mm from the first to the last foot.
  EXPECT_NEAR(run(knit::Structure::adjusted, 0.001).rows.front().width, 2 * 3.9, 1e-12);
}

}  // namespace
}  // namespace knitmech
