#include "model/build_from_file.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "curves/smooth_line.h"
#include "model/constants.h"
#include "model/places.h"

namespace knitmech::model {
namespace {

using curves::AlongLine;
using Eigen::Vector3d;

/// Takes coordinates of the file to those of the fabric.
Eigen::Matrix3d axes_matrix(FileAxes axes) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const auto rows = [](const Vector3d& course, const Vector3d& wale) {
    Eigen::Matrix3d matrix;
    matrix << course.transpose(), wale.transpose(), course.cross(wale).transpose();
    return matrix;
  };
  switch (axes) {
    case FileAxes::xyz:
      return rows(x, y);
    case FileAxes::yzx:
      return rows(y, z);
    case FileAxes::zxy:
      return rows(z, x);
    case FileAxes::xzy:
      return rows(x, z);
    case FileAxes::yxz:
      return rows(y, x);
    case FileAxes::zyx:
      break;
  }
  return rows(z, y);
}

/// The yarns of the file as smooth lines [mm] in the axes of the fabric.
std::vector<AlongLine> lines_of(const Case& input) {
  const curves::YarnLines& file = input.fabric.yarn_file->lines;
  const Eigen::Matrix3d to_fabric = input.fabric.file_unit.value_or(1) * axes_matrix(input.fabric.file_axes);
  std::vector<AlongLine> lines;
  for (std::size_t i = 0; i < file.yarns.size(); ++i) {
    curves::YarnLine yarn = file.yarns[i];
    for (Vector3d& point : yarn.points) point = to_fabric * point;
    try {
      lines.emplace_back(curves::smooth_line(yarn, file.kind));
    } catch (const InputError& error) {
      throw InputError(fmt::format("fabric.yarns: yarn {}: {}", i + 1, error.what()));
    }
  }
  return lines;
}

/// Pieces of a line on which y rises or falls, at least one; what goes back by less than a height is no turn.
int rises_and_falls(const AlongLine& line, double height) {
  const auto n_samples = static_cast<int>(std::clamp(4 * line.length() / height, 16.0, 1e6));
  int turns = 0;
  int direction = 0;  // 0: not known yet
  double low = line.at(0).point.y();
  double high = low;
  for (int i = 1; i <= n_samples; ++i) {
    const double y = line.at(line.length() * i / n_samples).point.y();
    low = std::min(low, y);
    high = std::max(high, y);
    const bool rises = direction <= 0 && y > low + height;
    const bool falls = direction >= 0 && y < high - height;
    if (!rises && !falls) continue;
    if (direction != 0) ++turns;
    direction = rises ? 1 : -1;
    low = high = y;
  }
  return turns + 1;
}

double half_stitch_of(const std::vector<AlongLine>& lines, double diameter) {
  double length = 0;
  int pieces = 0;
  for (const AlongLine& line : lines) {
    length += line.length();
    pieces += rises_and_falls(line, kTurnHeight * diameter);
  }
  return length / pieces;
}

void check_lengths(const std::vector<AlongLine>& lines, double diameter) {
  const auto shortest = std::ranges::min_element(lines, {}, &AlongLine::length);
  if (shortest->length() >= diameter) return;
  throw InputError(
      fmt::format("fabric.yarns: yarn {} is {:.3g} mm long, less than it is thick (yarn.diameter = {:.3g} mm); "
                  "fabric.file_unit says how long a length of 1 in the file is",
                  shortest - lines.begin() + 1, shortest->length(), diameter));
}

/// Cuts yarns into nodes.
class Cutter {
 public:
  Cutter(const std::vector<AlongLine>& lines, double element_length) : lines_(lines), element_length_(element_length) {
    double elements = 0;
    for (const AlongLine& line : lines) elements += line.length() / element_length;
    if (elements <= kMostElements) return;
    throw InputError(fmt::format(
        "fabric.element_length of {:.3g} mm cuts the yarns into {:.0f} elements, but at most {:.0f} are possible",
        element_length, elements, kMostElements));
  }

  [[nodiscard]] Model model() const {
    Model model;
    model.has_stitches = false;
    for (const AlongLine& line : lines_) add_yarn(model, line);
    model.element_section.assign(model.nodes.size(), 0);
    model.wale.assign(model.nodes.size(), knit::kNoWale);
    return model;
  }

 private:
  void add_yarn(Model& model, const AlongLine& line) const {
    const int n_elements = std::max(kFewestElements, static_cast<int>(std::lround(line.length() / element_length_)));
    const double step = line.length() / n_elements;
    const int yarn = static_cast<int>(model.yarns.size());
    model.yarns.push_back({.first_node = model.n_nodes(), .n_nodes = n_elements + 1});
    for (int i = 0; i <= n_elements; ++i) {
      const AlongLine::Place node = line.at(i * step);
      model.nodes.push_back(node.point);
      model.tangents.push_back(node.tangent);
      model.middles.push_back(i < n_elements ? line.at((i + 0.5) * step).point : node.point);
      model.arc_length.push_back(i * step);
      model.course.push_back(yarn);
    }
  }

