#include "results/frame_file.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "model/places.h"
#include "results/node_values.h"
#include "results/vtk_xml.h"

namespace knitmech::results {
namespace {

using model::Frame;
using model::Model;

std::vector<Eigen::Vector3d> displacements(const Model& model, const Frame& frame) {
  std::vector<Eigen::Vector3d> vectors;
  vectors.reserve(frame.points.size());
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    vectors.emplace_back(frame.points[i] - model.nodes[i]);
  }
  return vectors;
}

std::vector<double> infinite_as_nan(std::vector<double> values) {
  for (double& value : values) {
    value = std::isinf(value) ? std::numeric_limits<double>::quiet_NaN() : value;
  }
  return values;
}

std::vector<double> tube_radii(const Model& model) {
  std::vector<double> radii(model.nodes.size());
  for (std::size_t i = 0; i < radii.size(); ++i) radii[i] = 0.5 * model.section_of(i).diameter;
  return radii;
}

void add_field_arrays(const Model& model, const Frame& frame, const TextSink& add) {
  const model::HistoryRow& row = frame.history;
  add(vtk_field_array("strain", {row.strain}));
  add(vtk_field_array("time_s", {row.time}));
  add(vtk_field_array("displacement_mm", {row.displacement}));
  add(vtk_field_array("force_top_N", {row.force_top}));
  add(vtk_field_array("force_bottom_N", {row.force_bottom}));
  for (const auto& [name, values] : kElementFields) {
    add(vtk_field_array(std::string{kElementPrefix} + name, elements_only(model, frame.*values)));
  }
}

void add_point_arrays(const Model& model, const Frame& frame, const TextSink& add) {
  for (const auto& [name, values] : kElementFields) {
    add(vtk_array(name, average_to_nodes(model, frame.broken, frame.*values)));
  }
  add(vtk_array("contact_force_N", frame.contact_force));
  add(vtk_array("contact_force_magnitude_N", magnitudes(frame.contact_force)));
  add(vtk_array("gap_mm", infinite_as_nan(frame.gap)));
  add(vtk_array("displacement_mm", displacements(model, frame)));
  add(vtk_array("rotation_wxyz", frame.rotations));
  add(vtk_array("tie_force_N", frame.tie_force));
  add(vtk_array("tube_radius_mm", tube_radii(model)));
  add(vtk_array("course", model.course));
  add(vtk_array("wale", model.wale));
  add(vtk_array("section", model.element_section));
}

/// Yarns as they are drawn: in pieces where they have broken, without pieces of a single node.
std::vector<model::ModelYarn> drawn_pieces(const Model& model, const Frame& frame) {
  std::vector<model::ModelYarn> pieces = model::pieces_of_yarns(model, frame.broken);
  if (!frame.broken.empty()) std::erase_if(pieces, [](const model::ModelYarn& piece) { return piece.n_nodes < 2; });
  return pieces;
}

std::string cell_arrays(const Model& model, const std::vector<model::ModelYarn>& pieces) {
  std::vector<std::int32_t> yarn_ids;
  yarn_ids.reserve(pieces.size());
  for (const model::ModelYarn& piece : pieces) {
    yarn_ids.push_back(model::yarn_of_node(model, static_cast<std::size_t>(piece.first_node)));
  }
  return vtk_array("yarn", yarn_ids);
}

VtkCells lines(const std::vector<model::ModelYarn>& pieces) {
  VtkCells cells;
  for (const model::ModelYarn& piece : pieces) {
    for (int i = 0; i < piece.n_nodes; ++i) {
      cells.connectivity.push_back(piece.first_node + i);
    }
    cells.ends.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
  }
  return cells;
}

void check_sizes(const Model& model, const Frame& frame) {
  const std::size_t count = model.nodes.size();
  bool fits = frame.points.size() == count && frame.rotations.size() == count && frame.contact_force.size() == count &&
              frame.tie_force.size() == count && frame.gap.size() == count;
  for (const ElementField& field : kElementFields) {
    fits = fits && (frame.*field.values).size() == count;
  }
  if (!fits) {
    throw std::invalid_argument(fmt::format("Frame {} does not belong to the model of {} nodes.", frame.index, count));
  }
}

}  // namespace

std::string frame_file_name(int index) {
  return fmt::format("frame_{:04d}.vtp", index);
}

void write_frame(const Model& model, const Frame& frame, const TextSink& add) {
  check_sizes(model, frame);
  const std::vector<model::ModelYarn> pieces = drawn_pieces(model, frame);
  write_vtk_poly_data({.field_arrays = [&](const TextSink& sink) { add_field_arrays(model, frame, sink); },
                       .points = frame.points,
                       .point_arrays = [&](const TextSink& sink) { add_point_arrays(model, frame, sink); },
                       .verts = {},
                       .lines = lines(pieces),
                       .cell_arrays = [&](const TextSink& sink) { sink(cell_arrays(model, pieces)); }},
                      add);
}

std::string frame_text(const Model& model, const Frame& frame) {
  std::string text;
  write_frame(model, frame, [&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace knitmech::results
