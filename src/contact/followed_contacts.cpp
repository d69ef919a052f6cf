#include "contact/followed_contacts.h"

namespace knitmech::contact {

namespace {

void add(const ContactState& now, YarnPlace first, YarnPlace second, const SlipMemory& stick,
         std::vector<ContactPoint>& points) {
  if (now.load <= 0) return;
  points.push_back(
      {first, second, stick.normal, now.penetration, now.load, now.tangent, now.energy, now.stick_stiffness, stick});
}

}  // namespace

std::vector<ContactPoint> contact_points(const FollowedContacts& contacts) {
  std::vector<ContactPoint> points;
  for (const Crossing& crossing : contacts.crossings) {
    add(crossing.now, crossing.first, crossing.second, crossing.now.stick, points);
  }
  for (const Overlap& overlap : contacts.overlaps) {
    for (const Strip& strip : overlap.laid) {
      if (strip.at.element < strip.other.element) {
        add(strip.now, strip.at, strip.other, strip.now.stick, points);
      } else {
        add(strip.now, strip.other, strip.at, flipped(strip.now.stick), points);
      }
    }
  }
  return points;
}

}  // namespace knitmech::contact
