#include "exchange/write_vtp.h"

#include <cstdint>

#include "exchange/yarn_samples.h"
#include "results/vtk_xml.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using model::CurvePiece;
using model::Model;

/// The pieces as at the start, each at the number of its first node.
std::vector<CurvePiece> start_by_node(const Model& model) {
  std::vector<CurvePiece> by_node(model.nodes.size());
  for (const CurvePiece& piece : model::yarn_curves(model)) by_node[static_cast<std::size_t>(piece.node)] = piece;
  return by_node;
}

/// Points of all lines with their data.
struct Lines {
  std::vector<Vector3d> points, displacements;
  std::vector<double> radii, arc_lengths;
  std::vector<std::int32_t> yarns, courses, wales;
  results::VtkCells cells;

  void add_point(const Model& model, const CurvePiece& piece, const CurvePiece& start, const YarnSample& sample) {
    const auto node = static_cast<std::size_t>(piece.node);
    const std::size_t at_or_before = sample.parameter < 1 ? node : node + 1;
    const double u = sample.parameter;
    cells.connectivity.push_back(static_cast<std::int64_t>(points.size()));
    points.push_back(sample.point);
    displacements.emplace_back(sample.point - start.point(u));
    radii.push_back(piece.radius);
    arc_lengths.push_back((1 - u) * model.arc_length[node] + u * model.arc_length[node + 1]);
    yarns.push_back(piece.yarn);
    courses.push_back(model.course[at_or_before]);
    wales.push_back(model.wale[at_or_before]);
  }
};

Lines lines_of(const Model& model, const std::vector<CurvePiece>& pieces) {
  const std::vector<CurvePiece> start = start_by_node(model);
  Lines lines;
  for (const YarnRow row : yarn_rows(pieces)) {
    for (const YarnSample& sample : samples_of(row)) {
      const CurvePiece& piece = row[sample.piece];
      lines.add_point(model, piece, start[static_cast<std::size_t>(piece.node)], sample);
    }
    lines.cells.ends.push_back(static_cast<std::int64_t>(lines.points.size()));
  }
  return lines;
}

void add_point_arrays(const Lines& lines, const results::TextSink& add) {
  using results::vtk_array;
  add(vtk_array("tube_radius_mm", lines.radii));
  add(vtk_array("yarn", lines.yarns));
  add(vtk_array("course", lines.courses));
  add(vtk_array("wale", lines.wales));
  add(vtk_array("arc_length_mm", lines.arc_lengths));
  add(vtk_array("displacement_mm", lines.displacements));
}

}  // namespace

std::string vtp_text(const Model& model, const std::vector<CurvePiece>& pieces, double strain) {
  const Lines lines = lines_of(model, pieces);
  std::string text;
  results::write_vtk_poly_data(
      {.field_arrays = [&](const results::TextSink& sink) { sink(results::vtk_field_array("strain", {strain})); },
       .points = lines.points,
       .point_arrays = [&](const results::TextSink& sink) { add_point_arrays(lines, sink); },
       .verts = {},
       .lines = lines.cells,
       .cell_arrays = {}},
      [&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace knitmech::exchange
