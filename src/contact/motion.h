#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/thread_team.h"
#include "model/state.h"

namespace knitmech::contact {

/// A motion along y that all yarns share, as far as it goes: velocity = start + rate * y. A fabric that is stretched
/// moves like this as a whole; only what a yarn moves beyond it can bring it nearer to another.
struct CommonMotion {
  double start = 0;  ///< [mm/s]
  double rate = 0;   ///< [1/s]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(start, rate);
  }
};

/// The common motion that fits the velocities best (least squares).
[[nodiscard]] CommonMotion fit_common_motion(const model::State& state);

/// How far the yarns have moved beside the common motion since the start, along their paths: two points whose elements
/// have moved by p and q meanwhile are nearer by p + q at most. Lets pairs of yarns that are apart sleep.
///
/// Each element has a bound, up to which nothing has to be done about it.
class Motion {
 public:
  explicit Motion(std::size_t n_nodes)
      : of_element_(n_nodes, 0.0),
        turned_(n_nodes, 0.0),
        searched_(n_nodes, -1e300),
        checked_(n_nodes, 0.0),
        bound_(n_nodes, 0.0) {}

  /// Adds a step. \param moved how far each node's part of the centreline moved in it, one entry per node [mm]
  /// \param turned what of it is because the node turned [mm]
  /// \param besides what the common motion may bring two yarns in contact nearer to each other, half of it [mm]
  void add(const std::vector<double>& moved, const std::vector<double>& turned, double besides,
           const base::ThreadTeam& team = base::ThreadTeam(1));

  /// One less than there are nodes: in between may be some that do not exist, of which the motion means nothing.
  [[nodiscard]] std::size_t n_elements() const { return of_element_.size() - 1; }
  /// Motion of an element since the start [mm].
  [[nodiscard]] double of(std::size_t element) const { return of_element_[element]; }
  /// The part of it that is because its nodes turned [mm].
  [[nodiscard]] double turned(std::size_t element) const { return turned_[element]; }
  /// Since its neighbours were last searched [mm].
  [[nodiscard]] double since_search(std::size_t element) const { return of_element_[element] - searched_[element]; }
  [[nodiscard]] double largest_since_search() const;
  /// Largest of any element since the crossings were last checked [mm].
  [[nodiscard]] double largest_since_check() const;

  /// Notes that the neighbours of an element have been searched, that all crossings have been checked.
  void searched(std::size_t element) { searched_[element] = of_element_[element]; }
  void checked() { checked_ = of_element_; }

  /// What every element may move since its search and since the check [mm].
  void set_limits(double since_search, double since_check) {
    since_search_ = since_search;
    since_check_ = since_check;
  }
  /// Leaves an element no bound but these.
  void unbind(std::size_t element) {
    bound_[element] = std::min(searched_[element] + since_search_, checked_[element] + since_check_);
  }
  /// Bounds two elements so that one of them reaches its bound before both together have moved by `more` from now on.
  void bound(std::size_t first, std::size_t second, double more) {
    bound_[first] = std::min(bound_[first], of_element_[first] + 0.5 * more);
    bound_[second] = std::min(bound_[second], of_element_[second] + 0.5 * more);
  }
  /// Whether an element has no more than a length left up to its bound [mm].
  [[nodiscard]] bool is_within(double length, std::size_t element) const {
    return of_element_[element] + length >= bound_[element];
  }
  /// Whether any element had reached its bound in the last step.
  [[nodiscard]] bool has_reached_a_bound() const { return has_reached_a_bound_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(of_element_, turned_, searched_, checked_, bound_, since_search_, since_check_, has_reached_a_bound_);
  }

 private:
  std::vector<double> of_element_, turned_, searched_, checked_, bound_;
  double since_search_ = 1e300, since_check_ = 1e300;
  bool has_reached_a_bound_ = false;
};

}  // namespace knitmech::contact
