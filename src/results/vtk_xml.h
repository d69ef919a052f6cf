#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace knitmech::results {

/// The VTK XML format (PolyData, version 1.0) as ParaView reads it. All numbers are stored bit by bit (little endian,
/// base64), and the text is plain well-formed XML. Names must not hold any of < > & ".

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

/// What a PolyData file holds. The texts are made of DataArrays and may be empty.
struct VtkPolyData {
  std::string field_arrays;  ///< of the whole file
  std::vector<Eigen::Vector3d> points;
  std::string point_arrays;  ///< one entry per point
  VtkCells verts;            ///< single points that are to be seen
  VtkCells lines;            ///< polylines
  std::string cell_arrays;   ///< one entry per cell, verts first
};

/// The text of a .vtp file; points are named points_mm.
[[nodiscard]] std::string vtk_poly_data_text(const VtkPolyData& data);

}  // namespace knitmech::results
