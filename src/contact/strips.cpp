#include "contact/strips.h"

#include <algorithm>
#include <cmath>

#include "contact/constants.h"

namespace knitmech::contact {

namespace {

/// Share of the curvature of a parabola by which it may rise above the highest of its three values at most.
constexpr double kRiseBetweenPoints = 1.0 / 16;

/// Of n parts of a piece [mm], along the stress-free yarn.
double part_length(const SmoothStep& step, const ContactElements& pieces, CutPiece cut) {
  return step.elements.length[static_cast<std::size_t>(pieces.element_of(cut.piece))] /
         (pieces.pieces_per_element * cut.n);
}

/// \param first number of a place on the piece, in parts
PlaceRow row_of(const ContactElements& pieces, CutPiece cut, double first, double step, std::size_t n) {
  const double share = 1.0 / (pieces.pieces_per_element * cut.n);
  return {pieces.element_of(cut.piece), pieces.place_on_element(cut.piece, 0) + first * share, step * share, n};
}

double motion_of_rows(const SmoothStep& step, const ContactElements& pieces, const Overlap& overlap,
                      const Strip& strip) {
  double sum = 0;
  for (std::int32_t s = strip.first_span; s < strip.first_span + strip.n_spans; ++s) {
    const CellSpan& span = overlap.spans[static_cast<std::size_t>(s)];
    const CellRow& row = overlap.rows[static_cast<std::size_t>(span.row)];
    sum += step.motion.of(static_cast<std::size_t>(pieces.element_of(row.cells.piece)));
  }
  return sum;
}

double radii_of(const SmoothStep& step, const Strip& strip) {
  return step.elements.radius[static_cast<std::size_t>(strip.at.element)] +
         step.elements.radius[static_cast<std::size_t>(strip.other.element)];
}

/// What the cells of a strip come to, per k w.
struct StripSum {
  double energy = 0, tangent = 0;
  double weight = 0;   ///< sum of the forces' sizes
  Vector3 force{};     ///< on the other yarn
  Vector3 velocity{};  ///< of the other yarn's points, times their weights
};

}  // namespace

void OverlapWork::find_awake(const SmoothStep& step, const ContactElements& pieces, const Overlap& overlap) {
  awake_.clear();
  const double own = step.motion.of(static_cast<std::size_t>(pieces.element_of(overlap.strips.piece)));
  for (std::size_t s = 0; s < overlap.laid.size(); ++s) {
    const double moved = own + motion_of_rows(step, pieces, overlap, overlap.laid[s]);
    if (moved >= overlap.laid[s].wake) awake_.push_back({s, moved, -1e9, 0, 0, 0});
  }
}

void OverlapWork::place(const SmoothStep& step, const ContactElements& pieces, const Overlap& overlap) {
  middles_.clear();
  points_.clear();
  const auto first = overlap.laid[awake_.front().strip].number;
  const auto last = overlap.laid[awake_.back().strip].number;
  first_middle_ = static_cast<std::size_t>(first);
  middles_.add(row_of(pieces, overlap.strips, first + 0.5, 1, static_cast<std::size_t>(last - first + 1)), step.line,
               step.state);
  for (const CellRow& row : overlap.rows) {
    points_.add(row_of(pieces, row.cells, row.first, 0.5, static_cast<std::size_t>(row.n_points())), step.line,
                step.state);
  }
  if (depths_.size() < points_.size()) depths_.resize(points_.size());
}

void OverlapWork::find_pressed_cells(const SmoothStep& step, const ContactElements& pieces, const Overlap& overlap,
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
      cells_.push_back({static_cast<std::size_t>(span.row), first + p, cell_length});
      batch_.add(start, middle, end, radii);
    }
  }
  awake.n_cells = cells_.size() - awake.first_cell;
}

YarnPlace OverlapWork::place_of(const ContactElements& pieces, const CellRow& row, std::size_t point) const {
  const double part = row.first + 0.5 * static_cast<double>(point - static_cast<std::size_t>(row.first_point));
  return {pieces.element_of(row.cells.piece), pieces.place_on_element(row.cells.piece, part / row.cells.n)};
}

