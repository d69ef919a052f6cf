#include "contact/yarn_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/blocks.h"
#include "contact/constants.h"
#include "contact/look_for_contacts.h"
#include "contact/search_around.h"
#include "contact/watch_constants.h"

namespace knitmech::contact {

YarnContact::YarnContact(const model::Model& model)
    : elements_(make_yarn_elements(model)),
      pieces_(std::make_shared<const ContactElements>(make_contact_elements(model))),
      centreline_(model),
      law_{model.contact_stiffness, FrictionTable(model)},
      skin_(kSkin * 2 * pieces_->largest_radius),
      motion_(model.nodes.size()),
      crossing_watch_(pieces_) {
  motion_.set_limits(0.5 * skin_, kCheckCrossings * 2 * pieces_->largest_radius);
}

/// The neighbours of those elements that have moved since they were searched last. A free end that whips about has them
/// searched often, the fabric behind it seldom.
void YarnContact::search(const model::State& state, const base::ThreadTeam& team) {
  std::vector<std::int32_t> due;
  std::vector<char> is_due(pieces_->n_nodes(), 0);
  const auto m = static_cast<std::size_t>(pieces_->pieces_per_element);
  for (std::size_t i = 0; i < elements_.n_nodes(); ++i) {
    if (motion_.since_search(i) < kSearchEarly * skin_) continue;
    motion_.searched(i);
    due.push_back(static_cast<std::int32_t>(i));
    std::fill_n(is_due.begin() + static_cast<std::ptrdiff_t>(i * m), std::min(m, pieces_->n_nodes() - i * m), 1);
  }
  const model::VectorArray positions = centreline_.piece_positions(*pieces_);
  watch_.renew(is_due, due.size() <= kFewElements ? search_around(due, *pieces_, centreline_, skin_)
                                                  : search_all(positions, is_due, team));
  common_motion_ = fit_common_motion(state);
  ++searches_;
  check_crossings(positions, team);
}

std::vector<ElementPair> YarnContact::search_all(const model::VectorArray& positions, const std::vector<char>& is_due,
                                                 const base::ThreadTeam& team) const {
  std::vector<double> bulges(elements_.n_nodes(), 0.0);
  const std::int32_t m = pieces_->pieces_per_element;
  const auto bulge_of = [&](std::size_t element) {
    double largest = 0;
    for (std::int32_t k = 0; k < m; ++k) {
      const std::int32_t piece = static_cast<std::int32_t>(element) * m + k;
      largest = std::max(largest, bulge(centreline_.piece_curve(*pieces_, piece)));
    }
    return largest;
  };
  team.for_ranges(bulges.size(), base::kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (centreline_.is_smooth() && elements_.exists[i] != 0) bulges[i] = bulge_of(i);
    }
  });
  return find_neighbours(*pieces_, positions, bulges, skin_, is_due, nullptr, team);
}

void YarnContact::check_crossings(const base::ThreadTeam& team) {
  check_crossings(centreline_.piece_positions(*pieces_), team);
}

void YarnContact::check_crossings(const model::VectorArray& positions, const base::ThreadTeam& team) {
  const double motion = (2 * kCheckCrossings + kBeyondCheck) * 2 * pieces_->largest_radius;
  const CrossingReport report = crossing_watch_.update(positions, watch_.pairs(), motion, team);
  ++crossing_checks_;
  motion_.checked();
  watch_.wake_all();
  ravelled_.insert(ravelled_.end(), report.ravelled.begin(), report.ravelled.end());
  if (report.lost.empty() || lost_) return;
  const CrossingLoss& loss = report.lost.front();
  lost_ = LostCrossing{pieces_->element_of(loss.first), pieces_->element_of(loss.second), loss.place};
}

void YarnContact::look(const base::ThreadTeam& team) {
  if (centreline_.is_smooth()) {
    look_for_contacts(elements_, *pieces_, centreline_, motion_, watch_, team, followed_);
  } else {
    look_at_chords(*pieces_, centreline_.node_position(), motion_, watch_, team, near_);
  }
}

void YarnContact::add_forces(const model::State& state, double step, model::NodalLoads& loads,
                             const base::ThreadTeam& team) {
  centreline_.update(state, common_motion_, step, team);
  // Two yarns in contact are at most a few radii apart along y; as much of the common stretch is between them.
  const double stretch = std::abs(common_motion_.rate) * step;
  motion_.add(centreline_.moved(), centreline_.turned(), stretch * (2 * pieces_->largest_radius + skin_), team);
  if (motion_.has_reached_a_bound() || followed_.asks_for_look) {
    if (motion_.largest_since_search() >= 0.5 * skin_) search(state, team);
    if (motion_.largest_since_check() >= kCheckCrossings * 2 * pieces_->largest_radius) check_crossings(team);
    look(team);
  }
  const StepOfContacts now{elements_, centreline_, law_, motion_, state, step, density_factor()};
  const ContactStep done = centreline_.is_smooth() ? smooth_forces_.add(now, *pieces_, team, followed_, loads)
                                                   : chord_forces_.add(now, team, near_, loads);
  friction_loss_ += done.friction_loss;
  largest_penetration_ = done.largest_penetration;
  if (!lost_) lost_ = done.lost;
}

double YarnContact::energy() const {
  double energy = 0;
  for (const ContactPoint& point : points()) energy += point.energy + point.stick_energy();
  return energy;
}

std::vector<ContactPoint> YarnContact::points() const {
  if (centreline_.is_smooth()) return contact_points(followed_);
  std::vector<ContactPoint> points;
  for (const ChordContact& contact : chord_forces_.contacts()) points.push_back(contact.point);
  return points;
}

Springs YarnContact::springs() const {
  Springs springs;
  const auto add = [&](YarnPlace first, YarnPlace second, double tangent, double stick_stiffness) {
    springs.add({first, centreline_.hold(first)}, {second, centreline_.hold(second)},
                std::max(tangent, stick_stiffness));
  };
  const auto add_if_loaded = [&](YarnPlace first, YarnPlace second, const ContactState& now) {
    if (now.load > 0) add(first, second, now.tangent, now.stick_stiffness);
  };
  for (const Crossing& crossing : followed_.crossings) add_if_loaded(crossing.first, crossing.second, crossing.now);
  for (const Overlap& overlap : followed_.overlaps) {
    for (const Strip& strip : overlap.laid) add_if_loaded(strip.at, strip.other, strip.now);
  }
  for (const ChordContact& contact : chord_forces_.contacts()) {
    add(contact.point.first, contact.point.second, contact.point.tangent, contact.point.stick_stiffness);
  }
  return springs;
}

}  // namespace knitmech::contact
