#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace knitmech::bench {

/// Force of the grips over strain, as what every scheme can tell: means over intervals of strain that follow each
/// other.
class ForceCurve {
 public:
  explicit ForceCurve(double gauge_length) : gauge_length_(gauge_length) {}

  /// Adds the interval up to a strain [-], with the mean of the forces of both grips in it [N].
  void add(double strain, double mean_force) {
    const double way = (strain - strains_.back()) * gauge_length_;
    works_.push_back(works_.back() + mean_force * way);
    strains_.push_back(strain);
  }

  [[nodiscard]] double end() const { return strains_.back(); }

  /// Work of the pull up to a strain [mJ], linear within an interval.
  [[nodiscard]] double work(double strain) const {
    const auto above = std::ranges::lower_bound(strains_, strain) - strains_.begin();
    if (above == 0) return 0;
    const auto k = std::min(static_cast<std::size_t>(above), strains_.size() - 1);
    const double share = (strain - strains_[k - 1]) / (strains_[k] - strains_[k - 1]);
    return works_[k - 1] + std::min(share, 1.0) * (works_[k] - works_[k - 1]);
  }

  /// Mean force between two strains [N].
  [[nodiscard]] double mean_force(double from, double to) const {
    return (work(to) - work(from)) / ((to - from) * gauge_length_);
  }

 private:
  double gauge_length_;                            ///< [mm]
  std::vector<double> strains_{0.0}, works_{0.0};  ///< ends of the intervals [-], work up to there [mJ]
};

}  // namespace knitmech::bench
