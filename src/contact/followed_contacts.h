#pragma once

#include <vector>

#include "contact/contact_points.h"
#include "contact/overlap.h"

namespace knitmech::contact {

/// Along which parts of two yarns a crossing stands for their overlap.
struct CrossingReach {
  YarnPlace first{}, second{};
  double along_first = 0;   ///< how far the overlap may reach from there [mm]
  double along_second = 0;  ///< the same
  bool counts = false;      ///< else strips count the overlap

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first, second, along_first, along_second, counts);
  }
};

/// A pair of places where two yarns come closest, followed from step to step.
struct Crossing {
  YarnPlace first{}, second{};  ///< first.element < second.element
  double gap = 0;               ///< [mm], when last looked at
  bool is_minimum = true;       ///< when last looked at
  double wake = 0;              ///< motion of both elements since the start before which no force can be here [mm]
  bool is_short = false;        ///< counts; else strips count the overlap
  double first_reach = 0;       ///< how far the overlap may reach along the first yarn from here [mm]
  double second_reach = 0;      ///< along the second
  CrossingReach laid = {};      ///< as the strips around it were laid
  ContactState now = {};

  [[nodiscard]] CrossingReach reach() const { return {first, second, first_reach, second_reach, is_short}; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first, second, gap, is_minimum, wake, is_short, first_reach, second_reach, laid, now);
  }
};

/// All places that are followed.
struct FollowedContacts {
  std::vector<Crossing> crossings;
  std::vector<Overlap> overlaps;  ///< ascending by their pieces
  bool asks_for_look = false;     ///< as an overlap has grown too long for a crossing

  template <class Archive>
  void serialize(Archive& archive) {
    archive(crossings, overlaps, asks_for_look);
  }
};

/// The contacts that carry a force.
[[nodiscard]] std::vector<ContactPoint> contact_points(const FollowedContacts& contacts);

}  // namespace knitmech::contact
