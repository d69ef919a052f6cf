#pragma once

#include <algorithm>
#include <cmath>

#include "base/vector3.h"

namespace knitmech::contact {

/// Where the nodes of two elements were, seen from each other, when the pair was looked at.
///
/// Every place of the line of an element is a weighted mean of its Bezier points: the nodes, and points that lie at a
/// fixed length off them and turn with them. So two places come nearer to each other by no more than two nodes of the
/// elements move against each other, the largest of the four pairs, and both lines turn. Yarns that move together, as
/// those do that bear on each other, are not nearer afterwards however far they went.
struct PairSight {
  Vector3 apart{};              ///< from the start of the first element to that of the second [mm]
  Vector3 first{}, second{};    ///< chords of the elements [mm]
  double turned = 0;            ///< what both lines had moved since the start by the turning of their nodes [mm]
  double length = 0;            ///< by which they might come nearer until the next look [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(apart, first, second, turned, length);
  }
};

/// What is left of the length of a sight, as its elements are now [mm].
[[nodiscard]] inline double left_of(const PairSight& then, const PairSight& now) {
  const Vector3 start_start = now.apart - then.apart;
  const Vector3 first = now.first - then.first;
  const Vector3 second = now.second - then.second;
  double largest = 0;
  for (const Vector3 move : {start_start, start_start - first, start_start + second, start_start + second - first}) {
    largest = std::max(largest, dot(move, move));
  }
  return then.length - std::sqrt(largest) - (now.turned - then.turned);
}

}  // namespace knitmech::contact
