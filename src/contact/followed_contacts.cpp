#include "contact/followed_contacts.h"

namespace knitmech::contact {

namespace {

void add(const ContactState& now, YarnPlace first, YarnPlace second, std::vector<ContactPoint>& points) {
  if (now.load <= 0) return;
  points.push_back({first, second, now.stick.normal, now.penetration, now.load, now.tangent, now.energy,
                    now.stick_stiffness, now.stick});
}

}  // namespace

std::vector<ContactPoint> contact_points(const FollowedContacts& contacts) {
  std::vector<ContactPoint> points;
  for (const Crossing& crossing : contacts.crossings) add(crossing.now, crossing.first, crossing.second, points);
  for (const Sample& sample : contacts.samples) {
    add(sample.now, sample.on_second ? sample.other : sample.at, sample.on_second ? sample.at : sample.other, points);
  }
  return points;
}

}  // namespace knitmech::contact
