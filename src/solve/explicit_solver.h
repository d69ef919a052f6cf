#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/left_out.h"
#include "base/thread_team.h"
#include "beam/elements.h"
#include "beam/fold_limit.h"
#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "beam/nonlinear_axial.h"
#include "contact/yarn_contact.h"
#include "model/frame.h"
#include "model/model.h"
#include "model/run_outcome.h"
#include "solve/broken_yarns.h"
#include "solve/force_window.h"
#include "solve/grips.h"
#include "solve/integrate.h"
#include "solve/pull.h"
#include "solve/selective_mass.h"
#include "solve/ties.h"
#include "solve/yarn_breaks.h"

namespace knitmech::solve {

/// What the solver needs to be told besides the model.
struct ExplicitSettings {
  double mass_scaling = 1;    ///< [-]
  double bulk_viscosity = 0;  ///< [-]
  double mass_damping = 0;    ///< [1/s]
  double step_factor = 1;     ///< [-]
  bool adapts_pace = false;   ///< of the driven grip, see Pace
  int threads = 1;            ///< the results do not depend on it
  double finest_length = 0;   ///< [mm], of selective mass, see beam::lump_inertia(); 0: none
};

/// Steps a model through time by central differences (leapfrog), with beams, contact and grips.
///
/// In every step: forces of the beams, forces of the contact, reactions of the grips, then velocities and positions,
/// and a look for yarns that break. Broken yarns are cut if the test goes on.
class ExplicitSolver {
 public:
  ExplicitSolver(const model::Model& model, const ExplicitSettings& settings);

  void step();

  /// Evaluates all forces at the present positions without moving; after it, history() and frame() are up to date.
  void evaluate();

  [[nodiscard]] double time() const { return state_.time; }
  /// Of the driven grip [mm].
  [[nodiscard]] double displacement() const { return pull_.displacement(state_.time); }
  [[nodiscard]] double strain() const { return displacement() / model_.test.gauge_length; }
  [[nodiscard]] long steps() const { return steps_; }
  /// Time step in use [s].
  [[nodiscard]] double step_length() const { return step_in_use_; }
  [[nodiscard]] double first_step() const { return first_step_; }
  /// False once any velocity is infinite or not a number.
  [[nodiscard]] bool is_finite() const { return is_finite_; }
  [[nodiscard]] const std::optional<contact::LostCrossing>& lost_crossing() const { return contact_.lost_crossing(); }
  [[nodiscard]] long crossing_checks() const { return earlier_.crossing_checks + contact_.crossing_checks(); }
  /// Yarn ends that have slipped out of loops since the call before, without their strain.
  [[nodiscard]] std::vector<model::Ravelling> take_ravelled();
  /// Since the start.
  [[nodiscard]] const std::vector<model::YarnBreak>& broken() const { return broken_; }
  [[nodiscard]] double largest_penetration() const { return largest_penetration_; }
  /// In the last step [mm].
  [[nodiscard]] double largest_tie_stretch() const { return ties_.largest_stretch(); }
  [[nodiscard]] const model::State& state() const { return state_; }

  /// Energies and forces at the present time; see HistoryRow. Forces of the grips are freed of vibration since the call
  /// before (ForceWindow).
  [[nodiscard]] model::HistoryRow history();
  [[nodiscard]] model::Frame frame(int index, const model::HistoryRow& row) const;

  /// All that the solver remembers, in both directions. To be read into a solver of the same model and settings.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(model_, settings_, team_, elements_, inertia_, masses_, nonlinear_, smallest_radius_,
                           first_step_),
            pieces_);
    if constexpr (Archive::is_loading::value) make_parts_of_pieces();
    archive(work_, folds_, contact_, ties_, grips_, pull_, state_, loads_, step_, kick_, step_in_use_, calm_looks_,
            breaks_, broken_, earlier_, untold_, n_gathered_, break_loss_, mass_damping_loss_, largest_penetration_,
            grip_forces_, forces_are_current_, is_finite_, steps_);
    if constexpr (Archive::is_loading::value) nonlinear_.set_secants(state_, elements_);
  }

 private:
  /// \param viscous_time, friction_time [s], over which the losses of viscosity and friction are added up
  void compute_forces(double viscous_time, double friction_time);
  void look_at_stable_step();
  [[nodiscard]] double stable_step_for(double contact_frequency_squared) const;
  [[nodiscard]] double width() const;

  void look_for_breaks();
  [[nodiscard]] model::YarnBreak break_of(std::size_t element) const;
  void cut(const std::vector<std::size_t>& elements);
  void take_out(std::size_t element);
  void make_contact_anew();
  void make_parts_of_pieces();
  void keep_velocities_of_now(const model::NodalLoads& loads_before);
  void limit_step_to_snap(std::size_t element);
  void gather_ravelled();
  [[nodiscard]] double internal_energy() const;
  [[nodiscard]] double stretch_energy() const;
  [[nodiscard]] double kinetic_energy() const;

  const model::Model& model_;
  ExplicitSettings settings_;
  base::ThreadTeam team_;
  beam::Elements elements_;
  beam::NodalInertia inertia_;
  beam::ElementWork work_;
  beam::NonlinearAxial nonlinear_;
  beam::FoldLimit folds_;
  contact::YarnContact contact_;
  Ties ties_;
  Grips grips_;
  SelectiveMass masses_;
  Pull pull_;
  model::State state_;
  model::NodalLoads loads_;
  StepLengths step_;
  double kick_ = 0;                          ///< [s], time over which the last forces have acted
  double smallest_radius_ = 0;               ///< [mm]
  double step_in_use_ = 0, first_step_ = 0;  ///< [s]
  int calm_looks_ = 0;                       ///< looks since the step could have grown
  /// Of contacts that were made anew when a yarn broke.
  struct Earlier {
    double friction_loss = 0;  ///< [mJ]
    long crossing_checks = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(friction_loss, crossing_checks);
    }
  };
  YarnBreaks breaks_;
  BrokenYarns pieces_;
  std::vector<model::YarnBreak> broken_;
  Earlier earlier_;
  std::vector<model::Ravelling> untold_;  ///< ravelled, and not yet taken
  std::size_t n_gathered_ = 0;            ///< events of the present contact that are in untold_ or were
  double break_loss_ = 0;                 ///< [mJ]
  double mass_damping_loss_ = 0;
  double largest_penetration_ = 0;
  ForceWindow grip_forces_;  ///< since the last row of the history
  bool forces_are_current_ = false;
  bool is_finite_ = true;
  long steps_ = 0;
};

}  // namespace knitmech::solve
