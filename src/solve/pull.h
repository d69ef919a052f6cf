#pragma once

#include <optional>

#include "base/left_out.h"
#include "beam/nodal_inertia.h"
#include "model/model.h"
#include "model/state.h"
#include "solve/even_stretch.h"
#include "solve/integrate.h"
#include "solve/pace.h"

namespace knitmech::solve {

/// The motion of the driven grip: as the test prescribes it over time, or at a pace that is adapted to the fabric.
class Pull {
 public:
  Pull(const model::Model& model, const beam::NodalInertia& inertia, bool adapts_pace);

  /// Of the driven grip [mm] at the present time [s].
  [[nodiscard]] double displacement(double time) const;

  /// True before a step if look() is due: every kPaceInterval steps of a pace that is adapted.
  [[nodiscard]] bool has_to_look(long steps) const;
  /// Adapts the pace to the energies of the fabric [mJ].
  void look(double internal, double kinetic, const model::State& state);

  /// Moves the grip by one step, and adds to the loads what the fabric needs to change its speed along with the grip.
  /// \return speed of the grip over the step after [mm/s]
  double advance(StepLengths step, const model::State& state, model::NodalLoads& loads);

  /// Tells the forces of the grips in a step [N].
  void add_forces(double top, double bottom, double h);

  /// Besides that of the grip [mJ]: what changed the speed of the fabric.
  [[nodiscard]] double work() const { return paced_ ? paced_->stretch.work() : 0; }
  /// Energy that braking took from motion other than an even stretch [mJ].
  [[nodiscard]] double damping_loss() const { return paced_ ? paced_->stretch.damping_loss() : 0; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(test_, paced_), impulse_);
    if (paced_) archive(*paced_);
  }

 private:
  /// Of the grips, since the last look.
  struct Impulse {
    double top = 0, bottom = 0;  ///< [N s]
    double time = 0;             ///< [s]

    template <class Archive>
    void serialize(Archive& archive) {
      archive(top, bottom, time);
    }
  };

  struct Paced {
    EvenStretch stretch;
    Pace pace;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(stretch, pace);
    }
  };

  model::TensileTest test_;
  std::optional<Paced> paced_;  ///< empty: over time, as the test prescribes it
  Impulse impulse_;
};

}  // namespace knitmech::solve
