#pragma once

#include "contact/contact_elements.h"
#include "contact/curve.h"
#include "contact/line_potential.h"
#include "contact/motion.h"
#include "contact/yarn_elements.h"
#include "model/state.h"

namespace knitmech::contact {

/// How a place hangs on the two nodes of its element: it moves by start dx_a + end dx_b, and where the nodes turn by
/// small rotations w_a and w_b, by w_a x start_arm + w_b x end_arm besides.
struct Hold {
  double start, end;
  Vector3 start_arm, end_arm;  ///< [mm], zero on chords
};

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
  void update(const model::State& state, CommonMotion common, double step);

  /// How far the parts of the line that belong to each node moved in the last update at most, beside the common motion
  /// [mm]: the cubic stays within the hull of its Bezier points, which are the nodes and points a third of an element's
  /// arc length off them along the tangents; the bows come on top. A vector that turns with a node changes by no more
  /// than twice its length times the change of the node's quaternion.
  [[nodiscard]] const std::vector<double>& moved() const { return moved_; }

  [[nodiscard]] bool is_smooth() const { return smooth_; }
  /// Of the nodes [mm].
  [[nodiscard]] const model::VectorArray& node_position() const { return node_position_; }
  /// Of the contact nodes [mm]; the nodes themselves on chords.
  [[nodiscard]] model::VectorArray piece_positions(const ContactElements& pieces) const;

  /// The smooth curve of an element.
  [[nodiscard]] KNITMECH_INLINE Curve curve(std::size_t element) const {
    const double size = length_[element];
    return {node_position_.at(element), node_position_.at(element + 1), size * tangent_.at(element),
            size * tangent_.at(element + 1), bow_after_.at(element) + bow_before_.at(element + 1)};
  }
  /// The curve of a piece of an element; its straight chord on chords.
  [[nodiscard]] Curve piece_curve(const ContactElements& pieces, std::int32_t piece) const;

  /// Where a node is, its tangent, and the halves of the bows beside it, turned with it.
  [[nodiscard]] KNITMECH_INLINE Vector3 tangent(std::size_t node) const { return tangent_.at(node); }
  [[nodiscard]] KNITMECH_INLINE Vector3 bow_after(std::size_t node) const { return bow_after_.at(node); }
  [[nodiscard]] KNITMECH_INLINE Vector3 bow_before(std::size_t node) const { return bow_before_.at(node); }
  [[nodiscard]] KNITMECH_INLINE double length(std::size_t element) const { return length_[element]; }

  /// \param weights hermite() at a place, or one of its derivatives   @pre the line is smooth
  [[nodiscard]] KNITMECH_INLINE Hold hold(std::size_t element, HermiteWeights weights) const {
    const double size = length_[element];
    return {weights.start, weights.end,
            (size * weights.start_slope) * tangent_.at(element) + weights.bow * bow_after_.at(element),
            (size * weights.end_slope) * tangent_.at(element + 1) + weights.bow * bow_before_.at(element + 1)};
  }
  [[nodiscard]] KNITMECH_INLINE Hold hold(YarnPlace place) const {
    const auto element = static_cast<std::size_t>(place.element);
    if (!smooth_) return {1 - place.share, place.share, {0, 0, 0}, {0, 0, 0}};
    return hold(element, hermite(place.share));
  }

  /// Velocity of the material at a place [mm/s].
  [[nodiscard]] KNITMECH_INLINE Vector3 velocity(const model::State& state, YarnPlace place) const {
    const auto i = static_cast<std::size_t>(place.element);
    const Hold by = hold(place);
    const Vector3 moving = by.start * state.velocity.at(i) + by.end * state.velocity.at(i + 1);
    if (!smooth_) return moving;
    return moving + cross(state.angular_velocity.at(i), by.start_arm) +
           cross(state.angular_velocity.at(i + 1), by.end_arm);
  }

  /// Gives a force at a place to the nodes: with the weights that make up the place from the nodes, so that force and
  /// motion do the same work. On the smooth centreline, turning a node moves the place, hence moments too.
  KNITMECH_INLINE void spread(YarnPlace place, Vector3 force, model::NodalLoads& loads) const {
    const auto i = static_cast<std::size_t>(place.element);
    const Hold by = hold(place);
    loads.force.add(i, by.start * force);
    loads.force.add(i + 1, by.end * force);
    if (!smooth_) return;
    loads.moment.add(i, cross(by.start_arm, force));
    loads.moment.add(i + 1, cross(by.end_arm, force));
  }

  /// The same for a load on the smooth curve with its slope and bend.
  KNITMECH_INLINE void spread(YarnPlace place, const CurveLoad& load, model::NodalLoads& loads) const {
    const auto i = static_cast<std::size_t>(place.element);
    const HermiteWeights value = hermite(place.share);
    const HermiteWeights slope = hermite_slope(place.share);
    const HermiteWeights bend = hermite_bend(place.share);
    // The weights of the two positions add up to one, and so those of their derivatives to zero.
    const Vector3 on_end = value.end * load.force + slope.end * load.slope + bend.end * load.bend;
    loads.force.add(i, load.force - on_end);
    loads.force.add(i + 1, on_end);
    const Vector3 on_bow = value.bow * load.force + slope.bow * load.slope + bend.bow * load.bend;
    const Vector3 turns_start =
        value.start_slope * load.force + slope.start_slope * load.slope + bend.start_slope * load.bend;
    const Vector3 turns_end = value.end_slope * load.force + slope.end_slope * load.slope + bend.end_slope * load.bend;
    loads.moment.add(i, length_[i] * cross(tangent_.at(i), turns_start) + cross(bow_after_.at(i), on_bow));
    loads.moment.add(i + 1, length_[i] * cross(tangent_.at(i + 1), turns_end) + cross(bow_before_.at(i + 1), on_bow));
  }

 private:
  void set_stress_free(const model::Model& model);

  bool smooth_;
  std::vector<double> length_;  ///< of the elements [mm], along the stress-free yarn, one entry per node
  double reach_of_turn_ = 0;    ///< [mm], largest distance of a Bezier point from its node, with the bow
  model::VectorArray stress_free_tangent_;
  model::VectorArray stress_free_bow_after_, stress_free_bow_before_;  ///< of the nodes, see below [mm]
  model::VectorArray tangent_;                                         ///< at the nodes, turned with them; unit vectors
  model::VectorArray bow_after_, bow_before_;  ///< half the bow of the element after, before a node, turned with it
  model::RotationArray rotation_;              ///< of the nodes
  model::VectorArray node_position_;           ///< [mm]
  std::vector<double> moved_;                  ///< [mm], one entry per node
};

}  // namespace knitmech::contact
