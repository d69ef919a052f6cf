#include "contact/smooth_contacts.h"

#include <algorithm>
#include <cmath>

#include "base/segment_distance.h"
#include "contact/constants.h"
#include "contact/curve_distance.h"
#include "contact/normal_law.h"
#include "contact/overlap.h"

namespace knitmech::contact {

namespace {

Vector3 unit(Vector3 v) {
  return (1 / length(v)) * v;
}

/// Distance from a node within which a place lies on it [share of the piece].
constexpr double kOnNode = 1e-9;

/// Whether a closest place on a piece is this piece's to count: one at a node belongs to the piece that starts there,
/// and is no minimum if the distance falls further along the piece before. \param slope derivative of half the squared
/// distance by the place [mm^2]   \param bend its second derivative [mm^2]
bool counts_here(const ContactElements& elements, std::size_t piece, double place, double slope, double bend) {
  if (place >= 1 - kOnNode) return !elements.has_next(piece);
  if (place <= 0) return !elements.has_previous(piece) || slope <= kOnNode * bend;
  return true;
}

/// Whether the closest place would go on beyond this place if it could: false only at the end of a yarn.
bool goes_on(const ContactElements& elements, std::size_t piece, double place) {
  return (place > 0 || elements.has_previous(piece)) && (place < 1 || elements.has_next(piece));
}

/// The gap of the yarn whose place is s, along it. Its curvature follows from the second derivatives f of half the
/// squared distance, with the other place following: (f_ss - f_st^2 / f_tt) / (distance |x'|^2). \param follows whether
/// the other place is free to follow
GapParabola gap_along(double f_ss, double f_st, double f_tt, double slope, double size, double distance, double radii,
                      double place, bool follows) {
  const double bend = follows ? f_ss - f_st * f_st / f_tt : f_ss;
  return {radii - distance, slope / (distance * size), bend / (distance * size * size), -place * size,
          (1 - place) * size};
}

class PairContact {
 public:
  PairContact(const ContactElements& elements, const Centreline& centreline, ElementPair pair,
              std::vector<ContactPoint>& found)
      : elements_(elements),
        found_(found),
        pair_(pair),
        first_element_(static_cast<std::size_t>(pair.first)),
        second_element_(static_cast<std::size_t>(pair.second)),
        first_(centreline.curve(elements, first_element_)),
        second_(centreline.curve(elements, second_element_)),
        radii_(elements.radius[first_element_] + elements.radius[second_element_]),
        line_stiffness_(kLineStiffness * elements.stiffness / radii_) {}

  /// Returns a gap [mm] that the pair certainly has: 0 if it touches or nothing is certain.
  double find(PairPlaces& places) {
    const Vector3 along_first = first_.end - first_.start;
    const Vector3 along_second = second_.end - second_.start;
    const ClosestPoints chords = closest_points(first_.start, along_first, second_.start, along_second);
    const Vector3 between = second_.start + chords.t * along_second - first_.start - chords.s * along_first;
    const double gap = length(between) - bulge(first_) - bulge(second_) - radii_;
    if (gap > 0) return gap;

    if (places.s < 0) places = {chords.s, chords.t};
    const CurveApproach at = closest_on_curves(first_, second_, places.s, places.t);
    places = {at.s, at.t};
    const double distance = length(at.between);
    if (at.is_minimum && distance >= radii_) return distance - radii_;
    // Without a distinct closest place, what Newton's method stopped at says nothing about the rest of the pieces.
    if (!at.is_minimum || !add_crossing(at, distance)) add_samples();
    return 0;
  }

