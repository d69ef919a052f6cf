#include "contact/smooth_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/blocks.h"
#include "contact/closest_places.h"
#include "contact/constants.h"
#include "contact/crossing_batch.h"
#include "contact/strips.h"

namespace knitmech::contact {

namespace {

/// Way of a crossing along a yarn after which the strips around it are laid anew [sums of the radii]: less than the
/// margin that its reach has (look_for_contacts.cpp), or strips and crossing would count the same.
constexpr double kFarFromLaid = 0.15;

/// Crossings, and overlaps, that one thread takes at a time [-]; the same for any number of threads, as what they come
/// to is summed up within them first. Fewer: more even shares.
constexpr std::size_t kCrossingsAtOnce = 32;
constexpr std::size_t kOverlapsAtOnce = 4;

KNITMECH_INLINE PairSize size_of(const StepOfContacts& step, YarnPlace first, YarnPlace second) {
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

/// Of all elements within reach of a place, summed up.
double motion_around(const StepOfContacts& step, YarnPlace place, double reach) {
  const auto n = static_cast<std::int32_t>(step.elements.n_nodes()) - 1;
  const auto each_side =
      static_cast<std::int32_t>(reach / step.elements.length[static_cast<std::size_t>(place.element)]) + 1;
  double sum = 0;
  for (std::int32_t e = std::max(place.element - each_side, 0); e <= std::min(place.element + each_side, n); ++e) {
    sum += step.motion.of(static_cast<std::size_t>(e));
  }
  return sum;
}

/// A bound of how much nearer to each other the yarns of a crossing have come: its closest place may be anywhere within
/// its reach by now, on other elements than when it was followed last.
double motion_of(const StepOfContacts& step, const Crossing& crossing) {
  return motion_around(step, crossing.first, crossing.first_reach) +
         motion_around(step, crossing.second, crossing.second_reach);
}

LostCrossing lost_at(const StepOfContacts& step, YarnPlace first, YarnPlace second) {
  return {first.element, second.element, step.line.node_position().at(static_cast<std::size_t>(first.element))};
}

/// Friction at a contact whose normal force is known.
FrictionStep friction_at(const StepOfContacts& step, YarnPlace first, YarnPlace second, Vector3 normal, double load,
                         double stiffness, SlipMemory& stick, ContactStep& done) {
  if (dot(stick.normal, normal) < 0 && !done.lost) done.lost = lost_at(step, first, second);
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

/// Whether a crossing has slid far from where it was when the strips around it were laid.
bool has_slid_far(const StepOfContacts& step, const Crossing& crossing) {
  const double far = kFarFromLaid * (step.elements.radius[static_cast<std::size_t>(crossing.first.element)] +
                                     step.elements.radius[static_cast<std::size_t>(crossing.second.element)]);
  const auto slid = [&](YarnPlace now, YarnPlace laid) {
    return std::abs(arc_of(step.elements, now) - arc_of(step.elements, laid));
  };
  return slid(crossing.first, crossing.laid.first) > far || slid(crossing.second, crossing.laid.second) > far;
}

/// What a contact does to the elements of both yarns.
struct LoadPair {
  ElementLoad &first, &second;
};

/// A contact with the exact derivatives of its energy.
void press(const StepOfContacts& step, PairLoad& pair, const Followed& here, double penetration, Crossing& crossing,
           LoadPair loads, ContactStep& done) {
  const double stick_stiffness = kStickStiffness * step.law.stiffness;
  const Vector3 normal = (1 / length(here.at.between)) * here.at.between;
  const FrictionStep friction =
      friction_at(step, here.first, here.second, normal, pair.load, stick_stiffness, crossing.now.stick, done);
  pair.on_first.force = pair.on_first.force - friction.force;
  pair.on_second.force = pair.on_second.force + friction.force;
  const auto on = [&](YarnPlace place, const CurveLoad& load) {
    return ElementLoad{place.element,
                       step.line.element(static_cast<std::size_t>(place.element)).to_nodes(place.share, load)};
  };
  loads.first = on(here.first, pair.on_first);
  loads.second = on(here.second, pair.on_second);
  set_state(crossing.now, penetration, pair.load, pair.tangent, pair.energy, stick_stiffness);
  done.friction_loss += friction.loss;
}

/// Whether a closest place lies at an end of its yarn, where it has no parabola.
bool is_at_end(const StepOfContacts& step, const Followed& here) {
  return to_nearer_end(step.elements, here.first) <= 0 || to_nearer_end(step.elements, here.second) <= 0;
}

/// A crossing on its own, in any case that may come.
void add_crossing(const StepOfContacts& step, Crossing& crossing, LoadPair loads, ContactStep& done) {
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
    if (here.is_minimum && crossing.gap > 0) crossing.wake = motion_of(step, crossing) + crossing.gap;
    return;
  }
  // Squares of the half lengths of the overlap, times the determinant.
  const double determinant = here.hessian.determinant();
  const double across = -2 * crossing.gap * distance;
  const double along_first = across * size.first_length * size.first_length * here.hessian.tt;
  const double along_second = across * size.second_length * size.second_length * here.hessian.ss;
  const double longest = kLongestOverlap * size.radii;
  if (along_first + along_second > longest * longest * determinant || is_at_end(step, here)) {
    crossing.is_short = false;
    crossing.now = {};
    done.asks_for_look = true;  // strips take over in the next step
    return;
  }
  PairLoad pair = crossing_load(here.at, here.hessian, distance, size);
  press(step, pair, here, -crossing.gap, crossing, loads, done);
}

/// Puts the element of a place into a lane. \return false if the place has left the element
KNITMECH_INLINE bool gather(const StepOfContacts& step, YarnPlace place, LaneSides& side, std::size_t lane) {
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

/// Puts a contact into the next lane. \return false if it has to be computed on its own
KNITMECH_INLINE bool gather(const StepOfContacts& step, YarnPlace first, YarnPlace second, double stick_stiffness,
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
KNITMECH_INLINE void take_over(const StepOfContacts& step, const ContactBatch& batch, std::size_t lane,
                               Crossing& crossing, LoadPair loads, ContactStep& done) {
  const auto on = [lane](std::int32_t element, const LaneSides& side) {
    return ElementLoad{
        element,
        {side.start_force.at(lane), side.end_force.at(lane), side.start_moment.at(lane), side.end_moment.at(lane)}};
  };
  loads.first = on(crossing.first.element, batch.first);
  loads.second = on(crossing.second.element, batch.second);
  crossing.first.share = batch.first.share[lane];
  crossing.second.share = batch.second.share[lane];
  crossing.gap = -batch.penetration[lane];
  crossing.is_minimum = true;
  if (batch.turned_round[lane] != 0 && !done.lost) done.lost = lost_at(step, crossing.first, crossing.second);
  ContactState& now = crossing.now;
  now.stick.normal = batch.normal.at(lane);
  now.stick.elastic_slip = batch.elastic_slip.at(lane);
  now.stick.slid += batch.slid[lane];
  now.stick.slips = batch.slipped[lane] != 0;
  set_state(now, batch.penetration[lane], batch.load[lane], batch.tangent[lane], batch.energy[lane],
            batch.stick_stiffness[lane]);
  done.friction_loss += batch.loss[lane];
}

}  // namespace

/// Room for one thread to compute in.
struct SmoothForces::Work {
  ContactBatch batch{};
  std::array<std::size_t, kLanes> waiting{};  ///< crossings in the lanes of the batch
  OverlapWork overlap;
};

SmoothForces::SmoothForces() = default;
SmoothForces::~SmoothForces() = default;
SmoothForces::SmoothForces(const SmoothForces& /*other*/) {}
SmoothForces& SmoothForces::operator=(const SmoothForces& /*other*/) {
  return *this;
}

void SmoothForces::flush(const StepOfContacts& step, std::vector<Crossing>& crossings, Work& work, ContactStep& done) {
  ContactBatch& batch = work.batch;
  if (batch.n == 0) return;
  evaluate_crossings(batch, step.length);
  for (std::size_t lane = 0; lane < batch.n; ++lane) {
    const std::size_t i = work.waiting[lane];
    const LoadPair loads{on_crossings_[2 * i], on_crossings_[2 * i + 1]};
    if (batch.regular[lane] != 0) {
      take_over(step, batch, lane, crossings[i], loads, done);
    } else {
      add_crossing(step, crossings[i], loads, done);
    }
  }
  batch.n = 0;
}

void SmoothForces::evaluate(const StepOfContacts& step, std::vector<Crossing>& crossings, std::size_t begin,
                            std::size_t end, Work& work, ContactStep& done) {
  const double stick = kStickStiffness * step.law.stiffness;
  for (std::size_t i = begin; i < end; ++i) {
    on_crossings_[2 * i].element = on_crossings_[2 * i + 1].element = ElementLoad::kNone;
    Crossing& crossing = crossings[i];
    if (!crossing.is_short || (crossing.wake > 0 && motion_of(step, crossing) < crossing.wake)) continue;
    crossing.wake = 0;  // what it was said of other elements, if the places have moved on
    work.waiting[work.batch.n] = i;
    if (!gather(step, crossing.first, crossing.second, stick, crossing.now.stick, work.batch)) {
      add_crossing(step, crossing, {on_crossings_[2 * i], on_crossings_[2 * i + 1]}, done);
    } else if (work.batch.n == kLanes) {
      flush(step, crossings, work, done);
    }
  }
  flush(step, crossings, work, done);
  for (std::size_t i = begin; i < end; ++i) {
    crossing_elements_[2 * i] = on_crossings_[2 * i].element;
    crossing_elements_[2 * i + 1] = on_crossings_[2 * i + 1].element;
    done.largest_penetration = std::max(done.largest_penetration, crossings[i].now.penetration);
    if (crossings[i].is_short && has_slid_far(step, crossings[i])) done.asks_for_look = true;
  }
}

ContactStep SmoothForces::add(const StepOfContacts& step, const ContactElements& pieces, const base::ThreadTeam& team,
                              FollowedContacts& contacts, model::NodalLoads& loads) {
  const std::size_t n_crossings = contacts.crossings.size();
  const std::size_t n_overlaps = contacts.overlaps.size();
  const std::size_t crossing_shares = (n_crossings + kCrossingsAtOnce - 1) / kCrossingsAtOnce;
  const std::size_t overlap_shares = (n_overlaps + kOverlapsAtOnce - 1) / kOverlapsAtOnce;
  on_crossings_.resize(2 * n_crossings);
  crossing_elements_.resize(2 * n_crossings);
  done_.assign(crossing_shares + overlap_shares, {});
  if (works_.size() < team.size()) works_.resize(team.size());
  // A thread has contacts that follow each other, most of them on the nodes that are its own; what it adds up it keeps
  // to itself until the end of a share, as threads that write side by side wait for each other.
  team.run([&](std::size_t part) {
    const auto crossing_range = team.range_of(part, crossing_shares, 1);
    for (std::size_t share = crossing_range.begin; share < crossing_range.end; ++share) {
      ContactStep done;
      const std::size_t begin = share * kCrossingsAtOnce;
      evaluate(step, contacts.crossings, begin, std::min(begin + kCrossingsAtOnce, n_crossings), works_[part], done);
      done_[share] = done;
    }
    const auto overlap_range = team.range_of(part, overlap_shares, 1);
    for (std::size_t share = overlap_range.begin; share < overlap_range.end; ++share) {
      ContactStep done;
      const std::size_t begin = share * kOverlapsAtOnce;
      for (std::size_t i = begin; i < std::min(begin + kOverlapsAtOnce, n_overlaps); ++i) {
        works_[part].overlap.evaluate(step, pieces, contacts.overlaps[i], done);
      }
      done_[crossing_shares + share] = done;
    }
  });
  // Every thread has its own nodes, and adds to them in the same order as one alone would.
  team.for_ranges(loads.force.size(), base::kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 0; i < on_crossings_.size(); ++i) {
      if (has_nodes_within(crossing_elements_[i], begin, end)) add_within(on_crossings_[i], begin, end, loads);
    }
    for (const Overlap& overlap : contacts.overlaps) {
      for (const ElementLoad& load : overlap.loads) add_within(load, begin, end, loads);
    }
  });
  ContactStep sum;
  for (const ContactStep& done : done_) sum.add(done);
  if (sum.asks_for_look) contacts.asks_for_look = true;
  return sum;
}

}  // namespace knitmech::contact