  const std::vector<AlongLine>& lines_;
  double element_length_;
};

void check_turns(const Model& model, double element_length) {
  for (std::size_t i = 0; i + 1 < model.nodes.size(); ++i) {
    const double cosine = std::clamp(model.tangents[i].dot(model.tangents[i + 1]), -1.0, 1.0);
    const double turn = std::acos(cosine) * 180 / std::numbers::pi;
    if (turn <= kLargestTurn || model.course[i] != model.course[i + 1]) continue;
    const Vector3d& place = model.middles[i];
    throw InputError(fmt::format(
        "fabric.element_length of {:.3g} mm is too long for the bends: yarn {} turns by {:.0f} degrees within one "
        "element near ({:.4g}, {:.4g}, {:.4g}) mm; make it less than half as long, if the yarn has no kink there",
        element_length, model.course[i] + 1, turn, place.x(), place.y(), place.z()));
  }
}

/// Where a row of straight pieces shows the yarns as the contact sees them.
std::vector<std::vector<Vector3d>> drawn(const Case& input, const Model& model, const std::vector<AlongLine>& lines) {
  const bool smooth = input.contact.centreline == Centreline::smooth;
  std::vector<std::vector<Vector3d>> yarns;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int n_pieces = (model.yarns[i].n_nodes - 1) * (smooth ? kClearancePieces : 1);
    yarns.emplace_back();
    for (int k = 0; k <= n_pieces; ++k) {
      yarns.back().push_back(lines[i].at(lines[i].length() * k / n_pieces).point);
    }
  }
  return yarns;
}

void check_clearance(const Case& input, const Model& model, const std::vector<AlongLine>& lines) {
  const double diameter = input.yarn.diameter;
  const auto nearest = curves::nearest_yarns(drawn(input, model, lines), diameter, (1 - kFileOverlap) * diameter);
  if (!nearest) return;
  const double overlap = diameter - nearest->distance;
  throw InputError(fmt::format(
      "the yarns overlap by {:.3g} mm, {:.2g} % of yarn.diameter = {:.4g} mm, where yarn {} at {:.4g} mm and yarn {} "
      "at {:.4g} mm of their lengths pass near ({:.4g}, {:.4g}, {:.4g}) mm; their centrelines are {:.4g} mm apart, so "
      "a thinner yarn would fit, or a larger fabric.file_unit, or a geometry that leaves more room",
      overlap, 100 * overlap / diameter, diameter, nearest->a.yarn + 1, nearest->a.arc_length, nearest->b.yarn + 1,
      nearest->b.arc_length, nearest->point.x(), nearest->point.y(), nearest->point.z(), nearest->distance));
}

void add_grips(Model& model, double depth) {
  const auto [lowest, highest] = std::minmax_element(model.nodes.begin(), model.nodes.end(),
                                                     [](const auto& a, const auto& b) { return a.y() < b.y(); });
  if (2 * depth >= highest->y() - lowest->y()) {
    throw InputError(fmt::format(
        "fabric.grip_depth of {:.3g} mm at both ends leaves nothing to stretch: the fabric is {:.3g} mm high along y; "
        "fabric.file_axes says which axis of the file that is",
        depth, highest->y() - lowest->y()));
  }
  for (int i = 0; i < model.n_nodes(); ++i) {
    const double y = model.nodes[static_cast<std::size_t>(i)].y();
    if (y <= lowest->y() + depth) model.node_sets[kBottomFeet].push_back(i);
    if (y >= highest->y() - depth) model.node_sets[kTopHeads].push_back(i);
  }
}

void add_edges(Model& model) {
  for (const ModelYarn& yarn : model.yarns) {
    const int last = yarn.first_node + yarn.n_nodes - 1;
    const bool runs_left =
        model.nodes[static_cast<std::size_t>(last)].x() < model.nodes[static_cast<std::size_t>(yarn.first_node)].x();
    model.node_sets[kLeftEdge].push_back(runs_left ? last : yarn.first_node);
    model.node_sets[kRightEdge].push_back(runs_left ? yarn.first_node : last);
  }
}

double element_length_in(const Case& input, double half_stitch) {
  return input.fabric.element_length.value_or(half_stitch / kElementsPerHalfStitch);
}

}  // namespace

Model model_from_file(const Case& input) {
  const double diameter = input.yarn.diameter;
  const std::vector<AlongLine> lines = lines_of(input);
  check_lengths(lines, diameter);
  const double half_stitch = half_stitch_of(lines, diameter);
  const double element_length = element_length_in(input, half_stitch);
  Model model = Cutter(lines, element_length).model();
  model.half_stitch_length = half_stitch;
  add_grips(model, grip_depth_of(input, model));
  add_edges(model);
  check_turns(model, element_length);
  check_clearance(input, model, lines);
  return model;
}

double grip_depth_of(const Case& input, const Model& model) {
  const double element = element_length_in(input, model.half_stitch_length);
  return input.fabric.grip_depth.value_or(std::max(input.yarn.diameter, element / 2));
}

std::optional<curves::NearestYarns> nearest_in(const Case& input, const Model& model, double reach) {
  return curves::nearest_yarns(drawn(input, model, lines_of(input)), input.yarn.diameter, reach);
}

}  // namespace knitmech::model
