#pragma once

#include <vector>

#include "contact/contact_points.h"
#include "contact/friction.h"
#include "contact/yarn_elements.h"

namespace knitmech::contact {

/// What a followed contact did in the last step; no load where it did nothing.
struct ContactState {
  double penetration = 0;      ///< [mm]
  double load = 0;             ///< normal force [N]
  double tangent = 0;          ///< its derivative by the penetration [N/mm]
  double energy = 0;           ///< stored in the normal law [mJ]
  double stick_stiffness = 0;  ///< [N/mm]
  SlipMemory stick = {};
};

/// A pair of places where two yarns come closest, followed from step to step.
struct Crossing {
  YarnPlace first{}, second{};  ///< first.element < second.element
  double gap = 0;               ///< [mm], when last looked at
  bool is_minimum = true;       ///< when last looked at
  double wake = 0;          ///< motion of both elements since the last search before which no force can be here [mm]
  bool is_short = false;    ///< counts; else samples count the overlap
  double first_reach = 0;   ///< how far the overlap may reach along the first yarn from here [mm]
  double second_reach = 0;  ///< along the second
  ContactState now = {};
};

/// A short length of a yarn in a long overlap, with the nearest place on the other yarn, followed from step to step.
struct Sample {
  YarnPlace at{};          ///< middle of the sampled length; stays
  YarnPlace other{};       ///< nearest place
  double length = 0;       ///< stress-free, of the sample [mm]
  bool on_second = false;  ///< the sampled yarn is the second of the contact: its element has the larger number
  double gap = 0;          ///< [mm], when last looked at
  bool is_minimum = true;  ///< when last looked at
  double share = 1;        ///< of the overlap that this sample stands for [-]; see overlap_shares.h
  double wake = 0;         ///< motion of both elements since the last search before which no force can be here [mm]
  ContactState now = {};
};

/// All places that are followed.
struct FollowedContacts {
  std::vector<Crossing> crossings;
  std::vector<Sample> samples;
};

/// The contacts that carry a force.
[[nodiscard]] std::vector<ContactPoint> contact_points(const FollowedContacts& contacts);

}  // namespace knitmech::contact
