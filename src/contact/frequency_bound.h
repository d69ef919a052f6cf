#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/centreline.h"
#include "contact/yarn_elements.h"

namespace knitmech::contact {

/// Upper bound of the square of the highest frequency that springs between places of yarns give the nodes [1/s^2]: the
/// largest row sum of their stiffness, scaled with the inertia of the nodes (Gershgorin).
class FrequencyBound {
 public:
  /// \param mass, rotary of the nodes [t], [t mm^2]; must live on
  FrequencyBound(const std::vector<double>& mass, const std::vector<double>& rotary)
      : mass_(mass), rotary_(rotary), row_(2 * mass.size(), 0.0) {}

  /// One end of a spring.
  struct End {
    YarnPlace place;
    Hold hold{};
  };

  /// Adds a spring of a stiffness [N/mm].
  void add(const End& first, const End& second, double stiffness) {
    filled_ = 0;
    sum_ = 0;
    gather(first);
    gather(second);
    for (std::size_t k = 0; k < filled_; ++k) {
      row_[entries_[k].at] += stiffness * entries_[k].size * sum_;
      highest_ = std::max(highest_, row_[entries_[k].at]);
    }
  }

  [[nodiscard]] double highest() const { return highest_; }
  /// The sums of all rows [1/s^2], those of the displacements before those of the rotations.
  [[nodiscard]] const std::vector<double>& rows() const { return row_; }

 private:
  struct Entry {
    std::size_t at;
    double size;  // share of the place that this displacement or rotation makes up, over the root of its inertia
  };

  void gather(const End& end) {
    const auto i = static_cast<std::size_t>(end.place.element);
    const std::size_t n = mass_.size();
    gather(i, end.hold.start, mass_[i]);
    gather(i + 1, end.hold.end, mass_[i + 1]);
    gather(n + i, length(end.hold.start_arm), rotary_[i]);
    gather(n + i + 1, length(end.hold.end_arm), rotary_[i + 1]);
  }
  void gather(std::size_t at, double weight, double inertia) {
    entries_[filled_] = {at, std::abs(weight) / std::sqrt(inertia)};
    sum_ += entries_[filled_++].size;
  }

  const std::vector<double>& mass_;
  const std::vector<double>& rotary_;
  std::vector<double> row_;  // of the displacements, then of the rotations
  std::array<Entry, 8> entries_{};
  std::size_t filled_ = 0;
  double sum_ = 0, highest_ = 0;
};

}  // namespace knitmech::contact
