// Forces of many elements at once: across the blocks in which they are worked on, and on several threads. What the
// force of one element is, element_test.cpp says.

#include "beam/internal_force.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "../../support/beam_case.h"
#include "base/blocks.h"
#include "beam/fold_limit.h"
#include "beam/nonlinear_axial.h"
#include "beam/strength_watch.h"

namespace knitmech {
namespace {

/// Two soft yarns that follow a measured curve, in seven blocks whose limits they do not know, bent and stretched at
/// random; some of the elements are folded, and some are overloaded.
class BentYarns : public testing::Test {
 protected:
  BentYarns() {
    model_.axial_laws.emplace(0, yarn::AxialLaw({{0, 0}, {0.1, 1.5}, {0.2, 2}}));
    model_.strengths = {{0, 1.9}};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-0.1, 0.1);
    std::uniform_real_distribution<double> angle(-1.3, 1.3);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      state_.position.x[i] += place(random);
      state_.position.y[i] += place(random);
      state_.position.z[i] += place(random);
      state_.velocity.set(i, {place(random), place(random), place(random)});
      test::set_rotation(state_, i, test::turn({angle(random), angle(random), angle(random)}));
    }
  }

  struct Results {
    model::NodalLoads loads;
    double energy, fold_energy, loss;
    std::vector<std::size_t> overloaded;
  };
  [[nodiscard]] Results results(std::size_t threads) const {
    const base::ThreadTeam team(threads);
    beam::Elements elements = beam::make_elements(model_, 1.0, 0.06);
    const beam::NonlinearAxial nonlinear(model_);
    beam::FoldLimit folds(elements);
    beam::ElementWork work(state_.position.size());
    Results results{model::NodalLoads(state_.position.size()), 0, 0, 0, {}};
    for (int step = 0; step < 3; ++step) {
      nonlinear.set_secants(state_, elements, team);
      beam::set_internal_force(elements, state_, 1e-6, work, results.loads, team);
      folds.add_moments(state_, results.loads, team);
    }
    results.energy =
        beam::strain_energy(elements, state_, team) + nonlinear.energy_beyond_secants(elements, state_, team);
    results.fold_energy = folds.energy();
    results.loss = beam::damping_loss(work);
    results.overloaded = beam::StrengthWatch(model_, elements).overloaded(state_, team);
    return results;
  }

  model::Model model_ =
      test::yarns_through({test::straight({0, 0, 0}, {400, 0, 0}, 400), test::straight({0, 9, 0}, {400, 9, 0}, 420)},
                          test::section(19.0, 6, 5e-6, 4e-6, 1.3e-11, 0.12));
  model::State state_ = test::state_of(model_);
};

TEST_F(BentYarns, GivenAnyState_ThenInternalForcesAndMomentsAreInBalance) {
  // No state of a free yarn gives it an overall force or moment; a load that is lost, or comes to a wrong node, would.
  const model::NodalLoads loads = results(1).loads;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double size = 0;
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
    const Eigen::Vector3d f = test::vector_at(loads.force, i);
    force += f;
    moment += test::vector_at(loads.moment, i) + test::vector_at(state_.position, i).cross(f);
    size += f.norm();
  }
  EXPECT_LT(force.norm(), 1e-13 * size);
  EXPECT_LT(moment.norm(), 1e-13 * size * 400);
}

TEST_F(BentYarns, GivenAnyNumberOfThreads_ThenForcesAndEnergiesAreTheSameToTheLastBit) {
  ASSERT_EQ(base::n_blocks(model_.nodes.size()), 7U);
  const Results alone = results(1);
  EXPECT_GT(alone.fold_energy, 0);
  EXPECT_GT(alone.loss, 0);
  EXPECT_FALSE(alone.overloaded.empty());
  for (const std::size_t threads : {2U, 3U, 7U, 8U}) {
    const Results shared = results(threads);
    for (auto axis : {&model::VectorArray::x, &model::VectorArray::y, &model::VectorArray::z}) {
      EXPECT_EQ(shared.loads.force.*axis, alone.loads.force.*axis) << threads << " threads";
      EXPECT_EQ(shared.loads.moment.*axis, alone.loads.moment.*axis) << threads << " threads";
    }
    EXPECT_EQ(shared.energy, alone.energy);
    EXPECT_EQ(shared.fold_energy, alone.fold_energy);
    EXPECT_EQ(shared.loss, alone.loss);
    EXPECT_EQ(shared.overloaded, alone.overloaded);
  }
}

}  // namespace
}  // namespace knitmech
