#pragma once

namespace knitmech::solve {

/// The forces of the grips at a row of the history, freed of fast vibration: over all steps since the row before, the
/// straight line through force against displacement that is nearest to them (least squares, each step with the weight
/// of its length), read at the row's displacement.
///
/// Their mean would be the force of the middle of the interval, and so half a row late: on a rising curve too small, by
/// a third where the curve begins and rows are far apart. The line is exact for a force that is linear in the
/// displacement.
class ForceWindow {
 public:
  struct Forces {
    double top = 0, bottom = 0;  ///< [N]
  };

  /// \param displacement of the grip [mm] \param h length of the step [s]
  void add(double displacement, Forces forces, double h) {
    if (weight_ == 0) begin_ = displacement;
    const double x = displacement - begin_;
    weight_ += h;
    x_ += h * x;
    xx_ += h * x * x;
    top_.add(forces.top, x, h);
    bottom_.add(forces.bottom, x, h);
  }

  [[nodiscard]] bool empty() const { return weight_ == 0; }

  /// The forces at a displacement; their mean where the grip has not moved. Only if not empty.
  [[nodiscard]] Forces at(double displacement) const {
    const double mean_x = x_ / weight_;
    const double variance = xx_ / weight_ - mean_x * mean_x;
    const double lever = variance > kLeastVariance * xx_ / weight_ ? (displacement - begin_ - mean_x) / variance : 0;
    return {top_.at(lever, mean_x, weight_), bottom_.at(lever, mean_x, weight_)};
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(weight_, begin_, x_, xx_, top_, bottom_);
  }

 private:
  /// Share of the mean square below which the variance is rounding.
  static constexpr double kLeastVariance = 1e-9;

  struct Sums {
    double force = 0, force_x = 0;  ///< [N s], [N mm s]

    void add(double each, double x, double h) {
      force += h * each;
      force_x += h * each * x;
    }
    [[nodiscard]] double at(double lever, double mean_x, double weight) const {
      return (force + (force_x - mean_x * force) * lever) / weight;
    }
    template <class Archive>
    void serialize(Archive& archive) {
      archive(force, force_x);
    }
  };

  double weight_ = 0;      ///< [s]
  double begin_ = 0;       ///< displacement of the first step [mm]
  double x_ = 0, xx_ = 0;  ///< of the displacement since then [mm s], [mm^2 s]
  Sums top_, bottom_;
};

}  // namespace knitmech::solve
