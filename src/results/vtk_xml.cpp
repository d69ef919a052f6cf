#include "results/vtk_xml.h"

#include <fmt/core.h>

#include <bit>
#include <cstring>
#include <span>
#include <type_traits>

#include "results/base64.h"

namespace knitmech::results {
namespace {

static_assert(std::endian::native == std::endian::little, "the .vtp files are declared little endian");

template <typename Number>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<Number, double>) {
    return "Float64";
  } else if constexpr (std::is_same_v<Number, std::int64_t>) {
    return "Int64";
  } else {
    static_assert(std::is_same_v<Number, std::int32_t>);
    return "Int32";
  }
}

/// VTK's inline binary data: a 64-bit byte count and the bytes, encoded together.
template <typename Number>
std::string encoded(const std::vector<Number>& values) {
  const std::span<const std::byte> data = std::as_bytes(std::span{values});
  const std::uint64_t count = data.size();
  std::vector<std::byte> block(sizeof count + data.size());
  std::memcpy(block.data(), &count, sizeof count);
  if (!data.empty()) {
    std::memcpy(block.data() + sizeof count, data.data(), data.size());
  }
  return to_base64(block);
}

template <typename Number>
std::string array(const std::string& name, const std::vector<Number>& values, int components) {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n",
                     vtk_type<Number>(), name, components, encoded(values));
}

template <int kSize>
std::vector<double> flat(const std::vector<Eigen::Matrix<double, kSize, 1>>& vectors) {
  std::vector<double> values;
  values.reserve(vectors.size() * kSize);
  for (const auto& vector : vectors) {
    values.insert(values.end(), vector.data(), vector.data() + kSize);
  }
  return values;
}

std::string block(const char* name, const std::string& content) {
  return content.empty() ? std::string{} : fmt::format("<{0}>\n{1}</{0}>\n", name, content);
}

std::string cells_block(const char* name, const VtkCells& cells) {
  return cells.ends.empty()
             ? std::string{}
             : block(name, vtk_array("connectivity", cells.connectivity) + vtk_array("offsets", cells.ends));
}

}  // namespace

std::string vtk_array(const std::string& name, const std::vector<double>& values, int components) {
  return array(name, values, components);
}

std::string vtk_array(const std::string& name, const std::vector<std::int32_t>& values) {
  return array(name, values, 1);
}

std::string vtk_array(const std::string& name, const std::vector<std::int64_t>& values) {
  return array(name, values, 1);
}

std::string vtk_array(const std::string& name, const std::vector<Eigen::Vector3d>& vectors) {
  return array(name, flat(vectors), 3);
}

std::string vtk_array(const std::string& name, const std::vector<Eigen::Vector4d>& vectors) {
  return array(name, flat(vectors), 4);
}

std::string vtk_field_array(const std::string& name, const std::vector<double>& values) {
  return fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"binary\">{}</DataArray>\n",
                     name, values.size(), encoded(values));
}

std::vector<double> magnitudes(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> values;
  values.reserve(vectors.size());
  for (const Eigen::Vector3d& vector : vectors) {
    values.push_back(vector.norm());
  }
  return values;
}

std::string vtk_poly_data_text(const VtkPolyData& data) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n";
  text += block("FieldData", data.field_arrays);
  text += fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      data.points.size(), data.verts.ends.size(), data.lines.ends.size());
  text += block("Points", vtk_array("points_mm", data.points));
  text += cells_block("Verts", data.verts);
  text += cells_block("Lines", data.lines);
  text += block("PointData", data.point_arrays);
  text += block("CellData", data.cell_arrays);
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace knitmech::results
