#pragma once

#include <vector>

#include "contact/centreline.h"
#include "contact/contact_elements.h"
#include "contact/neighbour_search.h"
#include "contact/overlap.h"

namespace knitmech::contact {

/// What a pair of pieces may touch in.
struct PairTouches {
  bool on_second = false;  ///< which of the two is cut into strips
  CutPiece strips{};
  std::vector<Touch> touches;  ///< ascending
};

/// Finds the strips and cells of pairs of pieces that may touch: those nearer than kFollowed (constants.h).
class TouchFinder {
 public:
  TouchFinder(const YarnElements& elements, const ContactElements& pieces, const Centreline& line)
      : elements_(elements), pieces_(pieces), line_(line) {}

  /// \param was_on_second kept where both yarns are alike   \param found replaced
  void find(ElementPair pair, bool was_on_second, PairTouches& found);

 private:
  /// Points as separate components.
  struct PointList {
    std::vector<double> x, y, z;
    void clear();
    void add(Vector3 v);
    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] Vector3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  };

  [[nodiscard]] double radius(std::int32_t piece) const { return pieces_.radius_of(static_cast<std::size_t>(piece)); }
  [[nodiscard]] double length_of(std::int32_t piece) const;
  [[nodiscard]] CutPiece cut(std::int32_t piece, double size) const;
  [[nodiscard]] YarnPlace place(std::int32_t piece, double on_piece) const;
  void middles(CutPiece of, PointList& points) const;
  double find_profiles();
  [[nodiscard]] bool cuts_second(ElementPair pair, bool was_on_second) const;
  void add_touches(std::int32_t piece, std::int32_t other, const PointList& strip_points,
                   const std::vector<double>& profile, PairTouches& found);
  [[nodiscard]] bool too_near(YarnPlace a, YarnPlace b, double radii) const;

  const YarnElements& elements_;
  const ContactElements& pieces_;
  const Centreline& line_;
  PointList first_points_, second_points_, cell_points_;
  std::vector<double> first_profile_, second_profile_, squared_, least_;
};

}  // namespace knitmech::contact