void OverlapWork::press(const SmoothStep& step, const ContactElements& pieces, const AwakeStrip& awake,
                        Overlap& overlap, ContactStep& done) {
  Strip& strip = overlap.laid[awake.strip];
  const double radii = radii_of(step, strip);
  const auto middle = static_cast<std::size_t>(strip.number) - first_middle_;
  const Vector3 here = middles_.position(middle);
  const auto near = std::upper_bound(
      overlap.rows.begin(), overlap.rows.end(), awake.nearest,
      [](std::size_t point, const CellRow& row) { return point < static_cast<std::size_t>(row.first_point); });
  strip.other = place_of(pieces, *(near - 1), awake.nearest);

  StripSum sum;
  for (std::size_t c = awake.first_cell; c < awake.first_cell + awake.n_cells; ++c) {
    const PressedCell& cell = cells_[c];
    const CellLoad load = batch_.load(c);
    sum.energy += cell.length * load.energy;
    sum.tangent += cell.length * load.tangent;
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = cell.length * load.force[k];
      sum.weight += weight;
      sum.force = sum.force + (weight / radii) * (points_.position(cell.point + k) - here);
      sum.velocity = sum.velocity + weight * points_.velocity(cell.point + k);
    }
  }
  if (sum.weight <= 0) {
    strip.now = {};
    const double gap = std::sqrt(radii * radii - 2 * radii * awake.greatest_depth) - radii;
    strip.wake = awake.moved + std::max(gap - kStripMargin * radii, 0.0);
    return;
  }
  const double strip_length = part_length(step, pieces, overlap.strips);
  const double scale = step.density_factor * step.law.stiffness / (radii * radii) * strip_length;
  const double size = length(sum.force);
  const double load = scale * size;
  const Vector3 normal = (1 / size) * sum.force;
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
  for (std::size_t c = awake.first_cell; c < awake.first_cell + awake.n_cells; ++c) {
    const PressedCell& cell = cells_[c];
    const CellLoad cell_load = batch_.load(c);
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = cell.length * cell_load.force[k];
      const Vector3 between = points_.position(cell.point + k) - here;
      points_.add_force(cell.point + k, (scale * weight / radii) * between + (weight / sum.weight) * friction.force,
                        on_rows_[cell.row]);
    }
  }
  middles_.add_force(middle, -1.0 * (scale * sum.force + friction.force), on_strips_);
  const double penetration = radii - std::sqrt(std::max(radii * radii - 2 * radii * awake.greatest_depth, 0.0));
  strip.now.penetration = std::max(penetration, 0.0);
  strip.now.load = load;
  strip.now.tangent = scale * sum.tangent;
  strip.now.energy = scale * sum.energy;
  strip.now.stick_stiffness = stick;
  done.largest_penetration = std::max(done.largest_penetration, strip.now.penetration);
}

void OverlapWork::give_loads(const SmoothStep& step, const ContactElements& pieces, Overlap& overlap) const {
  const auto give = [&](std::int32_t piece, const RowLoad& load) {
    const std::int32_t element = pieces.element_of(piece);
    overlap.loads.push_back({element, to_nodes(step.line.element(static_cast<std::size_t>(element)), load)});
  };
  give(overlap.strips.piece, on_strips_);
  for (std::size_t r = 0; r < overlap.rows.size(); ++r) {
    const Vector3 all = on_rows_[r].all;
    const Vector3 turns = on_rows_[r].turns_start;
    if (dot(all, all) + dot(turns, turns) > 0) give(overlap.rows[r].cells.piece, on_rows_[r]);
  }
}

void OverlapWork::evaluate(const SmoothStep& step, const ContactElements& pieces, Overlap& overlap, ContactStep& done) {
  overlap.loads.clear();
  find_awake(step, pieces, overlap);
  if (awake_.empty()) return;
  place(step, pieces, overlap);
  cells_.clear();
  batch_.clear();
  for (AwakeStrip& awake : awake_) find_pressed_cells(step, pieces, overlap, awake);
  batch_.integrate();
  on_strips_ = {};
  on_rows_.assign(overlap.rows.size(), {});
  for (const AwakeStrip& awake : awake_) press(step, pieces, awake, overlap, done);
  if (!cells_.empty()) give_loads(step, pieces, overlap);
}

}  // namespace knitmech::contact
