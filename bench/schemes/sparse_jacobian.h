#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "contact/contact_points.h"
#include "model/model.h"
#include "model/state.h"

namespace knitmech::bench {

/// The unknowns of a fabric at rest: 6 per node, displacements and rotations in space axes; -1 where a grip holds.
class Unknowns {
 public:
  explicit Unknowns(const model::Model& model);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] int of(std::size_t node, std::size_t component) const { return index_[6 * node + component]; }
  [[nodiscard]] std::size_t n_nodes() const { return index_.size() / 6; }
  /// Loads in the order of the unknowns [N], [N mm].
  [[nodiscard]] Eigen::VectorXd gather(const model::NodalLoads& loads) const;
  /// Moves a state: displacements [mm], and rotation vectors [rad] upon the rotations there are.
  void move(const Eigen::VectorXd& by, model::State& state) const;

 private:
  std::vector<int> index_;
  int size_ = 0;
};

/// Nodes whose loads depend on each other's motion, per node and ascending, itself among them: neighbours along the
/// yarn, and all nodes about a contact.
[[nodiscard]] std::vector<std::vector<int>> coupled_nodes(const model::Model& model,
                                                          const std::vector<contact::ContactPoint>& contacts);

/// The derivatives of loads by the unknowns, by difference quotients of several nodes at a time, no two of which act on
/// the same node (Curtis, Powell, Reid 1974).
/// \param loads of moved unknowns, in their order: the argument is what they are moved by
[[nodiscard]] Eigen::SparseMatrix<double> jacobian(
    const Unknowns& unknowns, const std::vector<std::vector<int>>& coupled,
    const std::function<Eigen::VectorXd(const Eigen::VectorXd& by)>& loads);

}  // namespace knitmech::bench
