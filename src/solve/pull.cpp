#include "solve/pull.h"

#include <algorithm>
#include <utility>

#include "model/bending_measure.h"
#include "solve/constants.h"

namespace knitmech::solve {

namespace {

PaceScale scale_of(const model::Model& model, double mass) {
  const double speed = model.test.speed * std::min(1.0, model.test.strain / kShortTest);
  return {speed, model.test.gauge_length, model.test.strain, mass, model::bending_measure(model)};
}

}  // namespace

Pull::Pull(const model::Model& model, const beam::NodalInertia& inertia, bool adapts_pace) : test_(model.test) {
  if (!adapts_pace) return;
  const EvenStretch stretch(model, inertia);
  paced_ = Paced{stretch, Pace(scale_of(model, stretch.mass()))};
}

double Pull::displacement(double time) const {
  return paced_ ? paced_->pace.state().displacement : test_.displacement(time);
}

bool Pull::has_to_look(long steps) const {
  return paced_ && steps > 0 && steps % kPaceInterval == 0;
}

void Pull::look(double internal, double kinetic, const model::State& state) {
  const Impulse past = std::exchange(impulse_, {});
  const double stray = paced_->stretch.stray_energy(kinetic, paced_->pace.state().speed, state);
  paced_->pace.look({internal, kinetic, stray, std::min(past.top, past.bottom) / past.time});
}

double Pull::advance(StepLengths step, const model::State& state, model::NodalLoads& loads) {
  if (!paced_) {
    // The mean speed over the step after, so that the grip's displacement is exact whatever the steps are.
    return (test_.displacement(state.time + step.after) - test_.displacement(state.time)) / step.after;
  }
  Pace& pace = paced_->pace;
  const double speed_before = pace.state().speed;
  const double speed = pace.advance(step.mean(), step.after);
  paced_->stretch.apply(speed_before, pace.state().acceleration, step.mean(), state, loads);
  return speed;
}

void Pull::add_forces(double top, double bottom, double h) {
  impulse_.top += h * top;
  impulse_.bottom += h * bottom;
  impulse_.time += h;
}

}  // namespace knitmech::solve
