#pragma once

#include <vector>

#include "base/left_out.h"
#include "beam/nodal_inertia.h"
#include "model/model.h"
#include "model/state.h"
#include "solve/integrate.h"
#include "solve/selective_mass.h"

namespace knitmech::solve {

/// The two grips of a tensile test, as forces: in every step they load their nodes with just what keeps these on
/// course, so the reaction of the fabric is known without a second evaluation.
class Grips {
 public:
  explicit Grips(const model::Model& model);

  /// Replaces the loads on the held and driven nodes by those that give them the prescribed motion in the coming step,
  /// and all forces by what is left of them where masses are shared: see SelectiveMass::share().
  /// \param speed of the driven grip over the step after [mm/s]
  void apply(const beam::NodalInertia& inertia, const SelectiveMass& masses, StepLengths step, double mass_damping,
             const model::State& state, double speed, model::NodalLoads& loads,
             const base::ThreadTeam& team = base::ThreadTeam(1));

  /// Sets the loads in all held and driven directions to zero.
  void clear_loads(model::NodalLoads& loads) const;

  /// Pull of the driven grip along y at the last call [N].
  [[nodiscard]] double force_top() const { return force_top_; }
  /// Pull of the held grip against y at the last call [N].
  [[nodiscard]] double force_bottom() const { return force_bottom_; }
  /// Work of the driven grip since the start [mJ].
  [[nodiscard]] double work() const { return work_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(test_, held_, driven_, on_held_, on_driven_), force_top_, force_bottom_, work_);
  }

 private:
  void add_up(const SelectiveMass& masses, double h, const model::State& state, double speed,
              const model::NodalLoads& loads);

  model::TensileTest test_;
  std::vector<int> held_, driven_;
  std::vector<double> on_held_, on_driven_;  ///< by the fabric, along y, at the last call [N]
  double force_top_ = 0, force_bottom_ = 0, work_ = 0;
};

}  // namespace knitmech::solve
