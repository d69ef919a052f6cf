#include "contact/friction.h"

#include <algorithm>

#include "contact/constants.h"

namespace knitmech::contact {

namespace {

Vector3 turned_into_plane(Vector3 slip, Vector3 normal) {
  const Vector3 flat = slip - dot(slip, normal) * normal;
  const double flat_length = length(flat);
  return flat_length > 0 ? (length(slip) / flat_length) * flat : flat;
}

template <typename Entry>
const Entry* find(const std::vector<Entry>& entries, std::uint64_t key) {
  const auto at = std::lower_bound(entries.begin(), entries.end(), key,
                                   [](const Entry& entry, std::uint64_t wanted) { return entry.key < wanted; });
  return at != entries.end() && at->key == key ? &*at : nullptr;
}

}  // namespace

FrictionStep friction_step(const ContactPoint& point, const SlipMemory* before, Vector3 motion, double limit) {
  FrictionStep step;
  const double stiffness = kStickStiffness * point.tangent;
  Vector3 slip = motion - dot(motion, point.normal) * point.normal;
  if (before != nullptr) slip = slip + turned_into_plane(before->elastic_slip, point.normal);

  const double trial = stiffness * length(slip);
  if (trial > limit) {
    const double kept = limit / trial;
    step.loss = limit * (1 - kept) * length(slip);
    slip = kept * slip;
    step.slips = true;
  }
  step.force = -stiffness * slip;
  step.memory = {point.key, point.normal, slip, stiffness};
  return step;
}

const SlipMemory* recall(const std::vector<SlipMemory>& memories, const ContactPoint& point) {
  return find(memories, point.key);
}

const SlipMemory* recall_moved(const std::vector<SlipMemory>& memories, const std::vector<ContactPoint>& points,
                               const ContactPoint& point) {
  const unsigned own = sample_of(point.key);
  const auto take = [&](std::int32_t first, std::int32_t second, unsigned sample) -> const SlipMemory* {
    const SlipMemory* moved = find(memories, contact_key(first, second, sample));
    if (moved == nullptr || dot(moved->normal, point.normal) < kSameDirection) return nullptr;
    return find(points, moved->key) == nullptr ? moved : nullptr;
  };
  for (const int step_first : {0, -1, 1}) {
    for (const int step_second : {0, -1, 1}) {
      const std::int32_t first = point.first + step_first;
      const std::int32_t second = point.second + step_second;
      if (first < 0 || second < 0) continue;
      if (const SlipMemory* same = take(first, second, own)) return same;
      if (own >= kFirstSample) continue;
      for (const unsigned other : {kWholeCrossing, kFirstHalf, kSecondHalf}) {
        if (const SlipMemory* moved = take(first, second, other)) return moved;
      }
    }
  }
  return nullptr;
}

}  // namespace knitmech::contact
