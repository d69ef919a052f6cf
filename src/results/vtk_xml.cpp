#include "results/vtk_xml.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>
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

/// Bytes that are compressed at a time. Larger: slightly smaller files, more memory.
constexpr std::size_t kBlock = 1U << 20U;

/// Fast rather than small: the digits of measured numbers hardly shrink however long one tries.
constexpr int kCompressionLevel = Z_BEST_SPEED;

/// Appends what zlib makes of some bytes. \return its size
std::size_t append_compressed(std::span<const std::byte> bytes, std::vector<std::byte>& all) {
  const std::size_t before = all.size();
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  all.resize(before + size);
  const int code =
      compress2(reinterpret_cast<Bytef*>(all.data() + before), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), kCompressionLevel);
  if (code != Z_OK) throw std::bad_alloc();  // the only error that is left
  all.resize(before + size);
  return size;
}

/// VTK's inline compressed data: number of blocks, size of all but the last, size of the last if it is smaller, else 0,
/// and the compressed size of each, as 64-bit numbers; then the compressed blocks. Both parts are encoded by
/// themselves.
template <typename Number>
std::string encoded(const std::vector<Number>& values) {
  const std::span<const std::byte> data = std::as_bytes(std::span{values});
  std::vector<std::uint64_t> head{(data.size() + kBlock - 1) / kBlock, kBlock, data.size() % kBlock};
  std::vector<std::byte> compressed;
  for (std::size_t at = 0; at < data.size(); at += kBlock) {
    head.push_back(append_compressed(data.subspan(at, std::min(kBlock, data.size() - at)), compressed));
  }
  return to_base64(std::as_bytes(std::span{head})) + to_base64(compressed);
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

/// Adds <name> ... </name> around what an element holds.
void add_block(const char* name, const VtkArrays& arrays, const TextSink& add) {
  if (!arrays) return;
  add(fmt::format("<{}>\n", name));
  arrays(add);
  add(fmt::format("</{}>\n", name));
}

void add_cells(const char* name, const VtkCells& cells, const TextSink& add) {
  if (cells.ends.empty()) return;
  const auto arrays = [&cells](const TextSink& sink) {
    sink(vtk_array("connectivity", cells.connectivity));
    sink(vtk_array("offsets", cells.ends));
  };
  add_block(name, arrays, add);
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

void write_vtk_poly_data(const VtkPolyData& data, const TextSink& add) {
  add("<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\">\n"
      "<PolyData>\n");
  add_block("FieldData", data.field_arrays, add);
  add(
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                  "NumberOfPolys=\"0\">\n",
                  data.points.size(), data.verts.ends.size(), data.lines.ends.size()));
  add_block(
      "Points", [&data](const TextSink& sink) { sink(vtk_array("points_mm", data.points)); }, add);
  add_cells("Verts", data.verts, add);
  add_cells("Lines", data.lines, add);
  add_block("PointData", data.point_arrays, add);
  add_block("CellData", data.cell_arrays, add);
  add("</Piece>\n</PolyData>\n</VTKFile>\n");
}

}  // namespace knitmech::results
