#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/centreline.h"
#include "contact/yarn_elements.h"

namespace knitmech::contact {

/// Springs between places of yarns, as far as it matters for the highest frequency that they give the nodes: the sizes
/// of the entries of their stiffness, |K|. A place is made up of the displacements and the rotations of two nodes; of a
/// rotation counts the length of its arm.
class Springs {
 public:
  /// One end of a spring.
  struct End {
    YarnPlace place;
    Hold hold{};
  };

  /// Adds a spring of a stiffness [N/mm].
  void add(const End& first, const End& second, double stiffness) {
    springs_.push_back({stiffness, static_cast<std::size_t>(first.place.element),
                        static_cast<std::size_t>(second.place.element), sizes(first.hold), sizes(second.hold)});
  }

  /// image = |K| d.
  /// \param d of all displacements, then of all rotations; as many as nodes each   \param image as long, replaced
  void multiply(const std::vector<double>& d, std::vector<double>& image) const {
    const std::size_t n = d.size() / 2;
    image.assign(d.size(), 0.0);
    for (const Spring& spring : springs_) {
      const double force = spring.stiffness * (stretch(spring.on_first, &d[spring.first], n) +
                                               stretch(spring.on_second, &d[spring.second], n));
      add_force(spring.on_first, force, &image[spring.first], n);
      add_force(spring.on_second, force, &image[spring.second], n);
    }
  }

 private:
  /// How far the place of an end moves with the displacement of the node before and of the node after it, and with
  /// their rotations.
  using Sizes = std::array<double, 4>;
  struct Spring {
    double stiffness;
    std::size_t first, second;  ///< elements
    Sizes on_first, on_second;
  };

  static Sizes sizes(const Hold& hold) {
    return {std::abs(hold.start), std::abs(hold.end), length(hold.start_arm), length(hold.end_arm)};
  }
  static double stretch(const Sizes& by, const double* d, std::size_t n) {
    return by[0] * d[0] + by[1] * d[1] + by[2] * d[n] + by[3] * d[n + 1];
  }
  static void add_force(const Sizes& by, double force, double* image, std::size_t n) {
    image[0] += by[0] * force;
    image[1] += by[1] * force;
    image[n] += by[2] * force;
    image[n + 1] += by[3] * force;
  }

  std::vector<Spring> springs_;
};

}  // namespace knitmech::contact
