#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "contact/contact_points.h"
#include "contact/friction.h"
#include "contact/neighbour_search.h"
#include "contact/placed_points.h"
#include "contact/yarn_elements.h"

namespace knitmech::contact {

/// What a followed contact did in the last step; no load where it did nothing.
struct ContactState {
  double penetration = 0;      ///< [mm]
  double load = 0;             ///< normal force [N]
  double tangent = 0;          ///< its derivative by the penetration [N/mm]
  double energy = 0;           ///< stored in the normal law [mJ]
  double stick_stiffness = 0;  ///< [N/mm]
  SlipMemory stick = {};

  template <class Archive>
  void serialize(Archive& archive) {
    archive(penetration, load, tangent, energy, stick_stiffness, stick);
  }
};

/// A pair of places where two yarns come closest, followed from step to step.
struct Crossing {
  YarnPlace first{}, second{};  ///< first.element < second.element
  double gap = 0;               ///< [mm], when last looked at
  bool is_minimum = true;       ///< when last looked at
  double wake = 0;          ///< motion of both elements since the last search before which no force can be here [mm]
  bool is_short = false;    ///< counts; else strips count the overlap
  double first_reach = 0;   ///< how far the overlap may reach along the first yarn from here [mm]
  double second_reach = 0;  ///< along the second
  ContactState now = {};

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first, second, gap, is_minimum, wake, is_short, first_reach, second_reach, now);
  }
};

/// Cells of the other yarn that a strip sees: stretches of equal length that follow each other on one element, each
/// with a point at its start, its middle and its end.
struct CellSpan {
  std::size_t block = 0;        ///< of FollowedContacts::points
  std::size_t first_point = 0;  ///< in it; cells share the points between them
  std::size_t n_cells = 0;
  double cell_length = 0;  ///< along the stress-free yarn [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(block, first_point, n_cells, cell_length);
  }
};

/// A short length of a yarn in a long overlap, and the cells of the other yarn that are near it. Both stay where they
/// are on the yarns until the next look.
struct Strip {
  YarnPlace at{};              ///< middle of the strip
  YarnPlace other{};           ///< the point of the other yarn that presses most, or is nearest
  std::size_t block = 0;       ///< of FollowedContacts::points
  std::size_t point = 0;       ///< in it, that of `at`
  std::size_t first_span = 0;  ///< index into FollowedContacts::spans
  std::size_t n_spans = 0;
  double length = 0;      ///< stress-free, of the strip [mm]
  double wake = 0;        ///< motion of both elements since the last search before which no force can be here [mm]
  ContactState now = {};  ///< normal and slip are those from the yarn of the strip to the other

  template <class Archive>
  void serialize(Archive& archive) {
    archive(at, other, block, point, first_span, n_spans, length, wake, now);
  }
};

/// A piece of a yarn, cut into n equal parts.
struct CutPiece {
  std::int32_t piece = 0;
  std::int32_t n = 1;
  bool operator==(const CutPiece&) const = default;
  bool operator<(const CutPiece& other) const { return std::tie(piece, n) < std::tie(other.piece, other.n); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(piece, n);
  }
};

/// A strip, and cells of one piece, one after the other, that it may touch.
struct Touch {
  CutPiece strips{};
  std::int32_t strip = 0;  ///< which of them
  CutPiece cells{};
  std::int32_t first = 0, last = 0;  ///< which of them
  bool operator<(const Touch& other) const {
    return std::tie(strips, strip, cells, first) < std::tie(other.strips, other.strip, other.cells, other.first);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(strips, strip, cells, first, last);
  }
};

/// The touches of a pair of pieces, and which of the two is cut into strips.
struct PairTouches {
  ElementPair pair{};
  bool on_second = false;
  std::size_t first_touch = 0, n_touches = 0;  ///< in FollowedContacts::touches

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pair, on_second, first_touch, n_touches);
  }
};

/// All places that are followed.
struct FollowedContacts {
  std::vector<Crossing> crossings;
  std::vector<Strip> strips;
  std::vector<CellSpan> spans;
  PlacedPoints points;
  std::vector<PairTouches> pairs;  ///< that may touch, ascending
  std::vector<Touch> touches;      ///< whether crossings count them or not

  template <class Archive>
  void serialize(Archive& archive) {
    archive(crossings, strips, spans, points, pairs, touches);
  }
};

/// The contacts that carry a force.
[[nodiscard]] std::vector<ContactPoint> contact_points(const FollowedContacts& contacts);

}  // namespace knitmech::contact
