#include "results/frame_file.h"

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>

#include "results/base64.h"
#include "results/node_values.h"

namespace knitmech::results {
namespace {

using model::Frame;
using model::Model;

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
std::string array(const std::string& name, const std::vector<Number>& values, int components = 1) {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n",
                     vtk_type<Number>(), name, components, encoded(values));
}

/// Arrays of field data have no number of points to go by and state their length.
std::string field_array(const std::string& name, const std::vector<double>& values) {
  return fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"binary\">{}</DataArray>\n",
                     name, values.size(), encoded(values));
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

std::vector<double> displacements(const Model& model, const Frame& frame) {
  std::vector<double> values;
  values.reserve(3 * frame.points.size());
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const Eigen::Vector3d displacement = frame.points[i] - model.nodes[i];
    values.insert(values.end(), displacement.data(), displacement.data() + 3);
  }
  return values;
}

std::vector<double> magnitudes(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> values;
  values.reserve(vectors.size());
  for (const Eigen::Vector3d& vector : vectors) {
    values.push_back(vector.norm());
  }
  return values;
}

std::vector<double> infinite_as_nan(std::vector<double> values) {
  for (double& value : values) {
    value = std::isinf(value) ? std::numeric_limits<double>::quiet_NaN() : value;
  }
  return values;
}

std::vector<double> tube_radii(const Model& model) {
  std::vector<double> radii(model.nodes.size());
  for (const model::ModelYarn& yarn : model.yarns) {
    const double radius = 0.5 * model.sections[static_cast<std::size_t>(yarn.section)].diameter;
    std::fill_n(radii.begin() + yarn.first_node, yarn.n_nodes, radius);
  }
  return radii;
}

struct NamedElementValues {
  const char* name;
  const std::vector<double>& values;
};

std::vector<NamedElementValues> element_fields(const Frame& frame) {
  return {{"axial_force_N", frame.axial_force},
          {"shear_force_N", frame.shear_force},
          {"bending_moment_Nmm", frame.bending_moment},
          {"torque_Nmm", frame.torque},
          {"curvature_per_mm", frame.curvature}};
}

std::string field_data(const Model& model, const Frame& frame) {
  const model::HistoryRow& row = frame.history;
  std::string text = "<FieldData>\n";
  text += field_array("strain", {row.strain});
  text += field_array("time_s", {row.time});
  text += field_array("displacement_mm", {row.displacement});
  text += field_array("force_top_N", {row.force_top});
  text += field_array("force_bottom_N", {row.force_bottom});
  for (const auto& [name, values] : element_fields(frame)) {
    text += field_array(std::string{"element_"} + name, elements_only(model, values));
  }
  return text + "</FieldData>\n";
}

std::string point_data(const Model& model, const Frame& frame) {
  std::string text = "<PointData>\n";
  for (const auto& [name, values] : element_fields(frame)) {
    text += array(name, average_to_nodes(model, values));
  }
  text += array("contact_force_N", flat(frame.contact_force), 3);
  text += array("contact_force_magnitude_N", magnitudes(frame.contact_force));
  text += array("gap_mm", infinite_as_nan(frame.gap));
  text += array("displacement_mm", displacements(model, frame), 3);
  text += array("rotation_wxyz", flat(frame.rotations), 4);
  text += array("tube_radius_mm", tube_radii(model));
  return text + "</PointData>\n";
}

std::string cell_data(const Model& model) {
  std::vector<std::int32_t> yarn_ids;
  std::vector<std::int32_t> courses;
  for (const model::ModelYarn& yarn : model.yarns) {
    yarn_ids.push_back(static_cast<std::int32_t>(yarn_ids.size()));
    courses.push_back(yarn.course);
  }
  return "<CellData>\n" + array("yarn", yarn_ids) + array("course", courses) + "</CellData>\n";
}

std::string lines(const Model& model) {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> ends;
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int i = 0; i < yarn.n_nodes; ++i) {
      connectivity.push_back(yarn.first_node + i);
    }
    ends.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  return "<Lines>\n" + array("connectivity", connectivity) + array("offsets", ends) + "</Lines>\n";
}

void check_sizes(const Model& model, const Frame& frame) {
  const std::size_t count = model.nodes.size();
  bool fits = frame.points.size() == count && frame.rotations.size() == count && frame.contact_force.size() == count &&
              frame.gap.size() == count;
  for (const NamedElementValues& field : element_fields(frame)) {
    fits = fits && field.values.size() == count;
  }
  if (!fits) {
    throw std::invalid_argument(fmt::format("Frame {} does not belong to the model of {} nodes.", frame.index, count));
  }
}

}  // namespace

std::string frame_file_name(int index) {
  return fmt::format("frame_{:04d}.vtp", index);
}

std::string frame_text(const Model& model, const Frame& frame) {
  check_sizes(model, frame);
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n";
  text += field_data(model, frame);
  text += fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      model.nodes.size(), model.yarns.size());
  text += "<Points>\n" + array("points_mm", flat(frame.points), 3) + "</Points>\n";
  text += lines(model);
  text += point_data(model, frame);
  text += cell_data(model);
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string collection_text(const std::vector<FrameEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const FrameEntry& entry : entries) {
    text += fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.strain,
                        frame_file_name(entry.index));
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace knitmech::results
