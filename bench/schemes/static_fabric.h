#pragma once

#include <vector>

#include "beam/elements.h"
#include "beam/internal_force.h"
#include "contact/yarn_contact.h"
#include "model/model.h"
#include "model/state.h"
#include "solve/grips.h"

namespace knitmech::bench {

/// A fabric of linear yarns without time: what the nodes bear at some place, and how far they are from rest there.
class StaticFabric {
 public:
  explicit StaticFabric(const model::Model& model);

  /// Sets the forces on all nodes, and counts.
  /// \param motion [s], for which the velocities went on since the contact was asked before
  void set_loads(const model::State& state, double motion, contact::YarnContact& contact, model::NodalLoads& loads);

  /// Moves the driven grip along y by a displacement [mm] and all nodes between the grips evenly, and sets the
  /// velocities to that motion within a time [s].
  void stretch(double displacement, double time, model::State& state) const;

  /// Root of the sum of the squares of all loads that no grip bears [N], moments by the length of an element.
  [[nodiscard]] double residual(const model::NodalLoads& loads) const;
  /// The loads that no grip bears.
  [[nodiscard]] model::NodalLoads free_loads(const model::NodalLoads& loads) const;
  /// Mean pull of both grips [N].
  [[nodiscard]] double grip_force(const model::NodalLoads& loads) const;
  /// Whether loads are as near to rest as a share of the grip force [-]; while the fabric hardly bears, of the force
  /// EI / l^2 that bends a half stitch of length l in each wale.
  [[nodiscard]] bool is_at_rest(const model::NodalLoads& loads, double tolerance) const;

  [[nodiscard]] const model::Model& model() const { return model_; }
  [[nodiscard]] const beam::Elements& elements() const { return elements_; }
  [[nodiscard]] const solve::Grips& grips() const { return grips_; }
  [[nodiscard]] long evaluations() const { return evaluations_; }
  [[nodiscard]] double smallest_radius() const { return smallest_radius_; }

 private:
  const model::Model& model_;
  beam::Elements elements_;
  beam::ElementWork work_;
  solve::Grips grips_;
  std::vector<double> share_;  ///< of the displacement of the driven grip, per node
  double element_length_ = 0;  ///< mean [mm]
  double least_force_ = 0;     ///< [N], that counts as the grip force
  double smallest_radius_ = 0;
  long evaluations_ = 0;
};

}  // namespace knitmech::bench
