#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "contact/centreline.h"
#include "contact/contact_points.h"
#include "contact/friction.h"
#include "contact/smooth_contacts.h"
#include "model/frame.h"
#include "model/state.h"

namespace knitmech::contact {

/// Two yarns that went through each other: the direction from one to the other turned round within a step.
struct LostCrossing {
  std::int32_t first, second;  ///< elements
  Vector3 place;               ///< [mm]
};

/// Frictional contact of all yarns with each other and with themselves.
///
/// Owns what contact remembers: the neighbour list with the positions that it was made for, and the slip of each
/// contact.
class YarnContact {
 public:
  explicit YarnContact(const model::Model& model);

  /// Adds normal and friction forces to the nodes.
  /// \param step [s] since the call before; velocities times step are the motion since then
  void add_forces(const model::State& state, double step, model::NodalLoads& loads);

  /// Stored in the penalty and the elastic stick at the last call of add_forces [mJ].
  [[nodiscard]] double energy() const;
  /// Dissipated since the start [mJ].
  [[nodiscard]] double friction_loss() const { return friction_loss_; }
  [[nodiscard]] int n_contacts() const { return static_cast<int>(points_.size()); }
  /// At the last call of add_forces [mm].
  [[nodiscard]] double largest_penetration() const;
  /// Upper bound of the square of the highest frequency that the contacts alone give the nodes [1/s^2]: the largest row
  /// sum of their stiffness, scaled with the inertia of the nodes (Gershgorin).
  [[nodiscard]] double highest_frequency_squared(const std::vector<double>& mass,
                                                 const std::vector<double>& rotary) const;
  [[nodiscard]] const std::optional<LostCrossing>& lost_crossing() const { return lost_; }
  [[nodiscard]] long searches() const { return searches_; }

  /// Fills the node fields contact_force and gap of a frame whose points are set.
  void set_contact_results(model::Frame& frame) const;

 private:
  void search();
  void apply(const ContactPoint& point, const model::State& state, double step, model::NodalLoads& loads);

  ContactElements elements_;
  Centreline centreline_;
  double skin_ = 0;  ///< [mm]
  std::vector<ElementPair> pairs_;
  std::vector<PairPlaces> places_;  ///< one entry per pair
  PairClock clock_;
  double searched_at_ = 0;  ///< on the clock [mm]
  std::vector<ContactPoint> points_;
  std::vector<SlipMemory> memories_, memories_before_;
  double friction_loss_ = 0;
  std::optional<LostCrossing> lost_;
  long searches_ = 0;
};

}  // namespace knitmech::contact
