// A whole small fabric: the external work of a wale test against independent computations of the same model.

#include <gtest/gtest.h>

#include <vector>

#include "model/build_model.h"
#include "solve/simulate.h"

namespace knitmech {
namespace {

/// 3 wales x 4 courses with p = 0.02 /mm, pulled at 4 mm/s with all masses times 1e4.
model::Case reference_fabric(int elements_per_erc) {
  model::Case input;
  input.title = "Reference fabric";
  input.loop = {7.0, 3.9, 0.2, 1.1, 0.2, 1.0, 0.02};
  input.fabric.wales = 3;
  input.fabric.courses = 4;
  input.fabric.course_spacing = 5;
  input.fabric.elements_per_erc = elements_per_erc;
  input.yarn.diameter = 0.12;
  input.yarn.density = 1140e-12;
  input.yarn.youngs_modulus = 1700;
  input.yarn.poissons_ratio = 0.39;
  input.contact.friction = 0.1;
  input.test.strain = 0.292;
  input.test.speed = 4;
  input.test.ramp = 0.5;
  return input;
}

struct Result {
  model::RunOutcome outcome;
  std::vector<model::HistoryRow> history;
  [[nodiscard]] double work_at(double strain) const {
    for (const model::HistoryRow& row : history) {
      if (row.strain >= strain - 1e-4) return row.external_work;
    }
    return 0;
  }
};

Result run(const model::Case& input, double mass_scaling) {
  Result result;
  solve::SimulationSettings settings;
  settings.mass_scaling = mass_scaling;
  settings.history_points = 292;
  solve::SimulationCallbacks callbacks;
  callbacks.on_history = [&](const model::HistoryRow& row) { result.history.push_back(row); };
  result.outcome = solve::simulate(model::build_model(input), settings, callbacks);
  return result;
}

/// External work [1e-3 mJ] of an independently written explicit program with the same beams and plain penalty contact
/// on the chords, at these strains.
struct Reference {
  int elements_per_erc;
  double work[4];
};
constexpr double kStrains[] = {0.144, 0.193, 0.242, 0.292};
constexpr Reference kReferences[] = {{10, {1.365, 7.99, 25.2, 54.5}}, {20, {0.763, 4.22, 17.7, 40.2}}};

TEST(Fabric, GivenChordContactAtN10AndN20_ThenTheExternalWorkIsThatOfAnIndependentProgram) {
  for (const Reference& reference : kReferences) {
    const Result result = run(reference_fabric(reference.elements_per_erc), 1e4);
    ASSERT_EQ(result.outcome.status, model::RunStatus::completed) << result.outcome.reason;
    // Hardly any force acts yet at the first strain, where inertia and the onset of contact weigh most.
    const double tolerance[] = {0.06, 0.02, 0.02, 0.02};
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(1e3 * result.work_at(kStrains[i]) / reference.work[i], 1.0, tolerance[i])
          << "N" << reference.elements_per_erc << " at " << kStrains[i];
    }
  }
}

TEST(Fabric, GivenAnyRun_ThenTheEnergyBalanceHoldsAndNoYarnIsLost) {
  const Result result = run(reference_fabric(10), 1e4);
  const model::HistoryRow& row = result.history.back();
  const double held =
      row.internal_energy + row.kinetic_energy + row.contact_energy + row.friction_loss + row.damping_loss;
  EXPECT_NEAR(held / row.external_work, 1.0, 0.002);
  EXPECT_EQ(result.outcome.lost_crossings, 0);
  EXPECT_LT(result.outcome.largest_penetration, 0.05 * 0.12);
}

TEST(Fabric, GivenHalfAndTwiceTheContactStiffness_ThenTheWorkHardlyChanges) {
  model::Case soft = reference_fabric(10);
  soft.contact.stiffness = 8.0;
  model::Case hard = reference_fabric(10);
  hard.contact.stiffness = 32.0;
  const double work_soft = run(soft, 1e4).history.back().external_work;
  const double work_hard = run(hard, 1e4).history.back().external_work;
  EXPECT_NEAR(work_soft / work_hard, 1.0, 0.01);
}

TEST(Fabric, GivenTheSameCaseTwice_ThenEveryNumberIsTheSame) {
  const Result one = run(reference_fabric(10), 1e4);
  const Result two = run(reference_fabric(10), 1e4);
  ASSERT_EQ(one.history.size(), two.history.size());
  for (std::size_t i = 0; i < one.history.size(); ++i) {
    EXPECT_EQ(one.history[i].external_work, two.history[i].external_work);
    EXPECT_EQ(one.history[i].force_top, two.history[i].force_top);
    EXPECT_EQ(one.history[i].friction_loss, two.history[i].friction_loss);
  }
}

}  // namespace
}  // namespace knitmech
