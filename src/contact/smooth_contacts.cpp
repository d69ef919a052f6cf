#include "contact/smooth_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/closest_places.h"
#include "contact/constants.h"
#include "contact/crossing_batch.h"
#include "contact/strips.h"

namespace knitmech::contact {

namespace {

/// Everything that one step works with.
struct Step {
  const YarnElements& elements;
  const Centreline& line;
  const SmoothLaw& law;
  const Motion& motion;
  const model::State& state;
  double length;  ///< [s]
  double density_factor;
  model::NodalLoads& loads;
  std::optional<LostCrossing>& lost;
};

KNITMECH_INLINE PairSize size_of(const Step& step, YarnPlace first, YarnPlace second) {
  const auto a = static_cast<std::size_t>(first.element);
  const auto b = static_cast<std::size_t>(second.element);
  const double radii = step.elements.radius[a] + step.elements.radius[b];
  return {radii, step.density_factor * step.law.stiffness / (radii * radii), step.elements.length[a],
          step.elements.length[b]};
}

/// Whether two places of one yarn are so near along it that they cannot touch.
KNITMECH_INLINE bool too_near_along_yarn(const YarnElements& elements, YarnPlace first, YarnPlace second,
                                         double radii) {
  const auto a = static_cast<std::size_t>(first.element);
  const auto b = static_cast<std::size_t>(second.element);
  if (elements.yarn[a] != elements.yarn[b]) return false;
  return std::abs(arc_of(elements, second) - arc_of(elements, first)) < kSelfContactArc * std::numbers::pi * radii;
}

KNITMECH_INLINE double motion_of(const Step& step, YarnPlace first, YarnPlace second) {
  return step.motion.of(static_cast<std::size_t>(first.element)) +
         step.motion.of(static_cast<std::size_t>(second.element));
}

/// Friction at a contact whose normal force is known.
KNITMECH_INLINE FrictionStep friction_at(const Step& step, YarnPlace first, YarnPlace second, Vector3 normal,
                                         double load, double stiffness, SlipMemory& stick) {
  if (dot(stick.normal, normal) < 0 && !step.lost) {
    step.lost = LostCrossing{first.element, second.element,
                             step.line.node_position().at(static_cast<std::size_t>(first.element))};
  }
  const Vector3 motion = step.length * (step.line.velocity(step.state, second) - step.line.velocity(step.state, first));
  const double limit =
      load * step.law.friction.between(step.elements.section[static_cast<std::size_t>(first.element)],
                                       step.elements.section[static_cast<std::size_t>(second.element)]);
  return friction_step(stick, normal, motion, limit, stiffness);
}

/// Sets what a contact with friction came to; its stick is up to date.
void set_state(ContactState& now, double penetration, double load, double tangent, double energy, double stiffness) {
  now.penetration = penetration;
  now.load = load;
  now.tangent = tangent;
  now.energy = energy;
  now.stick_stiffness = stiffness;
}

/// A contact with the exact derivatives of its energy. \return friction loss [mJ]
double add_pair(const Step& step, PairLoad& pair, YarnPlace first, YarnPlace second, Vector3 normal, double penetration,
                double stick_stiffness, ContactState& now) {
  const FrictionStep friction = friction_at(step, first, second, normal, pair.load, stick_stiffness, now.stick);
  pair.on_first.force = pair.on_first.force - friction.force;
  pair.on_second.force = pair.on_second.force + friction.force;
  step.line.spread(first, pair.on_first, step.loads);
  step.line.spread(second, pair.on_second, step.loads);
  set_state(now, penetration, pair.load, pair.tangent, pair.energy, stick_stiffness);
  return friction.loss;
}

/// Whether a closest place lies at an end of its yarn, where it has no parabola.
bool is_at_end(const Step& step, const Followed& here) {
  return to_nearer_end(step.elements, here.first) <= 0 || to_nearer_end(step.elements, here.second) <= 0;
}

/// A crossing on its own, in any case that may come. \return friction loss [mJ]
double add_crossing(const Step& step, Crossing& crossing) {
  const Followed here = follow_closest(step.elements, step.line, crossing.first, crossing.second);
  crossing.first = here.first;
  crossing.second = here.second;
  const PairSize size = size_of(step, here.first, here.second);
  const double distance = length(here.at.between);
  crossing.gap = distance - size.radii;
  crossing.is_minimum = here.is_minimum;
  if (crossing.gap >= 0 || !here.is_minimum ||
      too_near_along_yarn(step.elements, here.first, here.second, size.radii)) {
    crossing.now = {};
    if (here.is_minimum && crossing.gap > 0) crossing.wake = motion_of(step, here.first, here.second) + crossing.gap;
    return 0;
  }
  const double stick = kStickStiffness * step.law.stiffness;
  // Squares of the half lengths of the overlap, times the determinant.
  const double determinant = here.hessian.determinant();
  const double across = -2 * crossing.gap * distance;
  const double along_first = across * size.first_length * size.first_length * here.hessian.tt;
  const double along_second = across * size.second_length * size.second_length * here.hessian.ss;
  const double longest = kLongestOverlap * size.radii;
  if (along_first + along_second > longest * longest * determinant ||
      is_at_end(step, here)) {  // strips take over at the next look
    crossing.is_short = false;
    crossing.now = {};
    return 0;
  }
  PairLoad pair = crossing_load(here.at, here.hessian, distance, size);
  return add_pair(step, pair, here.first, here.second, (1 / distance) * here.at.between, -crossing.gap, stick,
                  crossing.now);
}

/// Puts the element of a place into a lane. \return false if the place has left the element
KNITMECH_INLINE bool gather(const Step& step, YarnPlace place, LaneSides& side, std::size_t lane) {
  const auto i = static_cast<std::size_t>(place.element);
  set_element(side, lane, step.line.element(i));
  side.start_velocity.set(lane, step.state.velocity.at(i));
  side.end_velocity.set(lane, step.state.velocity.at(i + 1));
  side.start_turning.set(lane, step.state.angular_velocity.at(i));
  side.end_turning.set(lane, step.state.angular_velocity.at(i + 1));
  side.share[lane] = place.share;
  side.to_end[lane] = to_nearer_end(step.elements, place);
  return place.share >= 0 && place.share <= 1;
}

KNITMECH_INLINE void scatter(const Step& step, std::int32_t element, const LaneSides& side, std::size_t lane) {
  const auto i = static_cast<std::size_t>(element);
  step.loads.force.add(i, side.start_force.at(lane));
  step.loads.force.add(i + 1, side.end_force.at(lane));
  step.loads.moment.add(i, side.start_moment.at(lane));
  step.loads.moment.add(i + 1, side.end_moment.at(lane));
}

/// Puts a contact into the next lane. \return false if it has to be computed on its own
KNITMECH_INLINE bool gather(const Step& step, YarnPlace first, YarnPlace second, double stick_stiffness,
                            const SlipMemory& stick, ContactBatch& batch) {
  const std::size_t lane = batch.n;
  const auto a = static_cast<std::size_t>(first.element);
  const auto b = static_cast<std::size_t>(second.element);
  if (too_near_along_yarn(step.elements, first, second, 2 * (step.elements.radius[a] + step.elements.radius[b])))
    return false;
  if (!gather(step, first, batch.first, lane) || !gather(step, second, batch.second, lane)) return false;
  const PairSize size = size_of(step, first, second);
  batch.radii[lane] = size.radii;
  batch.density[lane] = size.density;
  batch.friction[lane] = step.law.friction.between(step.elements.section[a], step.elements.section[b]);
  batch.stick_stiffness[lane] = stick_stiffness;
  batch.elastic_slip.set(lane, stick.elastic_slip);
  batch.normal.set(lane, stick.normal);
  ++batch.n;
  return true;
}

/// Takes the result of a regular lane over.
KNITMECH_INLINE void take_over(const Step& step, const ContactBatch& batch, std::size_t lane, YarnPlace first,
                               YarnPlace second, ContactState& now) {
  scatter(step, first.element, batch.first, lane);
  scatter(step, second.element, batch.second, lane);
  if (batch.turned_round[lane] != 0 && !step.lost) {
    step.lost = LostCrossing{first.element, second.element,
                             step.line.node_position().at(static_cast<std::size_t>(first.element))};
  }
  now.stick.normal = batch.normal.at(lane);
  now.stick.elastic_slip = batch.elastic_slip.at(lane);
  now.stick.slid += batch.slid[lane];
  now.stick.slips = batch.slipped[lane] != 0;
  set_state(now, batch.penetration[lane], batch.load[lane], batch.tangent[lane], batch.energy[lane],
            batch.stick_stiffness[lane]);
}

/// Crossings that wait in the lanes of a batch.
using Waiting = std::array<Crossing*, kLanes>;

double flush(const Step& step, ContactBatch& batch, const Waiting& waiting) {
  evaluate_crossings(batch, step.length);
  double loss = 0;
  for (std::size_t lane = 0; lane < batch.n; ++lane) {
    Crossing& crossing = *waiting[lane];
    if (batch.regular[lane] == 0) {
      loss += add_crossing(step, crossing);
      continue;
    }
    crossing.first.share = batch.first.share[lane];
    crossing.second.share = batch.second.share[lane];
    crossing.gap = -batch.penetration[lane];
    crossing.is_minimum = true;
    take_over(step, batch, lane, crossing.first, crossing.second, crossing.now);
    loss += batch.loss[lane];
  }
  batch.n = 0;
  return loss;
}

double add_crossings(const Step& step, std::vector<Crossing>& crossings) {
  ContactBatch batch{};
  Waiting waiting{};
  const double stick = kStickStiffness * step.law.stiffness;
  double loss = 0;
  for (Crossing& crossing : crossings) {
    if (!crossing.is_short || motion_of(step, crossing.first, crossing.second) < crossing.wake) continue;
    waiting[batch.n] = &crossing;
    if (!gather(step, crossing.first, crossing.second, stick, crossing.now.stick, batch)) {
      loss += add_crossing(step, crossing);
    } else if (batch.n == kLanes) {
      loss += flush(step, batch, waiting);
    }
  }
  if (batch.n > 0) loss += flush(step, batch, waiting);
  return loss;
}

}  // namespace

ContactStep add_smooth_forces(const YarnElements& elements, const Centreline& line, const SmoothLaw& law,
                              const Motion& motion, const model::State& state, double step, FollowedContacts& contacts,
                              model::NodalLoads& loads, std::optional<LostCrossing>& lost) {
  const Step all{elements, line, law, motion, state, step, density_factor(), loads, lost};
  ContactStep sum = add_strip_forces(elements, line, law, motion, state, step, contacts, loads, lost);
  sum.friction_loss += add_crossings(all, contacts.crossings);
  for (const Crossing& crossing : contacts.crossings) {
    sum.largest_penetration = std::max(sum.largest_penetration, crossing.now.penetration);
  }
  return sum;
}

}  // namespace knitmech::contact
