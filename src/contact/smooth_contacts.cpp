#include "contact/smooth_contacts.h"

#include <cmath>
#include <numbers>

#include "contact/closest_places.h"
#include "contact/constants.h"
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
  std::vector<ContactPoint>& found;
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

/// A contact whose resultant acts at an end of a yarn. \return friction loss [mJ]
double add_cut(const Step& step, const CutLoad& cut, bool is_swapped, double penetration, double stick_stiffness,
               SlipMemory& stick) {
  if (cut.load <= 0) return 0;
  const YarnPlace first = is_swapped ? cut.second : cut.first;
  const YarnPlace second = is_swapped ? cut.first : cut.second;
  const Vector3 normal = is_swapped ? -1.0 * cut.normal : cut.normal;
  const FrictionStep friction = friction_at(step, first, second, normal, cut.load, stick_stiffness, stick);
  const Vector3 force = cut.load * normal + friction.force;
  step.line.spread(second, force, step.loads);
  step.line.spread(first, -1.0 * force, step.loads);
  step.found.push_back({first, second, normal, penetration, cut.load, cut.tangent, cut.energy, stick_stiffness, stick});
  return friction.loss;
}

/// A contact with the exact derivatives of its energy. \return friction loss [mJ]
KNITMECH_INLINE double add_pair(const Step& step, PairLoad& pair, YarnPlace first, YarnPlace second, Vector3 normal,
                                double penetration, double stick_stiffness, SlipMemory& stick) {
  const FrictionStep friction = friction_at(step, first, second, normal, pair.load, stick_stiffness, stick);
  pair.on_first.force = pair.on_first.force - friction.force;
  pair.on_second.force = pair.on_second.force + friction.force;
  step.line.spread(first, pair.on_first, step.loads);
  step.line.spread(second, pair.on_second, step.loads);
  step.found.push_back(
      {first, second, normal, penetration, pair.load, pair.tangent, pair.energy, stick_stiffness, stick});
  return friction.loss;
}

KNITMECH_INLINE double add_crossing(const Step& step, Crossing& crossing) {
  if (motion_of(step, crossing.first, crossing.second) < crossing.wake) return 0;
  const Followed here = follow_closest(step.elements, step.line, crossing.first, crossing.second);
  crossing.first = here.first;
  crossing.second = here.second;
  const PairSize size = size_of(step, here.first, here.second);
  const double distance = length(here.at.between);
  crossing.gap = distance - size.radii;
  crossing.is_minimum = here.is_minimum;
  if (crossing.gap >= 0 || !here.is_minimum || !crossing.is_short ||
      too_near_along_yarn(step.elements, here.first, here.second, size.radii)) {
    crossing.stick = {};
    if (here.is_minimum && crossing.gap > 0) crossing.wake = motion_of(step, here.first, here.second) + crossing.gap;
    return 0;
  }
  const double stick = kStickStiffness * step.law.stiffness;
  const bool cut_first = end_cuts_first(step.elements, here, distance, size);
  if (cut_first || end_cuts_second(step.elements, here, distance, size)) {
    const PairSize seen = cut_first ? size : PairSize{size.radii, size.density, size.second_length, size.first_length};
    const CutLoad cut = crossing_at_end(step.elements, step.line, cut_first ? here : swapped(here), seen);
    return add_cut(step, cut, !cut_first, -crossing.gap, stick, crossing.stick);
  }
  PairLoad pair = crossing_load(here.at, here.hessian, distance, size);
  return add_pair(step, pair, here.first, here.second, (1 / distance) * here.at.between, -crossing.gap, stick,
                  crossing.stick);
}

KNITMECH_INLINE double add_sample(const Step& step, Sample& sample) {
  if (motion_of(step, sample.at, sample.other) < sample.wake) return 0;
  const Followed here = follow_nearest(step.elements, step.line, sample.at, sample.other);
  sample.other = here.second;
  const PairSize size = size_of(step, here.first, here.second);
  const double distance = length(here.at.between);
  sample.gap = distance - size.radii;
  sample.is_minimum = here.is_minimum;
  if (sample.gap >= 0 || !here.is_minimum || here.hessian.tt <= 0 ||
      too_near_along_yarn(step.elements, here.first, here.second, size.radii)) {
    sample.stick = {};
    if (here.is_minimum && sample.gap > 0) sample.wake = motion_of(step, here.first, here.second) + sample.gap;
    return 0;
  }
  const double stick = kStickStiffness * step.law.stiffness * sample.share * sample.length / size.radii;
  const ToEnds ends = to_ends(step.elements, here.second);
  const double nearest = ends.back < ends.ahead ? ends.back : ends.ahead;
  const double across = -2 * sample.gap * distance * size.second_length * size.second_length;
  if (nearest <= 0 || across > nearest * nearest * here.hessian.tt) {
    const CutLoad cut = sample_at_end(step.elements, step.line, here, size, sample.length, sample.share);
    return add_cut(step, cut, sample.on_second, -sample.gap, stick, sample.stick);
  }
  PairLoad pair = sample_load(here.at, here.hessian, distance, size, sample.length, sample.share);
  const Vector3 normal = (1 / distance) * here.at.between;
  if (!sample.on_second) {
    return add_pair(step, pair, here.first, here.second, normal, -sample.gap, stick, sample.stick);
  }
  const CurveLoad on_sampled = pair.on_first;
  pair.on_first = pair.on_second;
  pair.on_second = on_sampled;
  return add_pair(step, pair, here.second, here.first, -1.0 * normal, -sample.gap, stick, sample.stick);
}

KNITMECH_VECTORISE double add_all(const Step& step, FollowedContacts& contacts) {
  double loss = 0;
  for (Crossing& crossing : contacts.crossings) loss += add_crossing(step, crossing);
  for (Sample& sample : contacts.samples) loss += add_sample(step, sample);
  return loss;
}

}  // namespace

double add_smooth_forces(const YarnElements& elements, const Centreline& line, const SmoothLaw& law,
                         const Motion& motion, const model::State& state, double step, FollowedContacts& contacts,
                         model::NodalLoads& loads, std::vector<ContactPoint>& found,
                         std::optional<LostCrossing>& lost) {
  found.clear();
  return add_all({elements, line, law, motion, state, step, density_factor(), loads, found, lost}, contacts);
}

}  // namespace knitmech::contact
