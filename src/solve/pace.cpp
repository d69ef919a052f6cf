#include "solve/pace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solve/constants.h"

namespace knitmech::solve {

namespace {

/// Moves a mean towards a value, over a way in which it forgets all but 1/e of what it was.
void follow(double& mean, double value, double way, double memory) {
  mean += (1 - std::exp(-way / memory)) * (value - mean);
}

/// Speed at which an energy that goes with its square is as large as allowed.
double speed_for(double allowed, double energy, double speed) {
  if (energy <= 0) return std::numeric_limits<double>::max();
  return speed * std::sqrt(std::max(allowed, 0.0) / energy);
}

}  // namespace

Pace::Pace(const PaceScale& scale) : scale_(scale) {
  state_.goal = kCalmPace * scale.speed;
  limit_acceleration(0);
}

void Pace::look(const PaceSignals& now) {
  take_in(now);
  state_.goal = std::min(goal(now), goal_where_judged());
  limit_acceleration(now.force);
}

void Pace::take_in(const PaceSignals& now) {
  const double way = state_.displacement - state_.looked_at;
  state_.looked_at = state_.displacement;
  follow(state_.internal, now.internal, way, kPaceMemory * scale_.gauge_length);
  follow(state_.kinetic, now.kinetic, way, kPaceMemory * scale_.gauge_length);
  follow(state_.stray, now.stray, way, kPaceMemory * scale_.gauge_length);
  follow(state_.stray_now, now.stray, way, kPaceShortMemory * scale_.gauge_length);
}

double Pace::goal(const PaceSignals& now) const {
  const double calm = kCalmPace * scale_.speed;
  const double internal = std::max(state_.internal, now.internal);
  const double taut = calm * std::sqrt(std::max(1.0, internal / (kTautEnergy * scale_.bending)));
  const double stray = std::max(state_.stray, state_.stray_now);
  return std::clamp(speed_for(kStrayGoal * internal, stray, state_.speed), calm, taut);
}

double Pace::goal_where_judged() const {
  const double share = state_.displacement / (scale_.strain * scale_.gauge_length);
  if (share <= kUnjudgedShare) return std::numeric_limits<double>::max();
  const double strictness = std::min(1.0, (share - kUnjudgedShare) / (kJudgedShare - kUnjudgedShare));
  const double wanted = speed_for(kKineticGoal / strictness * state_.internal, state_.kinetic, state_.speed);
  return std::max(wanted, kSlowestPace * scale_.speed);
}

void Pace::limit_acceleration(double force) {
  const double calm = kCalmPace * scale_.speed;
  const bool starts = state_.displacement < kStartStrain * scale_.gauge_length;
  const double gentle = calm * calm / ((starts ? kStartStrain : kGentleStrain) * scale_.gauge_length);
  const auto limit = [&](double strain, double share_of_force) {
    const double by_strain = state_.speed * state_.speed / (strain * scale_.gauge_length);
    return std::max(gentle, std::min(by_strain, share_of_force * std::max(force, 0.0) / scale_.mass));
  };
  state_.speeding_up = limit(kSpeedingUpStrain, kSpeedingUpForce);
  state_.braking = limit(kBrakingStrain, kBrakingForce);
}

double Pace::advance(double h, double after) {
  const double before = state_.speed;
  state_.speed = std::clamp(state_.goal, before - state_.braking * h, before + state_.speeding_up * h);
  state_.acceleration = (state_.speed - before) / h;
  state_.displacement += after * state_.speed;
  return state_.speed;
}

}  // namespace knitmech::solve
