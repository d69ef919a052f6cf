#include "contact/search_around.h"

#include <algorithm>
#include <cmath>

#include "base/segment_distance.h"
#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

/// Chord of a piece of the centreline, and how far the line may leave it.
struct PieceChord {
  std::int32_t piece;
  Vector3 start, along;
  double bulge;
};

/// Elements whose middle is nearer to a point than a reach, as flags of which there is one for each element.
KNITMECH_VECTORISE void find_near(Vector3 point, double reach, const double* x, const double* y, const double* z,
                                  std::size_t n, std::uint8_t* is_near) {
  const double limit = reach * reach;
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = 0.5 * (x[i] + x[i + 1]) - point.x;
    const double dy = 0.5 * (y[i] + y[i + 1]) - point.y;
    const double dz = 0.5 * (z[i] + z[i + 1]) - point.z;
    is_near[i] = dx * dx + dy * dy + dz * dz <= limit ? 1 : 0;
  }
}

class Around {
 public:
  Around(const ContactElements& pieces, const Centreline& line, double skin)
      : pieces_(pieces), line_(line), skin_(skin), is_near_(line.node_position().size()) {
    const model::VectorArray& x = line.node_position();
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      if (exists(i)) longest_ = std::max(longest_, length(x.at(i + 1) - x.at(i)));
    }
  }

  void search(std::int32_t due, const std::vector<std::int32_t>& all_due, std::vector<ElementPair>& pairs) {
    const auto a = static_cast<std::size_t>(due);
    if (!exists(a)) return;
    const model::VectorArray& x = line_.node_position();
    const double reach = longest_ + 2 * line_.largest_overhang() + 2 * pieces_.largest_radius + skin_;
    find_near(0.5 * (x.at(a) + x.at(a + 1)), reach, x.x.data(), x.y.data(), x.z.data(), x.size() - 1, is_near_.data());
    set_chords(due, own_);
    for (std::size_t b = 0; b + 1 < x.size(); ++b) {
      if (is_near_[b] == 0 || !exists(b)) continue;
      const auto other = static_cast<std::int32_t>(b);
      if (other < due && std::binary_search(all_due.begin(), all_due.end(), other)) continue;  // found from there
      set_chords(other, others_);
      compare(pairs);
    }
  }

 private:
  [[nodiscard]] bool exists(std::size_t element) const {
    return pieces_.exists[element * static_cast<std::size_t>(pieces_.pieces_per_element)] != 0;
  }

  void set_chords(std::int32_t element, std::vector<PieceChord>& chords) const {
    chords.clear();
    for (std::int32_t k = 0; k < pieces_.pieces_per_element; ++k) {
      const std::int32_t piece = element * pieces_.pieces_per_element + k;
      const Curve curve = line_.piece_curve(pieces_, piece);
      chords.push_back({piece, curve.start, curve.end - curve.start, line_.is_smooth() ? bulge(curve) : 0});
    }
  }

  void compare(std::vector<ElementPair>& pairs) const {
    const bool is_own = own_.front().piece == others_.front().piece;
    for (const PieceChord& p : own_) {
      for (const PieceChord& q : others_) {
        if (is_own && p.piece >= q.piece) continue;
        const PieceChord& a = p.piece < q.piece ? p : q;
        const PieceChord& b = p.piece < q.piece ? q : p;
        if (are_near(a, b)) pairs.push_back({a.piece, b.piece});
      }
    }
  }

  [[nodiscard]] bool are_near(const PieceChord& a, const PieceChord& b) const {
    const auto i = static_cast<std::size_t>(a.piece);
    const auto j = static_cast<std::size_t>(b.piece);
    const double reach = pieces_.radius_of(i) + pieces_.radius_of(j) + skin_ + a.bulge + b.bulge;
    const double far = reach + 0.5 * (length(a.along) + length(b.along));
    const Vector3 between = b.start + 0.5 * b.along - a.start - 0.5 * a.along;
    if (dot(between, between) > far * far || too_near_along_yarn(pieces_, i, j)) return false;
    const ClosestPoints at = closest_points(a.start, a.along, b.start, b.along);
    const Vector3 gap = b.start + at.t * b.along - a.start - at.s * a.along;
    return dot(gap, gap) < reach * reach;
  }

  const ContactElements& pieces_;
  const Centreline& line_;
  double skin_;
  double longest_ = 0;  ///< chord [mm]
  std::vector<std::uint8_t> is_near_;
  std::vector<PieceChord> own_, others_;
};

}  // namespace

std::vector<ElementPair> search_around(const std::vector<std::int32_t>& due, const ContactElements& pieces,
                                       const Centreline& line, double skin) {
  std::vector<ElementPair> pairs;
  Around around(pieces, line, skin);
  for (const std::int32_t element : due) around.search(element, due, pairs);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace knitmech::contact
