#pragma once

#include <algorithm>
#include <cmath>

#include "base/vector3.h"
#include "contact/motion.h"
#include "model/state.h"

namespace knitmech::contact {

/// Where the nodes of two elements were, seen from each other, when the pair was looked at.
///
/// Every place of the line of an element is a weighted mean of its Bezier points: the nodes, and points that lie at a
/// fixed length off them and turn with them. So two places come nearer to each other by no more than two nodes of the
/// elements move against each other, the largest of the four pairs, and both lines turn. Yarns that move together, as
/// those do that bear on each other, are not nearer afterwards however far they went.
struct PairSight {
  Vector3 apart{};            ///< from the start of the first element to that of the second [mm]
  Vector3 first{}, second{};  ///< chords of the elements [mm]
  double turned = 0;          ///< what both lines had moved since the start by the turning of their nodes [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(apart, first, second, turned);
  }
};

/// How much nearer any two places of the elements may have come [mm].
[[nodiscard]] inline double motion_between(const PairSight& then, const PairSight& now) {
  const Vector3 start_start = now.apart - then.apart;
  const Vector3 first = now.first - then.first;
  const Vector3 second = now.second - then.second;
  double largest = 0;
  for (const Vector3 move : {start_start, start_start - first, start_start + second, start_start + second - first}) {
    largest = std::max(largest, dot(move, move));
  }
  return std::sqrt(largest) + now.turned - then.turned;
}

/// Two elements as they are now.
[[nodiscard]] inline PairSight sight_of(const model::VectorArray& node_position, const Motion& motion,
                                        std::size_t first, std::size_t second) {
  const Vector3 a = node_position.at(first);
  const Vector3 b = node_position.at(second);
  return {b - a, node_position.at(first + 1) - a, node_position.at(second + 1) - b,
          motion.turned(first) + motion.turned(second)};
}

}  // namespace knitmech::contact
