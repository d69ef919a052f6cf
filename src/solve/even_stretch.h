#pragma once

#include <vector>

#include "base/left_out.h"
#include "beam/nodal_inertia.h"
#include "model/model.h"
#include "model/state.h"

namespace knitmech::solve {

/// The even stretch of a fabric between its grips: every node moves along y with the share
///
///     w = (y - lowest y) / (highest y - lowest y)
///
/// of the driven grip's speed that its place in the undeformed fabric has.
///
/// A grip that gains speed would have to drag the rest of the fabric along through the yarns, as a wave. Instead every
/// node is given a force m w a, a the grip's acceleration, so that an evenly stretched fabric changes its speed without
/// any force in the yarns. The work of these forces is work of the test like that of the grip; braking takes it back.
///
/// A grip that brakes slows all motion down, not only the even one: with u the motion relative to the even stretch,
/// every node is given m u a / v besides, v the grip's speed, so that what a snap has set going calms down in
/// proportion. The work of these forces on u is a damping loss, that on the even stretch counts as above.
class EvenStretch {
 public:
  EvenStretch(const model::Model& model, const beam::NodalInertia& inertia);

  /// Adds the forces of one step to loads.
  /// \param speed [mm/s] of the driven grip before, acceleration [mm/s^2], h [s], over which it acts
  void apply(double speed, double acceleration, double h, const model::State& state, model::NodalLoads& loads);

  /// Kinetic energy of the motion relative to an even stretch at a speed [mJ]: with P = sum m w v_y and C = sum m w^2
  /// it is kinetic - speed P + speed^2 C / 2.
  /// \param kinetic of the whole motion [mJ], speed of the driven grip [mm/s]
  [[nodiscard]] double stray_energy(double kinetic, double speed, const model::State& state) const;

  /// Of the even stretch since the start [mJ].
  [[nodiscard]] double work() const { return work_; }
  /// Energy of other motion that braking took since the start [mJ].
  [[nodiscard]] double damping_loss() const { return damping_loss_; }
  /// Of the whole fabric [t].
  [[nodiscard]] double mass() const { return mass_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(mass_of_, relative_, share_, shared_mass_, gripped_, mass_, stretched_mass_), work_,
            damping_loss_);
  }

 private:
  void calm(double speed, double rate, double h, const model::State& state, model::NodalLoads& loads);
  [[nodiscard]] double momentum(const model::State& state) const;

  /// (M u)_i of a motion u(i) of all nodes, M the mass with relative masses.
  template <class Motion>
  [[nodiscard]] auto inertia_of(std::size_t i, const Motion& u) const {
    auto sum = mass_of_[i] * u(i);
    if (relative_.empty()) return sum;
    if (relative_[i] > 0) sum = sum + relative_[i] * (u(i) - u(i + 1));
    if (i > 0 && relative_[i - 1] > 0) sum = sum + relative_[i - 1] * (u(i) - u(i - 1));
    return sum;
  }

  std::vector<double> mass_of_;      ///< m per node [t]
  std::vector<double> relative_;     ///< b per element [t]; empty: none
  std::vector<double> share_;        ///< w per node
  std::vector<double> shared_mass_;  ///< M w per node [t]
  std::vector<char> gripped_;        ///< per node
  double mass_ = 0;
  double stretched_mass_ = 0;  ///< C [t]
  double work_ = 0, damping_loss_ = 0;
};

}  // namespace knitmech::solve
