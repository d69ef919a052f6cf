#pragma once

#include "base/left_out.h"
#include "base/thread_team.h"
#include "contact/contact_elements.h"
#include "contact/element_line.h"
#include "contact/motion.h"
#include "contact/yarn_elements.h"
#include "model/state.h"

namespace knitmech::contact {

/// The line that the contact sees of every yarn: the straight chords of the elements, or the smooth curve through the
/// nodes.
///
/// The curve's tangents turn with their nodes, and half of each element's bow with either of its nodes.
///
/// Contact finds places on it, takes velocities from them and gives forces to them; this is the one place that knows
/// how a place depends on the nodes.
class Centreline {
 public:
  explicit Centreline(const model::Model& model);

  /// Moves the line to where the nodes are.
  /// \param common what is not counted as motion   \param step [s], that the common motion went on for
  void update(const model::State& state, CommonMotion common, double step,
              const base::ThreadTeam& team = base::ThreadTeam(1));

  /// How far the parts of the line that belong to each node moved in the last update at most, beside the common motion
  /// [mm]: the cubic stays within the hull of its Bezier points, which are the nodes and points a third of an element's
  /// arc length off them along the tangents; the bows come on top. Yarns that spin about themselves do not move.
  [[nodiscard]] const std::vector<double>& moved() const { return moved_; }
  /// What of it is because the nodes turned [mm].
  [[nodiscard]] const std::vector<double>& turned() const { return turned_; }

  [[nodiscard]] bool is_smooth() const { return smooth_; }
  /// How far the line of an element can be from its chord's nearer end, beyond half the chord's length, at most [mm].
  [[nodiscard]] double largest_overhang() const { return longest_third_ + largest_bow_; }
  /// Of the nodes [mm].
  [[nodiscard]] const model::VectorArray& node_position() const { return node_position_; }
  /// Of the contact nodes [mm]; the nodes themselves on chords.
  [[nodiscard]] model::VectorArray piece_positions(const ContactElements& pieces) const;

  /// An element of the smooth line.
  [[nodiscard]] KNITMECH_INLINE ElementLine element(std::size_t i) const {
    return {length_[i],         node_position_.at(i), node_position_.at(i + 1), tangent_.at(i),
            tangent_.at(i + 1), bow_after_.at(i),     bow_before_.at(i + 1)};
  }
  [[nodiscard]] KNITMECH_INLINE Curve curve(std::size_t i) const { return element(i).curve(); }
  /// The curve of a piece of an element; its straight chord on chords.
  [[nodiscard]] Curve piece_curve(const ContactElements& pieces, std::int32_t piece) const;

  [[nodiscard]] KNITMECH_INLINE Hold hold(YarnPlace place) const {
    if (!smooth_) return {1 - place.share, place.share, {0, 0, 0}, {0, 0, 0}};
    return element(static_cast<std::size_t>(place.element)).hold(hermite(place.share));
  }

  /// The point of the line at a place [mm].
  [[nodiscard]] Vector3 point(YarnPlace place) const {
    const auto i = static_cast<std::size_t>(place.element);
    if (smooth_) return point_at(curve(i), place.share).position;
    return (1 - place.share) * node_position_.at(i) + place.share * node_position_.at(i + 1);
  }

  /// Velocity of the material at a place [mm/s].
  [[nodiscard]] KNITMECH_INLINE Vector3 velocity(const model::State& state, YarnPlace place) const {
    const auto i = static_cast<std::size_t>(place.element);
    return velocity_of(hold(place), state.velocity.at(i), state.velocity.at(i + 1), state.angular_velocity.at(i),
                       state.angular_velocity.at(i + 1));
  }

  /// Gives a force at a place to the nodes: with the weights that make up the place from the nodes, so that force and
  /// motion do the same work. On the smooth centreline, turning a node moves the place, hence moments too.
  KNITMECH_INLINE void spread(YarnPlace place, Vector3 force, model::NodalLoads& loads) const {
    const auto i = static_cast<std::size_t>(place.element);
    const Hold by = hold(place);
    loads.force.add(i, by.start * force);
    loads.force.add(i + 1, by.end * force);
    loads.moment.add(i, cross(by.start_arm, force));
    loads.moment.add(i + 1, cross(by.end_arm, force));
  }

  /// The same for a load on the smooth curve with its slope and bend.
  KNITMECH_INLINE void spread(YarnPlace place, const CurveLoad& load, model::NodalLoads& loads) const {
    const auto i = static_cast<std::size_t>(place.element);
    const EndLoads ends = element(i).to_nodes(place.share, load);
    loads.force.add(i, ends.start_force);
    loads.force.add(i + 1, ends.end_force);
    loads.moment.add(i, ends.start_moment);
    loads.moment.add(i + 1, ends.end_moment);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(smooth_, length_, longest_third_, largest_bow_, stress_free_tangent_, stress_free_bow_),
            tangent_, bow_after_, bow_before_, node_position_, moved_, turned_);
  }

 private:
  void set_stress_free(const model::Model& model);

  bool smooth_;
  std::vector<double> length_;  ///< of the elements [mm], along the stress-free yarn, one entry per node
  double longest_third_ = 0;    ///< of an element [mm]: largest distance of a Bezier point from its node
  double largest_bow_ = 0;      ///< largest distance of the line from its cubic [mm]
  model::VectorArray stress_free_tangent_;
  /// Half the bow of the element before each node, and at the end none: that after node i is entry i + 1 [mm].
  model::VectorArray stress_free_bow_;
  model::VectorArray tangent_;                 ///< at the nodes, turned with them; unit vectors
  model::VectorArray bow_after_, bow_before_;  ///< half the bow of the element after, before a node, turned with it
  model::VectorArray node_position_;           ///< [mm]
  std::vector<double> moved_, turned_;         ///< [mm], one entry per node
};

}  // namespace knitmech::contact
