#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace knitmech::results {

/// The VTK XML format (PolyData, version 1.0) as ParaView reads it. All numbers are stored bit by bit (little endian,
/// compressed by zlib, base64), and the text is plain well-formed XML. Names must not hold any of < > & ".

/// Takes a text piece by piece: a file of a large fabric need not be in memory as a whole.
using TextSink = std::function<void(std::string_view)>;

/// A DataArray: values of `components` numbers each, one after the other.
[[nodiscard]] std::string vtk_array(const std::string& name, const std::vector<double>& values, int components = 1);
[[nodiscard]] std::string vtk_array(const std::string& name, const std::vector<std::int32_t>& values);
[[nodiscard]] std::string vtk_array(const std::string& name, const std::vector<std::int64_t>& values);
[[nodiscard]] std::string vtk_array(const std::string& name, const std::vector<Eigen::Vector3d>& vectors);
[[nodiscard]] std::string vtk_array(const std::string& name, const std::vector<Eigen::Vector4d>& vectors);

/// A DataArray for the field data, which has no number of points to go by and states its length.
[[nodiscard]] std::string vtk_field_array(const std::string& name, const std::vector<double>& values);

/// Lengths of vectors, in their unit: ParaView colours and scales by numbers.
[[nodiscard]] std::vector<double> magnitudes(const std::vector<Eigen::Vector3d>& vectors);

/// Cells that join points: the points of all cells one after the other, and where each cell ends in that row.
struct VtkCells {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> ends;
};

/// Gives DataArrays to a sink, one after the other; may be empty.
using VtkArrays = std::function<void(const TextSink& add)>;

/// What a PolyData file holds.
struct VtkPolyData {
  VtkArrays field_arrays;  ///< of the whole file
  const std::vector<Eigen::Vector3d>& points;
  VtkArrays point_arrays;  ///< one entry per point
  VtkCells verts;          ///< single points that are to be seen
  VtkCells lines;          ///< polylines
  VtkArrays cell_arrays;   ///< one entry per cell, verts first
};

/// Gives the text of a .vtp file to a sink; points are named points_mm.
void write_vtk_poly_data(const VtkPolyData& data, const TextSink& add);

}  // namespace knitmech::results
