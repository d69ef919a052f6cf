#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/yarn_elements.h"

namespace knitmech::contact {

/// Numbers of what lies on each element.
class ByElement {
 public:
  explicit ByElement(std::size_t n_elements) : first_(n_elements, -1) {}
  void add(std::int32_t element) {
    next_.push_back(first_[static_cast<std::size_t>(element)]);
    first_[static_cast<std::size_t>(element)] = static_cast<std::int32_t>(next_.size()) - 1;
  }
  /// Calls for every number on the elements around one.
  template <typename Call>
  void around(std::int32_t element, std::int32_t each_side, const Call& call) const {
    const std::int32_t last = std::min(element + each_side, static_cast<std::int32_t>(first_.size()) - 1);
    for (std::int32_t e = std::max(element - each_side, 0); e <= last; ++e) {
      for (std::int32_t i = first_[static_cast<std::size_t>(e)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
        call(static_cast<std::size_t>(i));
      }
    }
  }

 private:
  std::vector<std::int32_t> first_, next_;
};

/// Distances and neighbourhoods along the yarns.
struct AlongYarns {
  const YarnElements& elements;

  explicit AlongYarns(const YarnElements& of) : elements(of) {}
  [[nodiscard]] double radii(YarnPlace a, YarnPlace b) const {
    return elements.radius[static_cast<std::size_t>(a.element)] + elements.radius[static_cast<std::size_t>(b.element)];
  }
  [[nodiscard]] bool near(YarnPlace a, YarnPlace b, double reach) const {
    return elements.yarn[static_cast<std::size_t>(a.element)] == elements.yarn[static_cast<std::size_t>(b.element)] &&
           distance(a, b) < reach;
  }
  /// Of two places on one yarn.
  [[nodiscard]] double distance(YarnPlace a, YarnPlace b) const {
    return std::abs(arc_of(elements, a) - arc_of(elements, b));
  }
  /// How many elements to look at on each side for what is within reach.
  [[nodiscard]] std::int32_t elements_within(double reach) const {
    return static_cast<std::int32_t>(std::min(reach / elements.shortest, 1e6)) + 1;
  }
};

}  // namespace knitmech::contact
