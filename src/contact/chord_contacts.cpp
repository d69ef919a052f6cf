#include "base/segment_distance.h"
#include "contact/contact_points.h"
#include "contact/normal_law.h"

namespace knitmech::contact {

void find_chord_contacts(const ContactElements& elements, const std::vector<ElementPair>& pairs,
                         const model::VectorArray& position, PairClock& clock, std::vector<ContactPoint>& found) {
  found.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (clock.may_sleep(p)) continue;
    const ElementPair pair = pairs[p];
    const auto i = static_cast<std::size_t>(pair.first);
    const auto j = static_cast<std::size_t>(pair.second);
    const Vector3 start_first = position.at(i);
    const Vector3 start_second = position.at(j);
    const Vector3 along_first = position.at(i + 1) - start_first;
    const Vector3 along_second = position.at(j + 1) - start_second;
    const ClosestPoints at = closest_points(start_first, along_first, start_second, along_second);
    const Vector3 between = start_second + at.t * along_second - start_first - at.s * along_first;
    const double radii = elements.radius[i] + elements.radius[j];
    const double distance = length(between);
    if (distance >= radii) {
      clock.sleep(p, distance - radii);
      continue;
    }
    const double penetration = radii - distance;
    found.push_back({contact_key(pair.first, pair.second), pair.first, pair.second, at.s, at.t,
                     (1 / distance) * between, penetration, elements.stiffness * normal_force(penetration, radii),
                     elements.stiffness * normal_tangent(penetration, radii),
                     elements.stiffness * normal_energy(penetration, radii)});
  }
}

}  // namespace knitmech::contact
