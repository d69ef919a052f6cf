#include "contact/gauss_integral.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace knitmech::contact {

namespace {

constexpr double kSphere = 4 * std::numbers::pi;

/// A corner of a surface, seen from zero.
struct Corner {
  Vector3 at;       ///< [mm]
  double distance;  ///< [mm]
};

Corner corner(Vector3 at) {
  return {at, length(at)};
}

/// Solid angle of a triangle seen from zero [sr], positive where its normal (b - a) x (c - a) points away from zero.
/// Van Oosterom and Strackee 1983, doi:10.1109/TBME.1983.325207: no cancellation in thin triangles.
double solid_angle(const Corner& a, const Corner& b, const Corner& c) {
  const double volume = dot(a.at, cross(b.at, c.at));
  const double cosines = a.distance * b.distance * c.distance + dot(a.at, b.at) * c.distance +
                         dot(b.at, c.at) * a.distance + dot(c.at, a.at) * b.distance;
  return 2 * std::atan2(volume, cosines);
}

/// The differences x_b - x_a between the ends of two segments: first index along a, second along b.
struct Differences {
  Corner start_start, end_start, end_end, start_end;
};

Differences differences(const Segment& a, const Segment& b) {
  return {corner(b.start - a.start), corner(b.start - a.end), corner(b.end - a.end), corner(b.end - a.start)};
}

/// Of the parallelogram of the differences.
double solid_angle(const Differences& d) {
  return solid_angle(d.start_start, d.end_start, d.end_end) + solid_angle(d.start_start, d.end_end, d.start_end);
}

/// Of the side that the differences between an end point and a segment sweep over, from the segment's start to its end
/// and from before to now.
double swept(const Corner& start_before, const Corner& end_before, const Corner& start_now, const Corner& end_now) {
  return solid_angle(start_before, end_before, end_now) + solid_angle(start_before, end_now, start_now);
}

}  // namespace

double gauss_integral(const Segment& a, const Segment& b) {
  return solid_angle(differences(a, b)) / kSphere;
}

double gauss_integral(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t j = 0; j + 1 < b.size(); ++j)
      sum += gauss_integral(Segment{a[i], a[i + 1]}, Segment{b[j], b[j + 1]});
  }
  return sum;
}

int passes(const MovedSegment& a, const MovedSegment& b, Vector3 offset) {
  const auto shifted = [&](const Segment& segment) { return Segment{segment.start + offset, segment.end + offset}; };
  const Differences before = differences(a.before, shifted(b.before));
  const Differences now = differences(a.now, shifted(b.now));
  const double at_start_of_a = swept(before.start_start, before.start_end, now.start_start, now.start_end);
  const double at_end_of_a = swept(before.end_start, before.end_end, now.end_start, now.end_end);
  const double at_start_of_b = swept(before.start_start, before.end_start, now.start_start, now.end_start);
  const double at_end_of_b = swept(before.start_end, before.end_end, now.start_end, now.end_end);
  const double surface =
      solid_angle(now) - solid_angle(before) + at_start_of_b + at_end_of_a - at_end_of_b - at_start_of_a;
  return static_cast<int>(std::lround(surface / kSphere));
}

}  // namespace knitmech::contact
