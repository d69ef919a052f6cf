#pragma once

#include "contact/contact_elements.h"
#include "contact/curve.h"
#include "model/state.h"

namespace knitmech::contact {

/// The line that the contact sees of every yarn: the straight chords of the elements, or the smooth curve through the
/// nodes.
///
/// Contact finds places on it, takes velocities from them and gives forces to them; this is the one place that knows
/// how a place depends on the nodes.
class Centreline {
 public:
  Centreline(const model::Model& model, const ContactElements& elements);

  /// Moves the line to where the nodes are.
  /// \return a length that no point of it has moved by more than [mm]: the curve stays within the hull of its Bezier
  /// points, which are the nodes and points a third of an element's arc length off them along the tangents
  double update(const model::State& state);

  /// Of the contact nodes [mm].
  [[nodiscard]] const model::VectorArray& position() const { return position_; }
  /// The curve of a piece; its straight chord on chords.
  [[nodiscard]] Curve curve(const ContactElements& elements, std::size_t piece) const;
  /// Velocity of the material at a place [mm/s].
  [[nodiscard]] Vector3 velocity(const ContactElements& elements, const model::State& state, std::int32_t piece,
                                 double place) const;
  /// Gives a force at a place to the nodes: with the weights that make up the place from the nodes, so that force and
  /// motion do the same work. On the smooth centreline, turning a node moves the place, hence moments too.
  void spread(const ContactElements& elements, std::int32_t piece, double place, Vector3 force,
              model::NodalLoads& loads) const;

 private:
  void update_inner_points(const model::State& state);

  bool smooth_;
  std::size_t pieces_per_element_;
  std::vector<double> element_length_;  ///< [mm], along the stress-free yarn, one entry per node; 0 where none starts
  double reach_of_turn_ = 0;            ///< [mm], a third of the longest
  model::VectorArray stress_free_tangent_;
  model::VectorArray tangent_;        ///< at the nodes, turned with them; unit vectors
  model::VectorArray node_position_;  ///< [mm]
  model::VectorArray position_;       ///< at the contact nodes [mm]
  model::VectorArray direction_;      ///< there, derivative of the curve by the stress-free arc length [-]
};

}  // namespace knitmech::contact
