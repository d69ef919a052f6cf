#include "contact/yarn_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/constants.h"
#include "contact/frequency_bound.h"
#include "contact/look_for_contacts.h"
#include "contact/search_around.h"

namespace knitmech::contact {

namespace {

/// Velocity of the material at a place of a chord [mm/s].
Vector3 chord_velocity(const model::State& state, YarnPlace place) {
  const auto i = static_cast<std::size_t>(place.element);
  return (1 - place.share) * state.velocity.at(i) + place.share * state.velocity.at(i + 1);
}

/// Gives a force at a place of a chord to its nodes.
void spread_on_chord(YarnPlace place, Vector3 force, model::NodalLoads& loads) {
  const auto i = static_cast<std::size_t>(place.element);
  loads.force.add(i, (1 - place.share) * force);
  loads.force.add(i + 1, place.share * force);
}

}  // namespace

YarnContact::YarnContact(const model::Model& model)
    : elements_(make_yarn_elements(model)),
      pieces_(make_contact_elements(model)),
      centreline_(model),
      law_{model.contact_stiffness, FrictionTable(model)},
      skin_(kSkin * 2 * pieces_.largest_radius),
      motion_(model.nodes.size()),
      crossing_watch_(pieces_) {}

/// The neighbours of those elements that have moved since they were searched last. A free end that whips about has them
/// searched often, the fabric behind it seldom.
void YarnContact::search(const model::State& state) {
  std::vector<std::int32_t> due;
  std::vector<char> is_due(pieces_.n_nodes(), 0);
  const auto m = static_cast<std::size_t>(pieces_.pieces_per_element);
  for (std::size_t i = 0; i < elements_.n_nodes(); ++i) {
    if (motion_.since_search(i) < kSearchEarly * skin_) continue;
    motion_.searched(i);
    due.push_back(static_cast<std::int32_t>(i));
    std::fill_n(is_due.begin() + static_cast<std::ptrdiff_t>(i * m), std::min(m, pieces_.n_nodes() - i * m), 1);
  }
  watch_.renew(is_due,
               due.size() <= kFewElements ? search_around(due, pieces_, centreline_, skin_) : search_all(is_due));
  common_motion_ = fit_common_motion(state);
  ++searches_;
  check_crossings();
}

std::vector<ElementPair> YarnContact::search_all(const std::vector<char>& is_due) const {
  std::vector<double> bulges(pieces_.n_nodes(), 0.0);
  for (std::size_t i = 0; i < bulges.size(); ++i) {
    if (centreline_.is_smooth() && pieces_.exists[i] != 0) {
      bulges[i] = bulge(centreline_.piece_curve(pieces_, static_cast<std::int32_t>(i)));
    }
  }
  return find_neighbours(pieces_, centreline_.piece_positions(pieces_), bulges, skin_, is_due);
}

void YarnContact::check_crossings() {
  const CrossingReport report = crossing_watch_.update(centreline_.piece_positions(pieces_), watch_.pairs());
  ++crossing_checks_;
  motion_.checked();
  ravelled_.insert(ravelled_.end(), report.ravelled.begin(), report.ravelled.end());
  if (report.lost.empty() || lost_) return;
  const CrossingLoss& loss = report.lost.front();
  lost_ = LostCrossing{pieces_.element_of(loss.first), pieces_.element_of(loss.second), loss.place};
}

void YarnContact::look() {
  motion_.set_bounds(0.5 * skin_, kCheckCrossings * 2 * pieces_.largest_radius);
  if (centreline_.is_smooth()) {
    look_for_contacts(elements_, pieces_, centreline_, motion_, watch_, followed_);
  } else {
    look_at_chords(pieces_, centreline_.node_position(), motion_, watch_, near_);
  }
}

void YarnContact::add_forces(const model::State& state, double step, model::NodalLoads& loads,
                             const base::ThreadTeam& team) {
  centreline_.update(state, common_motion_, step, team);
  // Two yarns in contact are at most a few radii apart along y; as much of the common stretch is between them.
  const double stretch = std::abs(common_motion_.rate) * step;
  motion_.add(centreline_.moved(), stretch * (2 * pieces_.largest_radius + skin_), team);
  if (motion_.has_reached_a_bound() || followed_.asks_for_look) {
    if (motion_.largest_since_search() >= 0.5 * skin_) search(state);
    if (motion_.largest_since_check() >= kCheckCrossings * 2 * pieces_.largest_radius) check_crossings();
    look();
  }
  if (centreline_.is_smooth()) {
    const ContactStep done = smooth_forces_.add({elements_, centreline_, law_, motion_, state, step, density_factor()},
                                                pieces_, team, followed_, loads);
    if (!lost_) lost_ = done.lost;
    friction_loss_ += done.friction_loss;
    largest_penetration_ = done.largest_penetration;
  } else {
    find_on_chords(state, step, loads);
  }
}

void YarnContact::find_on_chords(const model::State& state, double step, model::NodalLoads& loads) {
  std::swap(chords_, chords_before_);
  find_chord_contacts(elements_, motion_, centreline_.node_position(), law_.stiffness, near_, chords_);
  recall(chords_before_, chords_);
  largest_penetration_ = 0;
  for (ChordContact& contact : chords_) {
    ContactPoint& point = contact.point;
    if (dot(point.stick.normal, point.normal) < 0 && !lost_) {
      lost_ = LostCrossing{point.first.element, point.second.element,
                           centreline_.node_position().at(static_cast<std::size_t>(point.first.element))};
    }
    const Vector3 motion = step * (chord_velocity(state, point.second) - chord_velocity(state, point.first));
    const double friction = law_.friction.between(elements_.section[static_cast<std::size_t>(point.first.element)],
                                                  elements_.section[static_cast<std::size_t>(point.second.element)]);
    const FrictionStep stick =
        friction_step(point.stick, point.normal, motion, friction * point.load, point.stick_stiffness);
    friction_loss_ += stick.loss;
    const Vector3 force = point.load * point.normal + stick.force;
    spread_on_chord(point.second, force, loads);
    spread_on_chord(point.first, -1.0 * force, loads);
    largest_penetration_ = std::max(largest_penetration_, point.penetration);
  }
}

double YarnContact::energy() const {
  double energy = 0;
  for (const ContactPoint& point : points()) energy += point.energy + point.stick_energy();
  return energy;
}

std::vector<ContactPoint> YarnContact::points() const {
  if (centreline_.is_smooth()) return contact_points(followed_);
  std::vector<ContactPoint> points;
  for (const ChordContact& contact : chords_) points.push_back(contact.point);
  return points;
}

std::vector<double> YarnContact::frequency_rows(const std::vector<double>& mass,
                                                const std::vector<double>& rotary) const {
  FrequencyBound bound(mass, rotary);
  for (const ContactPoint& point : points()) {
    bound.add({point.first, centreline_.hold(point.first)}, {point.second, centreline_.hold(point.second)},
              std::max(point.tangent, point.stick_stiffness));
  }
  return bound.rows();
}

}  // namespace knitmech::contact
