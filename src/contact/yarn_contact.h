#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/left_out.h"
#include "contact/centreline.h"
#include "contact/chord_contacts.h"
#include "contact/contact_points.h"
#include "contact/crossing_watch.h"
#include "contact/followed_contacts.h"
#include "contact/pair_watch.h"
#include "contact/smooth_contacts.h"
#include "contact/springs.h"
#include "model/frame.h"
#include "model/state.h"

namespace knitmech::contact {

/// Frictional contact of all yarns with each other and with themselves.
///
/// Owns what contact remembers: the neighbour list with the positions that it was made for, the places that are
/// followed, and the slip of each contact.
class YarnContact {
 public:
  explicit YarnContact(const model::Model& model);

  /// Adds normal and friction forces to the nodes.
  /// \param step [s] since the call before; velocities times step are the motion since then
  void add_forces(const model::State& state, double step, model::NodalLoads& loads,
                  const base::ThreadTeam& team = base::ThreadTeam(1));

  /// Stored in the penalty and the elastic stick at the last call of add_forces [mJ].
  [[nodiscard]] double energy() const;
  /// Dissipated since the start [mJ].
  [[nodiscard]] double friction_loss() const { return friction_loss_; }
  /// At the last call of add_forces [mm].
  [[nodiscard]] double largest_penetration() const { return largest_penetration_; }
  /// Contacts that carry a force, at the last call of add_forces.
  [[nodiscard]] std::vector<ContactPoint> points() const;
  [[nodiscard]] int n_contacts() const { return static_cast<int>(points().size()); }
  /// All contacts as springs, each as stiff as it is in its stiffest direction: they bound the frequencies that the
  /// contacts give the nodes.
  [[nodiscard]] Springs springs() const;
  /// The line that the contact sees, as of the last call of add_forces.
  [[nodiscard]] const Centreline& centreline() const { return centreline_; }
  [[nodiscard]] const std::optional<LostCrossing>& lost_crossing() const { return lost_; }
  /// Checks that no yarn has passed through another since the last check, apart from what the contact law sees
  /// (crossing_watch.h). Done besides whenever the neighbours are searched.
  void check_crossings(const base::ThreadTeam& team = base::ThreadTeam(1));
  [[nodiscard]] long crossing_checks() const { return crossing_checks_; }
  /// Yarn ends that have slipped out of loops since the start.
  [[nodiscard]] const std::vector<RavelEvent>& ravelled() const { return ravelled_; }
  [[nodiscard]] long searches() const { return searches_; }

  /// Fills the contact fields of a frame whose points are set: contact_force, gap, contacts.
  void set_contact_results(model::Frame& frame) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(elements_, pieces_, law_, skin_, smooth_forces_), centreline_, common_motion_, motion_,
            watch_, followed_, near_, chord_forces_, friction_loss_, largest_penetration_, lost_, crossing_watch_,
            ravelled_, searches_, crossing_checks_);
  }

 private:
  void search(const model::State& state, const base::ThreadTeam& team);
  [[nodiscard]] std::vector<ElementPair> search_all(const model::VectorArray& positions,
                                                    const std::vector<char>& is_due,
                                                    const base::ThreadTeam& team) const;
  void check_crossings(const model::VectorArray& positions, const base::ThreadTeam& team);
  void look(const base::ThreadTeam& team);

  YarnElements elements_;
  std::shared_ptr<const ContactElements> pieces_;  ///< shared with the watch over crossings
  Centreline centreline_;
  ContactLaw law_;
  double skin_ = 0;  ///< [mm]
  CommonMotion common_motion_;
  Motion motion_;
  PairWatch watch_;
  FollowedContacts followed_;
  SmoothForces smooth_forces_;
  std::vector<NearChords> near_;
  ChordForces chord_forces_;
  double friction_loss_ = 0;
  double largest_penetration_ = 0;  ///< [mm]
  std::optional<LostCrossing> lost_;
  CrossingWatch crossing_watch_;
  std::vector<RavelEvent> ravelled_;
  long searches_ = 0, crossing_checks_ = 0;
};

}  // namespace knitmech::contact