 private:
  /// The overlap about a closest point; false if it is too long for a parabola.
  bool add_crossing(const CurveApproach& at, double distance) {
    const double size_s = length(at.first_slope);
    const double size_t_ = length(at.second_slope);
    const double ss = size_s * size_s - dot(at.between, at.first_bend);
    const double st = -dot(at.first_slope, at.second_slope);
    const double tt = size_t_ * size_t_ + dot(at.between, at.second_bend);
    const bool s_goes_on = goes_on(elements_, first_element_, at.s);
    const bool t_goes_on = goes_on(elements_, second_element_, at.t);
    // Inside a piece the slope is what Newton's method left of it, far below rounding of the load.
    const bool s_inside = at.s > 0 && at.s < 1;
    const bool t_inside = at.t > 0 && at.t < 1;
    const GapParabola along_first =
        gap_along(ss, st, tt, s_inside ? 0 : at.slope_s, size_s, distance, radii_, at.s, t_goes_on);
    const GapParabola along_second =
        gap_along(tt, st, ss, t_inside ? 0 : at.slope_t, size_t_, distance, radii_, at.t, s_goes_on);
    if (along_first.curvature <= 0 || along_second.curvature <= 0) return false;
    const double longest = kShortOverlap * radii_;
    const double least_curvature = std::min(along_first.curvature, along_second.curvature);
    if (2 * along_first.depth > least_curvature * longest * longest) return false;

    const Overlap on_first = integrate(along_first, radii_);
    const Overlap on_second = integrate(along_second, radii_);
    const bool first_counts = counts_here(elements_, second_element_, at.t, at.slope_t, tt);
    const bool second_counts = counts_here(elements_, first_element_, at.s, at.slope_s, ss);
    const Vector3 normal = (1 / distance) * at.between;
    if (first_counts && second_counts && on_first.centre == 0 && on_second.centre == 0) {
      const Overlap both{on_first.load + on_second.load, on_first.tangent + on_second.tangent,
                         on_first.energy + on_second.energy, 0, 0};
      add(kWholeCrossing, at.s, at.t, normal, along_first.depth, both);
      return true;
    }
    // Where the resultant acts beside the closest place, the place on the other yarn follows.
    const double ds = on_first.centre / size_s;
    const double dt = on_second.centre / size_t_;
    if (first_counts) {
      add(kFirstHalf, at.s + ds, at.t - (t_goes_on ? ds * st / tt : 0), normal, along_first.depth, on_first);
    }
    if (second_counts) {
      add(kSecondHalf, at.s - (s_goes_on ? dt * st / ss : 0), at.t + dt, normal, along_second.depth, on_second);
    }
    return true;
  }

  void add(unsigned sample, double s, double t, Vector3 normal, double penetration, const Overlap& overlap) {
    if (overlap.load <= 0) return;
    const double half = 0.5 * line_stiffness_;
    if (overlap.centre != 0) normal = unit(combine(second_, hermite(t)) - combine(first_, hermite(s)));
    found_.push_back({contact_key(pair_.first, pair_.second, sample), pair_.first, pair_.second, s, t, normal,
                      penetration, half * overlap.load, half * overlap.tangent, half * overlap.energy});
  }

  void add_samples() {
    sample(first_, second_, first_element_, second_element_, false);
    sample(second_, first_, second_element_, first_element_, true);
  }

  /// Samples one piece against the other.
  /// \param swapped the sampled piece is the second of the pair
  void sample(const Curve& sampled, const Curve& other, std::size_t element, std::size_t other_element, bool swapped) {
    const double piece = elements_.curve_length[element];
    const auto n = static_cast<unsigned>(std::clamp(std::ceil(piece / (kSampleSpacing * radii_)), 1.0, kMostSamples));
    const Vector3 along = other.end - other.start;
    const double reach = radii_ + bulge(other);
    for (unsigned i = 0; i < n; ++i) {
      const double place = (i + 0.5) / n;
      const Vector3 here = combine(sampled, hermite(place));
      const double start = closest_on_segment(here, other.start, along);
      const Vector3 to_chord = other.start + start * along - here;
      if (dot(to_chord, to_chord) >= reach * reach) continue;
      const CurveApproach at = closest_on_second(sampled, other, place, start);
      const double distance = length(at.between);
      if (!at.is_minimum || distance >= radii_) continue;
      const double bend = dot(at.second_slope, at.second_slope) + dot(at.between, at.second_bend);
      if (!counts_here(elements_, other_element, at.t, at.slope_t, bend)) continue;
      const double share = length(at.first_slope) / n;  // of the yarn's length [mm]
      const double depth = radii_ - distance;
      const Overlap overlap{share * normal_force(depth, radii_), share * normal_tangent(depth, radii_),
                            share * normal_energy(depth, radii_), 0, 0};
      const Vector3 normal = (swapped ? -1 / distance : 1 / distance) * at.between;
      const unsigned slot = kFirstSample + i + (swapped ? static_cast<unsigned>(kMostSamples) : 0U);
      add(slot, swapped ? at.t : at.s, swapped ? at.s : at.t, normal, depth, overlap);
    }
  }

  const ContactElements& elements_;
  std::vector<ContactPoint>& found_;
  ElementPair pair_;
  std::size_t first_element_, second_element_;
  Curve first_, second_;
  double radii_, line_stiffness_;
};

}  // namespace

void find_smooth_contacts(const ContactElements& elements, const std::vector<ElementPair>& pairs,
                          const Centreline& centreline, PairClock& clock, std::vector<PairPlaces>& places,
                          std::vector<ContactPoint>& found) {
  found.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (clock.may_sleep(p)) continue;
    const double gap = PairContact(elements, centreline, pairs[p], found).find(places[p]);
    if (gap > 0) clock.sleep(p, gap);
  }
}

}  // namespace knitmech::contact
