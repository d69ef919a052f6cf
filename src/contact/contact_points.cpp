#include "contact/contact_points.h"

#include "base/segment_distance.h"

namespace knitmech::contact {

void find_contact_points(const ContactElements& elements, const std::vector<ElementPair>& pairs,
                         const model::VectorArray& position, std::vector<ContactPoint>& found) {
  found.clear();
  for (const ElementPair pair : pairs) {
    const auto i = static_cast<std::size_t>(pair.first);
    const auto j = static_cast<std::size_t>(pair.second);
    const Vector3 start_first = position.at(i);
    const Vector3 start_second = position.at(j);
    const Vector3 along_first = position.at(i + 1) - start_first;
    const Vector3 along_second = position.at(j + 1) - start_second;
    const ClosestPoints at = closest_points(start_first, along_first, start_second, along_second);
    const Vector3 between = start_second + at.t * along_second - start_first - at.s * along_first;
    const double radii = elements.radius[i] + elements.radius[j];
    const double squared = dot(between, between);
    if (squared >= radii * radii) continue;
    const double distance = std::sqrt(squared);
    found.push_back({contact_key(pair.first, pair.second), pair.first, pair.second, at.s, at.t,
                     (1 / distance) * between, radii - distance, radii, elements.stiffness});
  }
}

}  // namespace knitmech::contact
