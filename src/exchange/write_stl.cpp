#include <Eigen/Geometry>

#include "curves/bytes.h"
#include "exchange/tube_files.h"

namespace knitmech::exchange {
namespace {

constexpr std::size_t kHeadBytes = 80;
constexpr std::uint64_t kTriangleBytes = 50;

void put_vector(std::string& bytes, const Eigen::Vector3f& vector) {
  for (const float value : vector) curves::put(bytes, value);
}

void put_triangle(std::string& bytes, const TubeMesh& mesh, const std::array<TubeCorner, 3>& triangle) {
  const auto corner = [&](std::size_t i) { return mesh.points[triangle[i].point]; };
  // Where two corners fall together there is no plane, and zero is what the format has for that.
  const Eigen::Vector3d normal =
      (corner(1) - corner(0)).cast<double>().cross((corner(2) - corner(0)).cast<double>()).stableNormalized();
  put_vector(bytes, normal.cast<float>());
  for (std::size_t i = 0; i < 3; ++i) put_vector(bytes, corner(i));
  curves::put(bytes, std::uint16_t{0});
}

}  // namespace

std::string stl_bytes(const YarnTubes& tubes) {
  const std::vector<YarnRow> rows = tube_rows(tubes.pieces);
  std::uint64_t n_triangles = 0;
  for (const YarnRow row : rows) n_triangles += tube_size(row, tubes.sides).triangles;
  const std::uint64_t size = kHeadBytes + sizeof(std::uint32_t) + kTriangleBytes * n_triangles;
  check_file_size(size);
  // Not "solid", by which readers know the text form.
  std::string bytes = "Yarns as tubes, lengths in mm; KnitMech";
  bytes.reserve(size);
  bytes.resize(kHeadBytes, '\0');
  curves::put(bytes, static_cast<std::uint32_t>(n_triangles));
  for (const YarnRow row : rows) {
    const TubeMesh mesh = tube_mesh(row, tubes.sides);
    for (const auto& triangle : mesh.triangles) put_triangle(bytes, mesh, triangle);
  }
  return bytes;
}

}  // namespace knitmech::exchange
