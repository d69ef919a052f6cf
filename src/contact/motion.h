#pragma once

#include <cstddef>
#include <vector>

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

/// How far the yarns have moved beside the common motion since the neighbours were last searched: two points whose
/// elements have moved by p and q are nearer by p + q at most. Lets pairs of yarns that are apart sleep.
class Motion {
 public:
  explicit Motion(std::size_t n_nodes) : of_element_(n_nodes, 0.0) {}

  /// Adds a step. \param moved how far each node's part of the centreline moved in it, one entry per node [mm]
  /// \param besides what the common motion may bring two yarns in contact nearer to each other, half of it [mm]
  void add(const std::vector<double>& moved, double besides);

  /// Forgets the past, when the neighbours are searched anew.
  void start_anew();
  /// Marks that all pairs that might touch have been looked at.
  void looked() { since_look_ = 0; }

  /// Motion of an element since the last search [mm].
  [[nodiscard]] double of(std::size_t element) const { return of_element_[element]; }
  /// Largest of any element since the last search [mm].
  [[nodiscard]] double largest() const { return largest_; }
  /// Bound of the motion of any element since the last look [mm].
  [[nodiscard]] double since_look() const { return since_look_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(of_element_, largest_, since_look_);
  }

 private:
  std::vector<double> of_element_;
  double largest_ = 0, since_look_ = 0;
};

}  // namespace knitmech::contact
