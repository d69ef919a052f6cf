#include "contact/touch_finder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vectorise.h"
#include "contact/constants.h"

namespace knitmech::contact {

namespace {

/// Rise of the squared distance along a yarn, see rise_along(), that is small beside that of yarns that cross [-].
constexpr double kEvenRise = 0.1;

/// Squared distances of points from a point, and the least of each before and now.
KNITMECH_VECTORISE void squared_distances(Vector3 from, std::size_t n, const double* x, const double* y,
                                          const double* z, double* squared, double* least) {
#pragma omp simd
  for (std::size_t j = 0; j < n; ++j) {
    const double dx = x[j] - from.x;
    const double dy = y[j] - from.y;
    const double dz = z[j] - from.z;
    squared[j] = dx * dx + dy * dy + dz * dz;
    least[j] = squared[j] < least[j] ? squared[j] : least[j];
  }
}

/// How the squared distance rises along a piece, from where it is least to where it is greatest, over the square of
/// the way [-]: 1 for straight yarns that cross at a right angle, 0 where they lie side by side.
double rise_along(const std::vector<double>& profile, double length) {
  const auto least = std::min_element(profile.begin(), profile.end());
  const auto most = std::max_element(profile.begin(), profile.end());
  const double way = static_cast<double>(most - least) * length / static_cast<double>(profile.size());
  return way == 0 ? 0 : (*most - *least) / (way * way);
}

}  // namespace

void TouchFinder::PointList::clear() {
  x.clear();
  y.clear();
  z.clear();
}

void TouchFinder::PointList::add(Vector3 v) {
  x.push_back(v.x);
  y.push_back(v.y);
  z.push_back(v.z);
}

double TouchFinder::length_of(std::int32_t piece) const {
  return elements_.length[static_cast<std::size_t>(pieces_.element_of(piece))] / pieces_.pieces_per_element;
}

CutPiece TouchFinder::cut(std::int32_t piece, double size) const {
  return {piece, std::clamp(static_cast<int>(std::ceil(length_of(piece) / size)), 1, kMostOnPiece)};
}

YarnPlace TouchFinder::place(std::int32_t piece, double on_piece) const {
  return {pieces_.element_of(piece), pieces_.place_on_element(piece, on_piece)};
}

void TouchFinder::middles(CutPiece of, PointList& points) const {
  const Curve curve = line_.curve(static_cast<std::size_t>(pieces_.element_of(of.piece)));
  points.clear();
  for (int i = 0; i < of.n; ++i) {
    points.add(combine(curve, hermite(pieces_.place_on_element(of.piece, (i + 0.5) / of.n))));
  }
}

void TouchFinder::find(ElementPair pair, bool was_on_second, PairTouches& found) {
  found.touches.clear();
  found.on_second = was_on_second;
  const double radii = radius(pair.first) + radius(pair.second);
  middles(cut(pair.first, kStripLength * radii), first_points_);
  middles(cut(pair.second, kStripLength * radii), second_points_);
  const double reach = radii * (1 + kFollowed) + 0.5 * kStripLength * radii;
  if (find_profiles() > reach * reach) return;
  found.on_second = cuts_second(pair, was_on_second);
  if (found.on_second) {
    add_touches(pair.second, pair.first, second_points_, second_profile_, found);
  } else {
    add_touches(pair.first, pair.second, first_points_, first_profile_, found);
  }
}

/// Squared distance of every point of each piece from the nearest one of the other. \return the least of all
double TouchFinder::find_profiles() {
  first_profile_.clear();
  second_profile_.assign(second_points_.size(), 1e300);
  squared_.resize(second_points_.size());
  for (std::size_t i = 0; i < first_points_.size(); ++i) {
    squared_distances(first_points_.at(i), second_points_.size(), second_points_.x.data(), second_points_.y.data(),
                      second_points_.z.data(), squared_.data(), second_profile_.data());
    first_profile_.push_back(*std::min_element(squared_.begin(), squared_.end()));
  }
  return *std::min_element(first_profile_.begin(), first_profile_.end());
}

/// Whether the second piece is the one to be cut into strips: that along which the distance changes less.
bool TouchFinder::cuts_second(ElementPair pair, bool was_on_second) const {
  const double first = rise_along(first_profile_, length_of(pair.first)) + kEvenRise;
  const double second = rise_along(second_profile_, length_of(pair.second)) + kEvenRise;
  if (second > kSidesAlike * first) return false;
  if (first > kSidesAlike * second) return true;
  return was_on_second;
}

void TouchFinder::add_touches(std::int32_t piece, std::int32_t other, const PointList& strip_points,
                              const std::vector<double>& profile, PairTouches& found) {
  const double radii = radius(piece) + radius(other);
  found.strips = {piece, static_cast<int>(strip_points.size())};
  const CutPiece cells = cut(other, kCellLength * radii);
  const Curve curve = line_.curve(static_cast<std::size_t>(pieces_.element_of(other)));
  const double reach = radii * (1 + kFollowed);
  const double far = reach + 0.5 * kStripLength * radii;
  cell_points_.clear();
  for (int j = 0; j <= 2 * cells.n; ++j) {
    cell_points_.add(combine(curve, hermite(pieces_.place_on_element(other, 0.5 * j / cells.n))));
  }
  squared_.resize(cell_points_.size());
  least_.assign(cell_points_.size(), 0.0);
  for (int i = 0; i < found.strips.n; ++i) {
    if (profile[static_cast<std::size_t>(i)] > far * far) continue;
    squared_distances(strip_points.at(static_cast<std::size_t>(i)), cell_points_.size(), cell_points_.x.data(),
                      cell_points_.y.data(), cell_points_.z.data(), squared_.data(), least_.data());
    const YarnPlace at = place(piece, (i + 0.5) / found.strips.n);
    const std::size_t before = found.touches.size();
    for (int c = 0; c < cells.n; ++c) {
      const std::size_t p = 2 * static_cast<std::size_t>(c);
      if (std::min({squared_[p], squared_[p + 1], squared_[p + 2]}) >= reach * reach) continue;
      if (too_near(at, place(other, (c + 0.5) / cells.n), radii)) continue;
      if (found.touches.size() > before && found.touches.back().last == c - 1) {
        found.touches.back().last = c;
      } else {
        found.touches.push_back({i, cells, c, c});
      }
    }
  }
}

/// Whether two places of one yarn are so near along it that they cannot touch.
bool TouchFinder::too_near(YarnPlace a, YarnPlace b, double radii) const {
  return elements_.yarn[static_cast<std::size_t>(a.element)] == elements_.yarn[static_cast<std::size_t>(b.element)] &&
         std::abs(arc_of(elements_, a) - arc_of(elements_, b)) < kSelfContactArc * std::numbers::pi * radii;
}

}  // namespace knitmech::contact
