#include "exchange/calculix_beams.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <map>
#include <ostream>
#include <set>

#include "base/errors.h"
#include "exchange/abaqus_number.h"
#include "exchange/calculix_parts.h"
#include "exchange/calculix_section.h"
#include "exchange/constants.h"

namespace knitmech::exchange {
namespace {

using deck::caption;
using deck::line;
using Eigen::Vector3d;

constexpr const char* kFormat = "calculix-beams";

/// A path with the numbers of its points in the deck.
struct NumberedPath {
  YarnPath path;
  std::vector<int> numbers;
};

/// Without contact the courses of one yarn hang on their turning arcs; very soft ones are a mechanism.
void check_arcs(const model::Model& model) {
  const auto [softest, stiffest] = std::ranges::minmax(model.sections, {}, &yarn::Section::bending_stiffness);
  const double ratio = stiffest.bending_stiffness / softest.bending_stiffness;
  if (ratio <= kCalculixBendingRatio) return;
  throw InputError(fmt::format(
      "{}: one of the yarns bends {:.0f} times more easily than another, and without contact the courses hang on it "
      "alone, which CalculiX cannot solve; give edge_yarn.bending_stiffness of {:.3g} N mm^2 or more, or take -f "
      "abaqus",
      kFormat, ratio, stiffest.bending_stiffness / kCalculixBendingRatio));
}

std::vector<NumberedPath> numbered(const model::Model& model) {
  std::vector<NumberedPath> result;
  int next = model.n_nodes();
  for (YarnPath& path : yarn_paths(model, {.largest_turn = kBeamLargestTurn, .largest_rise = kBeamLargestRise})) {
    NumberedPath each{std::move(path), {}};
    for (const PathPoint& point : each.path.points) {
      const bool at_node = point.share == 0 || point.share == 1;
      each.numbers.push_back(at_node ? point.element + (point.share == 1 ? 2 : 1) : ++next);
    }
    result.push_back(std::move(each));
  }
  return result;
}

/// The first axis of all sections: z, or the coordinate axis that no tangent comes near. One for all, as CalculiX makes
/// a rigid piece of the node where beams with different axes meet.
Vector3d first_axis_of_all(const std::vector<NumberedPath>& paths) {
  Vector3d largest(0, 0, 0);
  for (const NumberedPath& each : paths) {
    for (const PathPoint& point : each.path.points) largest = largest.cwiseMax(point.tangent.cwiseAbs());
  }
  int axis = 2;
  if (largest[2] > kLargestFirstAxisCosine) largest.minCoeff(&axis);
  if (largest[axis] < kCalculixLargestAxisCosine) return Vector3d::Unit(axis);
  throw InputError(
      fmt::format("{}: the yarns run along x, along y and along z, so that no axis of their sections suits "
                  "all of them; take -f calculix-solids or -f abaqus",
                  kFormat));
}

void write_nodes(std::ostream& out, const std::vector<NumberedPath>& paths) {
  caption(out, "NODES: those of KnitMech under their numbers, then middles and ends within its elements");
  std::map<int, Vector3d> nodes;
  for (const NumberedPath& each : paths) {
    for (std::size_t i = 0; i < each.numbers.size(); ++i) nodes[each.numbers[i]] = each.path.points[i].point;
  }
  out << "*NODE\n";
  for (const auto& [number, point] : nodes) deck::write_node(out, number, point);
}

void write_materials(std::ostream& out, const std::vector<CalculixSquare>& squares) {
  caption(out, "MATERIALS: E, G of the squares below; no contraction across the yarn, which rigid ends would hinder");
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const std::string e = abaqus_number(squares[i].youngs_modulus), g = abaqus_number(squares[i].shear_modulus);
    line(out, "*MATERIAL, NAME=MATERIAL_{}\n*ELASTIC, TYPE=ENGINEERING CONSTANTS", i + 1);
    line(out, "{0}, {0}, {0}, 0., 0., 0., {1}, {1},\n{1}", e, g);
  }
}

std::string numbers_of(const Vector3d& vector) {
  return fmt::format("{}, {}, {}", abaqus_number(vector.x()), abaqus_number(vector.y()), abaqus_number(vector.z()));
}

/// Each element is a set of its own: the axes of its material follow the yarn.
void write_elements(std::ostream& out, const model::Model& model, const std::vector<NumberedPath>& paths,
                    const Vector3d& axis) {
  caption(out, "YARNS: three-node beams with square sections, the axes of the material along the yarn");
  const std::string first_axis = numbers_of(axis);
  std::vector<CalculixSquare> squares;
  std::ranges::transform(model.sections, std::back_inserter(squares), calculix_square);
  write_materials(out, squares);
  int number = 0;
  for (const NumberedPath& each : paths) {
    for (std::size_t i = 0; i < each.path.n_elements(); ++i) {
      const std::size_t middle = 2 * i + 1;
      const PathPoint& point = each.path.points[middle];
      const int section = model.element_section[static_cast<std::size_t>(point.element)];
      const std::string side = abaqus_number(squares[static_cast<std::size_t>(section)].side);
      line(out, "*ELEMENT, TYPE=B32R, ELSET=BEAM_{0}\n{0}, {1}, {2}, {3}", ++number, each.numbers[middle - 1],
           each.numbers[middle], each.numbers[middle + 1]);
      line(out, "*ORIENTATION, NAME=ALONG_{}\n{}, {}", number, numbers_of(point.tangent),
           numbers_of(axis.cross(point.tangent)));
      line(out, "*BEAM SECTION, ELSET=BEAM_{0}, MATERIAL=MATERIAL_{1}, ORIENTATION=ALONG_{0}, SECTION=RECT", number,
           section + 1);
      line(out, "{0}, {0}\n{1}", side, first_axis);
    }
  }
}

int number_at(const std::vector<NumberedPath>& paths, const model::ElementPlace& place) {
  const auto found = std::ranges::find_if(paths, [&](const NumberedPath& each) {
    return each.path.points.front().element <= place.element && place.element <= each.path.points.back().element;
  });
  return found->numbers[end_at(found->path, place)];
}

void write_ties(std::ostream& out, const model::Model& model, const std::vector<NumberedPath>& paths,
                const deck::GripNodes& grips) {
  if (model.ties.empty()) return;
  caption(out, "TIES: places of two yarns that move together");
  std::set<int> eliminated;
  for (const model::Tie& tie : model.ties) {
    deck::write_calculix_equations(out, {{number_at(paths, tie.first), 1}, {number_at(paths, tie.second), -1}}, grips,
                                   eliminated);
  }
}

deck::GripNodes grips_of(const std::vector<NumberedPath>& paths) {
  deck::GripNodes grips;
  for (const NumberedPath& each : paths) {
    for (std::size_t i = 0; i < each.numbers.size(); ++i) grips.add(each.path.points[i].grip, each.numbers[i]);
  }
  return grips;
}

/// Grips and step. Where rotations are held, CalculiX keeps a residual of up to 0.9 % however near the solution is.
void write_test(std::ostream& out, const model::TensileTest& test) {
  const std::string displacement = abaqus_number(test.strain * test.gauge_length);
  line(out, "*BOUNDARY\n{}, 1, 6", deck::kHeldGrip);
  if (test.grips == model::Grips::clamped) line(out, "{0}, 1, 1\n{0}, 3, 3", deck::kDrivenGrip);
  line(out, "{}, 4, 6", deck::kDrivenGrip);
  deck::StaticStep step;
  step.driven = fmt::format("{}, 2, 2, {}\n", deck::kDrivenGrip, displacement);
  step.controls = fmt::format("*CONTROLS, PARAMETERS=FIELD\n{}, {}\n", abaqus_number(kBeamResidual),
                              abaqus_number(kBeamCorrection));
  deck::write_static_step(out, step);
}

}  // namespace

void write_calculix_beams(std::ostream& out, const model::Model& model) {
  deck::check_holds(model, kFormat, false);
  check_arcs(model);
  const std::vector<NumberedPath> paths = numbered(model);
  const Vector3d axis = first_axis_of_all(paths);
  const deck::GripNodes grips = grips_of(paths);
  deck::write_calculix_heading(
      out, model,
      {"The yarns of a knitted fabric as beams WITHOUT CONTACT, for CalculiX (ccx).",
       "It is for checks of geometry, sections and loads; -f calculix-solids has the contact."});
  write_nodes(out, paths);
  write_elements(out, model, paths, axis);
  deck::write_grip_sets(out, grips);
  write_ties(out, model, paths, grips);
  write_test(out, model.test);
}

}  // namespace knitmech::exchange
