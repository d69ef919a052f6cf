#include "schemes/newton.h"

#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "beam/nodal_inertia.h"
#include "bench_fabric.h"
#include "schemes/constants.h"
#include "schemes/sparse_jacobian.h"
#include "schemes/static_fabric.h"

namespace knitmech::bench {

namespace {

/// Rotation vector from one rotation to another [rad].
Vector3 turn_between(const model::RotationArray& from, const model::RotationArray& to, std::size_t i) {
  const Vector3 p{from.x[i], from.y[i], from.z[i]};
  const Vector3 q{to.x[i], to.y[i], to.z[i]};
  const double w = to.w[i] * from.w[i] + dot(q, p);
  const Vector3 v = from.w[i] * q - to.w[i] * p - cross(q, p);
  const double sine = length(v);
  if (sine == 0) return {0, 0, 0};
  const double sign = w < 0 ? -1 : 1;
  return (sign * 2 * std::atan2(sine, std::abs(w)) / sine) * v;
}

/// Sets the velocities of a state to its motion since another one within a second.
void set_motion_since(const model::State& before, model::State& state) {
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    state.velocity.set(i, state.position.at(i) - before.position.at(i));
    state.angular_velocity.set(i, turn_between(before.rotation, state.rotation, i));
  }
}

/// A place of the fabric, and what it bears there.
struct Trial {
  model::State state;
  contact::YarnContact contact;
  model::NodalLoads loads;
};

class Solving {
 public:
  Solving(const model::Model& model, const Newton& scheme)
      : scheme_(scheme),
        fabric_(model),
        unknowns_(model),
        rest_{state_of(model), contact::YarnContact(model), model::NodalLoads(model.nodes.size())} {
    const beam::NodalInertia inertia = beam::lump_inertia(fabric_.elements(), 1);
    model::NodalLoads masses(model.nodes.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      masses.force.set(i, inertia.mass[i] * Vector3{1, 1, 1});
      masses.moment.set(i, inertia.rotary[i] * Vector3{1, 1, 1});
    }
    mass_ = unknowns_.gather(masses);
    stable_step_ = 2 / std::sqrt(inertia.highest_frequency_squared);
  }

  /// \return false if the fabric was not brought to rest; it is then where it was
  bool advance(double displacement, const Clock& clock) {
    model::State state = rest_.state;
    fabric_.stretch(displacement, 1, state);
    Trial trial = evaluated(std::move(state));
    double pseudo_time = kFirstPseudoTime * stable_step_;
    for (iterations_ = 0; iterations_ < kMostIterations && clock.seconds() < scheme_.budget; ++iterations_) {
      if (fabric_.is_at_rest(trial.loads, scheme_.tolerance)) {
        rest_ = std::move(trial);
        return !rest_.contact.lost_crossing();
      }
      std::optional<Trial> next = iterate(trial, pseudo_time);
      if (!next) return false;
      const double fall = fabric_.residual(trial.loads) / fabric_.residual(next->loads);
      pseudo_time *= std::clamp(kEasyGrowth * fall, 1.0, kPseudoTimeGrowth);
      pseudo_time = std::min(pseudo_time, kMostPseudoTime * stable_step_);
      trial = std::move(*next);
    }
    return false;
  }

  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] long jacobians() const { return jacobians_; }
  [[nodiscard]] long evaluations() const { return fabric_.evaluations(); }
  [[nodiscard]] double grip_force() const { return fabric_.grip_force(rest_.loads); }

 private:
  Trial evaluated(model::State state) {
    set_motion_since(rest_.state, state);
    Trial trial{std::move(state), rest_.contact, rest_.loads};
    fabric_.set_loads(trial.state, 1, trial.contact, trial.loads);
    return trial;
  }

  Trial moved(const Trial& from, const Eigen::VectorXd& by) {
    model::State state = from.state;
    unknowns_.move(by, state);
    return evaluated(std::move(state));
  }

  /// One iteration; nothing if the residual grows however small the pseudo time is, which is cut on the way.
  std::optional<Trial> iterate(const Trial& trial, double& pseudo_time) {
    const auto coupled = coupled_nodes(fabric_.model(), trial.contact.points());
    const Eigen::SparseMatrix<double> slopes = jacobian(
        unknowns_, coupled, [&](const Eigen::VectorXd& by) { return unknowns_.gather(moved(trial, by).loads); });
    ++jacobians_;
    const double residual = fabric_.residual(trial.loads);
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
    solver.analyzePattern(slopes);
    for (; pseudo_time > kLeastPseudoTime * stable_step_; pseudo_time *= kPseudoTimeCut) {
      Eigen::SparseMatrix<double> matrix = -slopes;
      matrix.diagonal() += mass_ / (pseudo_time * pseudo_time);
      solver.factorize(matrix);
      if (solver.info() != Eigen::Success) continue;
      Trial next = moved(trial, limited(solver.solve(unknowns_.gather(trial.loads))));
      if (fabric_.residual(next.loads) < kResidualGrowth * residual) return next;
    }
    return std::nullopt;
  }

  [[nodiscard]] Eigen::VectorXd limited(const Eigen::VectorXd& by) const {
    double largest = 0;
    for (std::size_t node = 0; node < unknowns_.n_nodes(); ++node) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (unknowns_.of(node, k) >= 0) largest = std::max(largest, std::abs(by[unknowns_.of(node, k)]));
      }
    }
    return std::min(1.0, kLargestIteration * fabric_.smallest_radius() / largest) * by;
  }

  const Newton& scheme_;
  StaticFabric fabric_;
  Unknowns unknowns_;
  Eigen::VectorXd mass_;
  double stable_step_ = 0;  ///< [s], of explicit dynamics with the same masses
  Trial rest_;              ///< last
  int iterations_ = 0;      ///< of the last increment
  long jacobians_ = 0;
};

}  // namespace

SchemeResult run_newton(const model::Model& model, const Newton& scheme) {
  const Clock clock;
  Solving solving(model, scheme);
  SchemeResult result{.name = scheme.name, .curve = ForceCurve(model.test.gauge_length), .note = {}};
  double strain = 0;
  double increment = scheme.increment;
  double force_before = 0;
  int cuts = 0;
  while (strain < model.test.strain * (1 - 1e-12)) {
    const double next = std::min(increment, model.test.strain - strain);
    if (solving.advance(next * model.test.gauge_length, clock)) {
      strain += next;
      const double force = solving.grip_force();
      result.curve.add(strain, 0.5 * (force_before + force));
      force_before = force;
      if (solving.iterations() <= kFewIterations) increment = std::min(kIncrementGrowth * increment, scheme.increment);
    } else {
      if (clock.seconds() > scheme.budget) break;
      increment *= kCutBack;
      ++cuts;
      if (increment < kLeastIncrement * scheme.increment) break;
    }
  }
  result.note = fmt::format("{} Jacobians, {} cut-backs{}", solving.jacobians(), cuts,
                            clock.seconds() > scheme.budget ? ", out of time" : "");
  result.evaluations = solving.evaluations();
  result.seconds = clock.seconds();
  return result;
}

}  // namespace knitmech::bench
