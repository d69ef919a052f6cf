#include "schemes/dynamic_relaxation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/nodal_inertia.h"
#include "bench_fabric.h"
#include "schemes/constants.h"
#include "schemes/static_fabric.h"
#include "solve/constants.h"
#include "solve/contact_frequency.h"
#include "solve/integrate.h"
#include "solve/mass_scaling.h"
#include "solve/selective_mass.h"

namespace knitmech::bench {

namespace {

double product(const model::VectorArray& a, const model::VectorArray& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a.at(i), b.at(i));
  return sum;
}

class Relaxing {
 public:
  Relaxing(const model::Model& model, const Relaxation& scheme)
      : scheme_(scheme),
        fabric_(model),
        inertia_(beam::lump_inertia(fabric_.elements(), 1, scheme.selective_mass ? solve::selective_length(model) : 0)),
        masses_(inertia_, solve::GivenMotion::by_grips(model)),
        grips_(model),
        contact_(model),
        state_(state_of(model)),
        loads_(model.nodes.size()),
        loads_before_(model.nodes.size()),
        zero_loads_(model.nodes.size()) {
    set_step();
  }

  /// \return false if the fabric did not come to rest
  bool advance(double displacement) {
    fabric_.stretch(displacement, step_, state_);
    fabric_.set_loads(state_, step_, contact_, loads_);
    stop();
    for (long i = 0; i < kMostRelaxationSteps; ++i) {
      if (fabric_.is_at_rest(loads_, scheme_.tolerance)) return true;
      if (i % solve::kWatchInterval == 0) set_step();
      step();
    }
    return false;
  }

  [[nodiscard]] double grip_force() const { return fabric_.grip_force(loads_); }
  [[nodiscard]] long evaluations() const { return fabric_.evaluations(); }
  [[nodiscard]] bool has_lost_crossing() const { return contact_.lost_crossing().has_value(); }

 private:
  /// The steps of ExplicitSolver, but that no energy has to be kept, so they may follow what is allowed.
  void set_step() {
    const double contacts = solve::highest_frequency_squared(contact_.springs(), inertia_, masses_);
    const double lightest = *std::ranges::min_element(masses_.felt());
    const double expected = solve::kExpectedContacts * fabric_.model().contact_stiffness / lightest;
    const double frequency_squared = inertia_.highest_frequency_squared + std::max(contacts, expected);
    step_ = solve::kStepReserve * kStepFactor * 2 / std::sqrt(frequency_squared);
    const double speed = std::sqrt(solve::largest_speed_squared(state_));
    if (speed > 0) step_ = std::min(step_, solve::kLargestMove * fabric_.smallest_radius() / speed);
  }

  /// A leapfrog starts from rest with half a kick; a whole one would make the fastest vibrations grow.
  void stop() {
    state_.velocity = model::VectorArray(state_.velocity.size());
    state_.angular_velocity = model::VectorArray(state_.velocity.size());
    peak_ = 0;
    step_before_ = 0;
  }

  void step() {
    const double damping = scheme_.calming == Calming::viscous ? critical_damping() : 0;
    if (scheme_.calming == Calming::kinetic && has_passed_peak()) stop();
    loads_before_ = fabric_.free_loads(loads_);
    const solve::StepLengths steps{step_before_, step_};
    grips_.apply(inertia_, masses_, steps, damping, state_, 0, loads_);
    solve::integrate(inertia_, loads_, steps, damping, state_);
    fabric_.set_loads(state_, step_, contact_, loads_);
    step_before_ = step_;
  }

  /// 1/2 v M v of the velocities between two positions [mJ].
  [[nodiscard]] double kinetic_energy() const { return solve::kinetic_energy(inertia_, zero_loads_, {}, state_); }

  bool has_passed_peak() {
    const double now = kinetic_energy();
    peak_ = std::max(peak_, now);
    return now < kFallenEnergy * peak_;
  }

  /// 2 w, w^2 = v K v / (v M v) of the present motion v [1/s]; the last loads tell K v.
  [[nodiscard]] double critical_damping() const {
    const double energy = kinetic_energy();
    if (energy <= 0) return 0;
    const model::NodalLoads now = fabric_.free_loads(loads_);
    const double gained = product(state_.velocity, now.force) - product(state_.velocity, loads_before_.force) +
                          product(state_.angular_velocity, now.moment) -
                          product(state_.angular_velocity, loads_before_.moment);
    return 2 * std::sqrt(std::max(0.0, -gained / (step_ * 2 * energy)));
  }

  const Relaxation& scheme_;
  StaticFabric fabric_;
  beam::NodalInertia inertia_;
  solve::SelectiveMass masses_;
  solve::Grips grips_;
  contact::YarnContact contact_;
  model::State state_;
  model::NodalLoads loads_, loads_before_, zero_loads_;
  double step_ = 0, step_before_ = 0;  ///< [s]
  double peak_ = 0;                    ///< largest kinetic energy since the fabric was stopped [mJ]
};

}  // namespace

SchemeResult relax(const model::Model& model, const Relaxation& scheme) {
  const Clock clock;
  Relaxing relaxing(model, scheme);
  SchemeResult result{.name = scheme.name, .curve = ForceCurve(model.test.gauge_length), .note = {}};
  const auto n = static_cast<int>(std::lround(model.test.strain / scheme.increment));
  int restless = 0;
  double force_before = 0;
  for (int i = 1; i <= n && !relaxing.has_lost_crossing(); ++i) {
    if (!relaxing.advance(model.test.strain / n * model.test.gauge_length)) ++restless;
    const double force = relaxing.grip_force();
    result.curve.add(model.test.strain * i / n, 0.5 * (force_before + force));
    force_before = force;
  }
  if (restless > 0) result.note = fmt::format("{} of {} increments not at rest", restless, n);
  if (relaxing.has_lost_crossing()) result.note = "lost a crossing";
  result.evaluations = relaxing.evaluations();
  result.seconds = clock.seconds();
  return result;
}

}  // namespace knitmech::bench
