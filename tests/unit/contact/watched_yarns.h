#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "../../support/beam_case.h"
#include "contact/crossing_watch.h"
#include "contact/neighbour_search.h"

namespace knitmech::contact {

/// Diameter of the yarns of these tests [mm].
inline constexpr double kDiameter = 0.12;

inline Eigen::Vector3d in_diameters(double x, double y, double z) {
  return {kDiameter * x, kDiameter * y, kDiameter * z};
}

/// Moves a point that lies on a yarn, in its shape at the start.
using Motion = std::function<Eigen::Vector3d(std::size_t yarn, const Eigen::Vector3d&)>;

/// Yarns whose chords are moved by hand under a watch.
class WatchedYarns {
 public:
  explicit WatchedYarns(const std::vector<std::vector<Eigen::Vector3d>>& yarns)
      : model_(chords_through(yarns)),
        elements_(make_contact_elements(model_)),
        watch_(std::make_shared<const ContactElements>(elements_)) {
    position_ = test::state_of(model_).position;
    all_ = look();
  }

  /// Moves all nodes to where a motion puts their places at the start, and looks.
  CrossingReport move(const Motion& motion) {
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      const Eigen::Vector3d to = motion(static_cast<std::size_t>(elements_.yarn[i]), model_.nodes[i]);
      position_.set(i, {to.x(), to.y(), to.z()});
    }
    return look();
  }

  /// The same along a way, motion(share) for shares from 0 to 1 in even steps. \return all that happened on it
  CrossingReport move_along(const std::function<Motion(double)>& motion, int n_steps) {
    CrossingReport sum;
    for (int i = 1; i <= n_steps; ++i) {
      const CrossingReport report = move(motion(static_cast<double>(i) / n_steps));
      sum.lost.insert(sum.lost.end(), report.lost.begin(), report.lost.end());
      sum.ravelled.insert(sum.ravelled.end(), report.ravelled.begin(), report.ravelled.end());
    }
    return sum;
  }

  [[nodiscard]] const ContactElements& elements() const { return elements_; }
  [[nodiscard]] const model::VectorArray& position() const { return position_; }
  [[nodiscard]] const CrossingReport& at_the_start() const { return all_; }

 private:
  static model::Model chords_through(const std::vector<std::vector<Eigen::Vector3d>>& yarns) {
    model::Model model = test::yarns_through(yarns, test::section(19, 6, 0.017, 0.012, 1e-11, kDiameter));
    model.centreline = model::Centreline::chords;
    return model;
  }

  CrossingReport look() {
    const std::vector<double> no_bulge(elements_.n_nodes(), 0.0);
    const auto pairs = find_neighbours(elements_, position_, no_bulge, 0.4 * kDiameter);
    return watch_.update(position_, pairs, 1.4 * kDiameter);
  }

  model::Model model_;
  ContactElements elements_;
  CrossingWatch watch_;
  model::VectorArray position_;
  CrossingReport all_;
};

/// Shifts one yarn and leaves the others where they are.
inline Motion shift_yarn(std::size_t yarn, const Eigen::Vector3d& by) {
  return [=](std::size_t y, const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return y == yarn ? Eigen::Vector3d(x + by) : x;
  };
}

/// A way in a straight line, from the start.
inline std::function<Motion(double)> shift_along(std::size_t yarn, const Eigen::Vector3d& by) {
  return [=](double share) { return shift_yarn(yarn, share * by); };
}

/// n + 1 points of a curve at even parameters in [from, to].
inline std::vector<Eigen::Vector3d> drawn(const std::function<Eigen::Vector3d(double)>& curve, double from, double to,
                                          int n) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= n; ++i) points.push_back(curve(from + (to - from) * i / n));
  return points;
}

}  // namespace knitmech::contact
