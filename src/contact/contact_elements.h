#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

namespace knitmech::contact {

/// The yarns as the search for contacts cuts them: into pieces, one or several to an element, so that no piece is bent
/// much even where the mesh is coarse. Contact node i joins piece i to the one before; the vectors have one entry per
/// contact node, the pieces follow each other along the yarns as the elements do.
struct ContactElements {
  int pieces_per_element = 1;        ///< m; contact node m i is node i of the model
  std::vector<std::int32_t> yarn;    ///< yarn of the contact node
  std::vector<std::uint8_t> exists;  ///< 1 where a piece starts
  std::vector<double> radius;        ///< of the element, one entry per node of the model [mm]
  std::vector<double> arc_length;    ///< of the contact node, along the stress-free yarn from its first node [mm]
  double largest_radius = 0;         ///< [mm]

  [[nodiscard]] std::size_t n_nodes() const { return yarn.size(); }
  [[nodiscard]] bool has_previous(std::size_t piece) const { return piece > 0 && exists[piece - 1] != 0; }
  [[nodiscard]] bool has_next(std::size_t piece) const { return piece + 1 < exists.size() && exists[piece + 1] != 0; }
  [[nodiscard]] std::int32_t element_of(std::int32_t piece) const { return piece / pieces_per_element; }
  [[nodiscard]] double radius_of(std::size_t piece) const {
    return radius[piece / static_cast<std::size_t>(pieces_per_element)];
  }
  /// Share of the way along the element of a place on a piece.
  [[nodiscard]] double place_on_element(std::int32_t piece, double place) const {
    return (piece % pieces_per_element + place) / pieces_per_element;
  }
};

/// Cuts the yarns of a model for the contact: chords are the elements themselves; on the smooth centreline, elements
/// are cut until no piece of the stress-free yarn turns by more than kPieceTurn (constants.h).
[[nodiscard]] ContactElements make_contact_elements(const model::Model& model);

}  // namespace knitmech::contact
