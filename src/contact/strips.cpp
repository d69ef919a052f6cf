#include "contact/strips.h"

#include <algorithm>
#include <cmath>

#include "contact/constants.h"

namespace knitmech::contact {

namespace {

/// Share of the curvature of a parabola by which it may rise above the highest of its three values at most.
constexpr double kRiseBetweenPoints = 1.0 / 16;

/// Of n parts of a piece [mm], along the stress-free yarn.
double part_length(const StepOfContacts& step, const ContactElements& pieces, CutPiece cut) {
  return step.elements.length[static_cast<std::size_t>(pieces.element_of(cut.piece))] /
         (pieces.pieces_per_element * cut.n);
}

/// \param first number of a place on the piece, in parts
PlaceRow row_of(const ContactElements& pieces, CutPiece cut, double first, double step, std::size_t n) {
  const double share = 1.0 / (pieces.pieces_per_element * cut.n);
  return {pieces.element_of(cut.piece), pieces.place_on_element(cut.piece, 0) + first * share, step * share, n};
}

/// Of the elements that an overlap has to do with, summed up: no two points of it have come nearer by more.
double motion_of(const StepOfContacts& step, const ContactElements& pieces, const Overlap& overlap) {
  double sum = step.motion.of(static_cast<std::size_t>(pieces.element_of(overlap.strips.piece)));
  for (const CellRow& row : overlap.rows) {
    sum += step.motion.of(static_cast<std::size_t>(pieces.element_of(row.cells.piece)));
  }
  return sum;
}

double radii_of(const StepOfContacts& step, const Strip& strip) {
  return step.elements.radius[static_cast<std::size_t>(strip.at.element)] +
         step.elements.radius[static_cast<std::size_t>(strip.other.element)];
}

/// The place of a point of the cells.
YarnPlace place_of(const ContactElements& pieces, const Overlap& overlap, std::size_t point) {
  const auto after = std::upper_bound(
      overlap.rows.begin(), overlap.rows.end(), point,
      [](std::size_t at, const CellRow& row) { return at < static_cast<std::size_t>(row.first_point); });
  const CellRow& row = *(after - 1);
  const double part = row.first + 0.5 * static_cast<double>(point - static_cast<std::size_t>(row.first_point));
  return {pieces.element_of(row.cells.piece), pieces.place_on_element(row.cells.piece, part / row.cells.n)};
}

}  // namespace

void OverlapWork::find_awake(const Overlap& overlap, double moved) {
  awake_.clear();
  for (std::size_t s = 0; s < overlap.laid.size(); ++s) {
    if (moved >= overlap.laid[s].wake) awake_.push_back({s, -1e9, 0, 0, 0});
  }
}

void OverlapWork::place(const StepOfContacts& step, const ContactElements& pieces, const Overlap& overlap) {
  middles_.clear();
  points_.clear();
  const auto first = overlap.laid[awake_.front().strip].number;
  const auto last = overlap.laid[awake_.back().strip].number;
  first_middle_ = static_cast<std::size_t>(first);
  middles_.add(row_of(pieces, overlap.strips, first + 0.5, 1, static_cast<std::size_t>(last - first) + 1), step.line,
               step.state);
  for (const CellRow& row : overlap.rows) {
    points_.add(row_of(pieces, row.cells, row.first, 0.5, static_cast<std::size_t>(row.n_points())), step.line,
                step.state);
  }
  if (depths_.size() < points_.size() + kPointsAtOnce) {
    depths_.resize(points_.size() + kPointsAtOnce);
    weights_.resize(points_.size() + kPointsAtOnce);
  }
}

void OverlapWork::find_pressed_cells(const StepOfContacts& step, const ContactElements& pieces, const Overlap& overlap,
                                     AwakeStrip& awake) {
  const Strip& strip = overlap.laid[awake.strip];
  const double radii = radii_of(step, strip);
  const Vector3 here = middles_.position(static_cast<std::size_t>(strip.number) - first_middle_);
  awake.first_cell = cells_.size();
  for (std::int32_t s = strip.first_span; s < strip.first_span + strip.n_spans; ++s) {
    const CellSpan& span = overlap.spans[static_cast<std::size_t>(s)];
    const auto first = static_cast<std::size_t>(span.first_point);
    const auto n_points = 2 * static_cast<std::size_t>(span.n_cells) + 1;
    const double cell_length = part_length(step, pieces, overlap.rows[static_cast<std::size_t>(span.row)].cells);
    points_.depths_below(here, radii, first, n_points, depths_.data());
    for (std::size_t p = 0; p < n_points; ++p) {
      if (depths_[p] <= awake.greatest_depth) continue;
      awake.greatest_depth = depths_[p];
      awake.nearest = first + p;
    }
    for (std::size_t p = 0; p + 2 < n_points; p += 2) {
      const double start = depths_[p];
      const double middle = depths_[p + 1];
      const double end = depths_[p + 2];
      const double highest = std::max({start, middle, end});
      if (highest + kRiseBetweenPoints * std::abs(2 * (start + end - 2 * middle)) <= 0) continue;
      cells_.push_back({first + p, cell_length});
      batch_.add(start, middle, end, radii);
    }
  }
  awake.n_cells = cells_.size() - awake.first_cell;
}

/// Sets the weights of the points from the first to the last one that presses on a strip, per k w.
OverlapWork::PointRange OverlapWork::weigh(const AwakeStrip& awake) {
  const auto first_cell = cells_.begin() + static_cast<std::ptrdiff_t>(awake.first_cell);
  const auto last_cell = first_cell + static_cast<std::ptrdiff_t>(awake.n_cells) - 1;
  const PointRange range{first_cell->point, last_cell->point + 3 - first_cell->point};
  std::fill_n(weights_.begin() + static_cast<std::ptrdiff_t>(range.first), rounded_up(range.n), 0.0);
  for (std::size_t c = awake.first_cell; c < awake.first_cell + awake.n_cells; ++c) {
    const PressedCell& cell = cells_[c];
    const CellLoad load = batch_.load(c);
    for (std::size_t k = 0; k < 3; ++k) weights_[cell.point + k] += cell.length * load.force[k];
  }
  return range;
}

void OverlapWork::press(const StepOfContacts& step, const ContactElements& pieces, const AwakeStrip& awake,
                        double moved, Overlap& overlap, ContactStep& done) {
  Strip& strip = overlap.laid[awake.strip];
  const double radii = radii_of(step, strip);
  const auto middle = static_cast<std::size_t>(strip.number) - first_middle_;
  const Vector3 here = middles_.position(middle);
  strip.other = place_of(pieces, overlap, awake.nearest);
  PointRange pressed{};
  PlacedPoints::WeightedSum sum;
  if (awake.n_cells > 0) {
    pressed = weigh(awake);
    sum = points_.sum(pressed.first, pressed.n, &weights_[pressed.first]);
  }
  if (sum.weight <= 0) {
    strip.now = {};
    const double gap = std::sqrt(radii * radii - 2 * radii * awake.greatest_depth) - radii;
    strip.wake = moved + std::max(gap - kStripMargin * radii, 0.0);
    return;
  }
  const double strip_length = part_length(step, pieces, overlap.strips);
  const double scale = step.density_factor * step.law.stiffness / (radii * radii) * strip_length;
  const Vector3 force = (1 / radii) * (sum.position - sum.weight * here);
  const double size = length(force);
  const double load = scale * size;
  const Vector3 normal = (1 / size) * force;
  const auto a = static_cast<std::size_t>(strip.at.element);
  const auto b = static_cast<std::size_t>(strip.other.element);
  if (dot(strip.now.stick.normal, normal) < 0 && !done.lost) {
    done.lost = LostCrossing{strip.at.element, strip.other.element, step.line.node_position().at(a)};
  }
  const double stick = kStripStickStiffness * step.law.stiffness * strip_length / radii;
  const double limit = load * step.law.friction.between(step.elements.section[a], step.elements.section[b]);
  const Vector3 slip = step.length * ((1 / sum.weight) * sum.velocity - middles_.velocity(middle));
  const FrictionStep friction = friction_step(strip.now.stick, normal, slip, limit, stick);
  done.friction_loss += friction.loss;
  points_.add_forces(pressed.first, pressed.n, &weights_[pressed.first], scale / radii, here,
                     (1 / sum.weight) * friction.force);
  middles_.add_force(middle, -1.0 * (scale * force + friction.force));

  double energy = 0;
  double tangent = 0;
  for (std::size_t c = awake.first_cell; c < awake.first_cell + awake.n_cells; ++c) {
    energy += cells_[c].length * batch_.load(c).energy;
    tangent += cells_[c].length * batch_.load(c).tangent;
  }
  const double penetration = radii - std::sqrt(std::max(radii * radii - 2 * radii * awake.greatest_depth, 0.0));
  strip.now.penetration = std::max(penetration, 0.0);
  strip.now.load = load;
  strip.now.tangent = scale * tangent;
  strip.now.energy = scale * energy;
  strip.now.stick_stiffness = stick;
  done.largest_penetration = std::max(done.largest_penetration, strip.now.penetration);
}

void OverlapWork::give_loads(const StepOfContacts& step, const ContactElements& pieces, Overlap& overlap) const {
  const auto give = [&](std::int32_t piece, const PlacedPoints& points, std::size_t first, std::size_t n) {
    const std::int32_t element = pieces.element_of(piece);
    overlap.loads.push_back({element, points.to_nodes(step.line.element(static_cast<std::size_t>(element)), first, n)});
  };
  give(overlap.strips.piece, middles_, 0, middles_.size());
  for (const CellRow& row : overlap.rows) {
    give(row.cells.piece, points_, static_cast<std::size_t>(row.first_point), static_cast<std::size_t>(row.n_points()));
  }
}

void OverlapWork::evaluate(const StepOfContacts& step, const ContactElements& pieces, Overlap& overlap,
                           ContactStep& done) {
  overlap.loads.clear();
  const double moved = motion_of(step, pieces, overlap);
  find_awake(overlap, moved);
  if (awake_.empty()) return;
  place(step, pieces, overlap);
  cells_.clear();
  batch_.clear();
  for (AwakeStrip& awake : awake_) find_pressed_cells(step, pieces, overlap, awake);
  batch_.integrate();
  for (const AwakeStrip& awake : awake_) press(step, pieces, awake, moved, overlap, done);
  if (!cells_.empty()) give_loads(step, pieces, overlap);
}

}  // namespace knitmech::contact
