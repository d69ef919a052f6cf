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

/// The first memory of a pair of pieces, whatever its sample.
const SlipMemory* find_pair(const std::vector<SlipMemory>& memories, std::int32_t first, std::int32_t second) {
  const std::uint64_t start = contact_key(first, second);
  const auto at = std::lower_bound(memories.begin(), memories.end(), start,
                                   [](const SlipMemory& entry, std::uint64_t wanted) { return entry.key < wanted; });
  return at != memories.end() && at->key < contact_key(first, second + 1) ? &*at : nullptr;
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
  const auto pressed_alike = [&](const SlipMemory* memory) {
    return memory != nullptr && dot(memory->normal, point.normal) >= kSameDirection;
  };
  const unsigned own = sample_of(point.key);
  const SlipMemory* of_pair = nullptr;
  for (const int step_first : {0, -1, 1}) {
    for (const int step_second : {0, -1, 1}) {
      const std::int32_t first = point.first + step_first;
      const std::int32_t second = point.second + step_second;
      if (first < 0 || second < 0) continue;
      const SlipMemory* same = find(memories, contact_key(first, second, own));
      if (pressed_alike(same) && find(points, same->key) == nullptr) return same;
      const SlipMemory* any = find_pair(memories, first, second);
      if (of_pair == nullptr && pressed_alike(any)) of_pair = any;
    }
  }
  return of_pair;
}

}  // namespace knitmech::contact
