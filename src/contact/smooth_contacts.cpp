#include "contact/smooth_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/closest_places.h"
#include "contact/constants.h"
#include "contact/crossing_batch.h"
#include "contact/yarn_end.h"

namespace knitmech::contact {

namespace {

/// Density of the contact energy, times D^2 / K, for which two straight yarns that cross at a right angle with the
/// penetration c D, c = kReferenceOverlap, press with K c D: c / (2 pi (1 - c) (-c - ln(1 - c))).
double density_factor() {
  constexpr double c = kReferenceOverlap;
  return c / (2 * std::numbers::pi * (1 - c) * normal_energy(c, 1));
}

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

/// A contact whose resultant acts at an end of a yarn. \return friction loss [mJ]
double add_cut(const Step& step, const CutLoad& cut, bool is_swapped, double penetration, double stick_stiffness,
               ContactState& now) {
  if (cut.load <= 0) {
    now = {};
    return 0;
  }
  const YarnPlace first = is_swapped ? cut.second : cut.first;
  const YarnPlace second = is_swapped ? cut.first : cut.second;
  const Vector3 normal = is_swapped ? -1.0 * cut.normal : cut.normal;
  const FrictionStep friction = friction_at(step, first, second, normal, cut.load, stick_stiffness, now.stick);
  const Vector3 force = cut.load * normal + friction.force;
  step.line.spread(second, force, step.loads);
  step.line.spread(first, -1.0 * force, step.loads);
  set_state(now, penetration, cut.load, cut.tangent, cut.energy, stick_stiffness);
  return friction.loss;
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
  if (along_first + along_second > longest * longest * determinant) {  // samples take over at the next look
    crossing.is_short = false;
    crossing.now = {};
    return 0;
  }
  const bool cut_first = end_is_within(step.elements, here.first, along_first, determinant);
  if (cut_first || end_is_within(step.elements, here.second, along_second, determinant)) {
    const PairSize seen = cut_first ? size : PairSize{size.radii, size.density, size.second_length, size.first_length};
    const CutLoad cut = crossing_at_end(step.elements, step.line, cut_first ? here : swapped(here), seen);
    return add_cut(step, cut, !cut_first, -crossing.gap, stick, crossing.now);
  }
  PairLoad pair = crossing_load(here.at, here.hessian, distance, size);
  return add_pair(step, pair, here.first, here.second, (1 / distance) * here.at.between, -crossing.gap, stick,
                  crossing.now);
}

/// A sample on its own, in any case that may come. \return friction loss [mJ]
double add_sample(const Step& step, Sample& sample) {
  const Followed here = follow_nearest(step.elements, step.line, sample.at, sample.other);
  sample.other = here.second;
  const PairSize size = size_of(step, here.first, here.second);
  const double distance = length(here.at.between);
  sample.gap = distance - size.radii;
  sample.is_minimum = here.is_minimum;
  if (sample.gap >= 0 || !here.is_minimum || here.hessian.tt <= 0 ||
      too_near_along_yarn(step.elements, here.first, here.second, size.radii)) {
    sample.now = {};
    if (here.is_minimum && sample.gap > 0) sample.wake = motion_of(step, here.first, here.second) + sample.gap;
    return 0;
  }
  const double stick = kStickStiffness * step.law.stiffness * sample.share * sample.length / size.radii;
  const double across = -2 * sample.gap * distance * size.second_length * size.second_length;
  if (end_is_within(step.elements, here.second, across, here.hessian.tt)) {
    const CutLoad cut = sample_at_end(step.elements, step.line, here, size, sample.length * sample.share);
    return add_cut(step, cut, sample.on_second, -sample.gap, stick, sample.now);
  }
  PairLoad pair = sample_load(here.at, here.hessian, distance, size, sample.length * sample.share);
  const Vector3 normal = (1 / distance) * here.at.between;
  if (!sample.on_second) {
    return add_pair(step, pair, here.first, here.second, normal, -sample.gap, stick, sample.now);
  }
  const CurveLoad on_sampled = pair.on_first;
  pair.on_first = pair.on_second;
  pair.on_second = on_sampled;
  return add_pair(step, pair, here.second, here.first, -1.0 * normal, -sample.gap, stick, sample.now);
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
KNITMECH_INLINE bool gather(const Step& step, YarnPlace first, YarnPlace second, double stick_stiffness, double weight,
                            const SlipMemory& stick, ContactBatch& batch) {
  const std::size_t lane = batch.n;
  const auto a = static_cast<std::size_t>(first.element);
  const auto b = static_cast<std::size_t>(second.element);
  if (step.elements.yarn[a] == step.elements.yarn[b]) return false;
  if (!gather(step, first, batch.first, lane) || !gather(step, second, batch.second, lane)) return false;
  const PairSize size = size_of(step, first, second);
  batch.radii[lane] = size.radii;
  batch.density[lane] = size.density;
  batch.friction[lane] = step.law.friction.between(step.elements.section[a], step.elements.section[b]);
  batch.stick_stiffness[lane] = stick_stiffness;
  batch.weight[lane] = weight;
  batch.elastic_slip.set(lane, stick.elastic_slip);
  batch.normal.set(lane, stick.normal);
  ++batch.n;
  return true;
}

/// Takes the result of a regular lane over. \param is_swapped the first yarn of the batch is the second of the contact
KNITMECH_INLINE void take_over(const Step& step, const ContactBatch& batch, std::size_t lane, YarnPlace first,
                               YarnPlace second, bool is_swapped, ContactState& now) {
  scatter(step, first.element, batch.first, lane);
  scatter(step, second.element, batch.second, lane);
  if (batch.turned_round[lane] != 0 && !step.lost) {
    step.lost = LostCrossing{first.element, second.element,
                             step.line.node_position().at(static_cast<std::size_t>(first.element))};
  }
  const double sign = is_swapped ? -1 : 1;
  now.stick.normal = sign * batch.normal.at(lane);
  now.stick.elastic_slip = sign * batch.elastic_slip.at(lane);
  now.stick.slid += batch.slid[lane];
  now.stick.slips = batch.slipped[lane] != 0;
  set_state(now, batch.penetration[lane], batch.load[lane], batch.tangent[lane], batch.energy[lane],
            batch.stick_stiffness[lane]);
}

/// Contacts that wait in the lanes of a batch.
template <typename Contact>
using Waiting = std::array<Contact*, kLanes>;

double flush(const Step& step, ContactBatch& batch, const Waiting<Crossing>& waiting) {
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
    take_over(step, batch, lane, crossing.first, crossing.second, false, crossing.now);
    loss += batch.loss[lane];
  }
  batch.n = 0;
  return loss;
}

double flush(const Step& step, ContactBatch& batch, const Waiting<Sample>& waiting) {
  evaluate_samples(batch, step.length);
  double loss = 0;
  for (std::size_t lane = 0; lane < batch.n; ++lane) {
    Sample& sample = *waiting[lane];
    if (batch.regular[lane] == 0) {
      loss += add_sample(step, sample);
      continue;
    }
    sample.other.share = batch.second.share[lane];
    sample.gap = -batch.penetration[lane];
    sample.is_minimum = true;
    take_over(step, batch, lane, sample.at, sample.other, sample.on_second, sample.now);
    loss += batch.loss[lane];
  }
  batch.n = 0;
  return loss;
}

double add_crossings(const Step& step, std::vector<Crossing>& crossings) {
  ContactBatch batch{};
  Waiting<Crossing> waiting{};
  const double stick = kStickStiffness * step.law.stiffness;
  double loss = 0;
  for (Crossing& crossing : crossings) {
    if (!crossing.is_short || motion_of(step, crossing.first, crossing.second) < crossing.wake) continue;
    waiting[batch.n] = &crossing;
    if (!gather(step, crossing.first, crossing.second, stick, 0, crossing.now.stick, batch)) {
      loss += add_crossing(step, crossing);
    } else if (batch.n == kLanes) {
      loss += flush(step, batch, waiting);
    }
  }
  if (batch.n > 0) loss += flush(step, batch, waiting);
  return loss;
}

double add_samples(const Step& step, std::vector<Sample>& samples) {
  ContactBatch batch{};
  Waiting<Sample> waiting{};
  double loss = 0;
  for (Sample& sample : samples) {
    if (motion_of(step, sample.at, sample.other) < sample.wake) continue;
    const double radii = size_of(step, sample.at, sample.other).radii;
    const double weight = sample.share * sample.length;
    SlipMemory stick = sample.now.stick;
    if (sample.on_second) stick = {-1.0 * stick.normal, -1.0 * stick.elastic_slip, stick.slid, stick.slips};
    waiting[batch.n] = &sample;
    if (!gather(step, sample.at, sample.other, kStickStiffness * step.law.stiffness * weight / radii, weight, stick,
                batch)) {
      loss += add_sample(step, sample);
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
  ContactStep sum;
  sum.friction_loss = add_crossings(all, contacts.crossings) + add_samples(all, contacts.samples);
  for (const Crossing& crossing : contacts.crossings) {
    sum.largest_penetration = std::max(sum.largest_penetration, crossing.now.penetration);
  }
  for (const Sample& sample : contacts.samples) {
    sum.largest_penetration = std::max(sum.largest_penetration, sample.now.penetration);
  }
  return sum;
}

}  // namespace knitmech::contact
