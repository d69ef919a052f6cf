#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "base/left_out.h"
#include "contact/contact_points.h"
#include "contact/element_load.h"
#include "contact/friction.h"
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
  std::int32_t strip = 0;  ///< which of the piece's
  CutPiece cells{};
  std::int32_t first = 0, last = 0;  ///< which of them
  bool operator==(const Touch&) const = default;
  bool operator<(const Touch& other) const {
    return std::tie(strip, cells, first, last) < std::tie(other.strip, other.cells, other.first, other.last);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(strip, cells, first, last);
  }
};

/// Cells of one piece that an overlap has to do with. Each has a point at its start, its middle and its end, the last
/// being the first of the next cell.
struct CellRow {
  CutPiece cells{};
  std::int32_t first = 0, last = 0;  ///< which of them
  std::int32_t first_point = 0;      ///< among the points of all rows of the overlap, see PlacedPoints
  [[nodiscard]] std::int32_t n_points() const { return 2 * (last - first) + 3; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(cells, first, last, first_point);
  }
};

/// Cells, one after the other in a row, that a strip sees.
struct CellSpan {
  std::int32_t row = 0;          ///< of the overlap
  std::int32_t first_point = 0;  ///< among the points of all rows of the overlap
  std::int32_t n_cells = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(row, first_point, n_cells);
  }
};

/// A short length of a yarn in a long overlap, and the cells of the other yarn that are near it. Both stay where they
/// are on the yarns until the next look.
struct Strip {
  std::int32_t number = 0;  ///< which of the piece's
  std::int32_t first_span = 0, n_spans = 0;
  YarnPlace at{};         ///< middle of the strip
  YarnPlace other{};      ///< the point of the other yarn that presses most, or is nearest
  double wake = 0;        ///< motion of the elements since the start before which no force can be here [mm]
  ContactState now = {};  ///< normal and slip are those from the yarn of the strip to the other

  template <class Archive>
  void serialize(Archive& archive) {
    archive(number, first_span, n_spans, at, other, wake, now);
  }
};

/// The strips on one piece of a yarn, with all they may touch.
struct Overlap {
  CutPiece strips{};
  std::vector<Touch> touches;        ///< ascending, whether crossings count them or not
  std::vector<CellRow> rows;         ///< ascending by their pieces
  std::vector<CellSpan> spans;       ///< of each strip ascending by their points
  std::vector<Strip> laid;           ///< ascending by their number; those that no crossing counts
  std::vector<ElementLoad> loads{};  ///< of this step

  template <class Archive>
  void serialize(Archive& archive) {
    archive(strips, touches, rows, spans, laid, base::left_out(loads));
  }
};

/// Where the strips of an overlap begin among others, which are sorted by their pieces.
[[nodiscard]] inline bool is_before(const Overlap& overlap, const CutPiece& piece) {
  return overlap.strips < piece;
}

}  // namespace knitmech::contact
