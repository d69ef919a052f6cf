// A whole small fabric: the external work of a wale test against independent computations of the same model.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "../support/centrelines.h"
#include "../support/verification.h"
#include "model/build_model.h"
#include "solve/simulate.h"

namespace knitmech {
namespace {

/// 3 wales x 4 courses with p = 0.02 /mm, pulled at 4 mm/s with all masses times 1e4.
model::Case reference_fabric(int elements_per_erc, model::Centreline centreline = model::Centreline::chords) {
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
  input.contact.centreline = centreline;
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

constexpr std::array kStrains = {0.144, 0.193, 0.242, 0.292};

/// A mesh of the reference fabric, and what is known of its external work.
struct Mesh {
  model::Centreline centreline;
  int elements_per_erc;
  /// [uJ] at kStrains, by an independently written explicit program with the same beams and plain penalty contact; on
  /// the smooth centreline it looks at four straight pieces of each element, which is only at N40 fine enough, and its
  /// last value, after a loop has snapped at 27 % strain, is left out: when it snaps decides there.
  std::vector<double> independent;
  double discretisation;  ///< tolerance against the finest mesh [-]
};

std::vector<Mesh> meshes() {
  using model::Centreline;
  return {{Centreline::smooth, 40, {0.545, 3.28, 15.4}, 0.0},
          {Centreline::smooth, 20, {}, 0.01},
          {Centreline::smooth, 10, {}, 0.05},
          {Centreline::chords, 40, {0.575, 3.54, 16.6, 40.5}, 0.15},
          {Centreline::chords, 20, {0.763, 4.22, 17.7, 40.2}, 0.45},
          {Centreline::chords, 10, {1.365, 7.99, 25.2, 54.5}, 1.7}};
}

TEST(Fabric, GivenAWaleTest_ThenTheExternalWorkConvergesAndIsThatOfAnIndependentProgram) {
  std::vector<double> finest;
  for (const Mesh& mesh : meshes()) {
    const Result result = run(reference_fabric(mesh.elements_per_erc, mesh.centreline), 1e4);
    ASSERT_EQ(result.outcome.status, model::RunStatus::completed) << result.outcome.reason;
    for (std::size_t i = 0; i < 4; ++i) {
      const double work = 1e3 * result.work_at(kStrains[i]);
      test::Comparison row{.of = fmt::format("N{} at {:.1f} % strain, {}", mesh.elements_per_erc, 100 * kStrains[i],
                                             test::name_of(mesh.centreline)),
                           .quantity = "external work [uJ]",
                           .computed = work};
      if (i < mesh.independent.size()) {
        row.chapter = "fabric";
        row.source = "independent program";
        row.reference = mesh.independent[i];
        // Hardly any force acts yet at the first strain, where inertia and the onset of contact weigh most.
        row.tolerance = i == 0 ? 0.06 : 0.02;
        if (i == 3 && mesh.centreline == model::Centreline::smooth) {
          // At a quarter of the speed both centrelines agree within 1 % here (39.4 uJ).
          row.tolerance = 0.13;
          row.remark = "the edge stitches ravel, at this speed with much inertia";
        }
        test::verify(row);
      }
      if (finest.size() < 4) {
        finest.push_back(work);
        continue;
      }
      row.chapter = "convergence";
      row.source = "N40, smooth";
      row.reference = finest[i];
      row.tolerance = mesh.discretisation;
      if (i == 3 && mesh.centreline == model::Centreline::smooth) {
        // With any change of rounding, N40 alone gives either 40.5 or 41.7 uJ here.
        row.tolerance = 0.05;
        row.remark = "a loop has snapped at 27 % strain, and when it snaps decides";
      }
      test::verify(row);
    }
  }
}

TEST(Fabric, GivenAnyRun_ThenTheEnergyBalanceHoldsAndNoYarnIsLost) {
  const Result result = run(reference_fabric(10), 1e4);
  const model::HistoryRow& row = result.history.back();
  const double held =
      row.internal_energy + row.kinetic_energy + row.contact_energy + row.friction_loss + row.damping_loss;
  test::verify({.chapter = "fabric",
                .of = "N10 at 29.2 % strain, chords",
                .quantity = "all energies over external work [-]",
                .source = "conservation",
                .reference = 1,
                .computed = held / row.external_work,
                .tolerance = 0.002});
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
  test::verify({.chapter = "fabric",
                .of = "N10 at 29.2 % strain, chords, contact stiffness 8 against 32 N/mm",
                .quantity = "external work [uJ]",
                .source = "the same at 32 N/mm",
                .reference = 1e3 * work_hard,
                .computed = 1e3 * work_soft,
                .tolerance = 0.01});
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
