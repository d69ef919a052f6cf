#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "curves/bytes.h"
#include "exchange/tube_files.h"

namespace knitmech::exchange {
namespace {

using curves::put;
using Json = nlohmann::ordered_json;

// Numbers that the format gives to what is in its lists (glTF 2.0, 3.6.2.2 and 5.11).
constexpr int kVertices = 34962, kIndices = 34963;                           // targets of a buffer view
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;     // component types
constexpr std::uint32_t kMagic = 0x46546c67, kVersion = 2;                   // 4.4.2: "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;  // 4.4.3: "JSON", "BIN"
constexpr std::uint64_t kHeadBytes = 12, kChunkHeadBytes = 8, kAlignment = 4;
constexpr double kMetresPerMillimetre = 1e-3;

// A matt yarn; the colour is linear: sRGB 200, 135, 90.
constexpr double kRed = 0.578, kGreen = 0.242, kBlue = 0.102, kRoughness = 0.7;

std::uint64_t aligned(std::uint64_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

/// glTF has one index for point and normal: the points of the two ends stand in the file once more, with other normals.
std::uint64_t n_vertices(const TubeSize& size, std::uint64_t sides) {
  return size.points + 2 * sides;
}

std::uint64_t n_vertices(const TubeMesh& mesh) {
  return mesh.points.size() + 2 * std::uint64_t{mesh.sides};
}

/// The highest number of 16 bits is no index (3.7.2.1).
bool fits_short(std::uint64_t vertices) {
  return vertices <= std::numeric_limits<std::uint16_t>::max();
}

std::uint64_t binary_bytes(const TubeSize& size, std::uint64_t sides) {
  const std::uint64_t vertices = n_vertices(size, sides);
  const std::uint64_t index = fits_short(vertices) ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  return vertices * 2 * 3 * sizeof(float) + aligned(3 * size.triangles * index);
}

std::uint32_t vertex_of(const TubeMesh& mesh, const TubeCorner& corner) {
  const auto n_points = static_cast<std::uint32_t>(mesh.points.size());
  if (corner.normal < n_points) return corner.point;
  if (corner.normal == n_points) return n_points + corner.point;            // first end: its ring is the first
  return n_points + mesh.sides + (corner.point - (n_points - mesh.sides));  // last end: its ring is the last
}

std::vector<float> as_numbers(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

/// The two parts of the file under way.
class Glb {
 public:
  Glb(const YarnTubes& tubes, std::uint64_t n_bytes) {
    binary_.reserve(n_bytes);
    json_["asset"] = {{"version", "2.0"}, {"generator", "KnitMech"}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"name", tubes.title}, {"nodes", {0}}, {"extras", {{"title", tubes.title}}}}};
    json_["nodes"] = {{{"name", "fabric"},
                       {"scale", {kMetresPerMillimetre, kMetresPerMillimetre, kMetresPerMillimetre}},
                       {"children", Json::array()}}};
    json_["materials"] = {
        {{"name", "yarn"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {kRed, kGreen, kBlue, 1}}, {"metallicFactor", 0}, {"roughnessFactor", kRoughness}}}}};
  }

  void add(const TubeMesh& mesh) {
    if (mesh.yarn != yarn_) begin_yarn(mesh.yarn);
    const auto position = add_positions(mesh);
    const auto normal = add_normals(mesh);
    const auto indices = add_indices(mesh);
    json_["meshes"].back()["primitives"].push_back(
        {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"indices", indices}, {"material", 0}});
  }

  /// Head, JSON and binary part, each of a length that is a multiple of four (4.4).
  std::string bytes() && {
    json_["buffers"] = {{{"byteLength", binary_.size()}}};
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize(aligned(text.size()), ' ');
    const std::uint64_t size = kHeadBytes + 2 * kChunkHeadBytes + text.size() + binary_.size();
    check_file_size(size);
    std::string file;
    file.reserve(size);
    for (const std::uint32_t number :
         {kMagic, kVersion, static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(text.size()), kJsonChunk}) {
      put(file, number);
    }
    file += text;
    put(file, static_cast<std::uint32_t>(binary_.size()));
    put(file, kBinaryChunk);
    file += binary_;
    return file;
  }

 private:
  void begin_yarn(int yarn) {
    yarn_ = yarn;
    const std::string name = fmt::format("yarn {}", yarn + 1);
    json_["nodes"][0]["children"].push_back(json_["nodes"].size());
    json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size()}});
    json_["meshes"].push_back({{"name", name}, {"primitives", Json::array()}});
  }

  /// Describes what has been added to the binary part since it was `first` long. \return index of its accessor
  std::size_t described(std::size_t first, int target, Json accessor) {
    accessor["bufferView"] = json_["bufferViews"].size();
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", first}, {"byteLength", binary_.size() - first}, {"target", target}});
    json_["accessors"].push_back(std::move(accessor));
    binary_.resize(aligned(binary_.size()), '\0');
    return json_["accessors"].size() - 1;
  }

  void put_vectors(std::span<const Eigen::Vector3f> vectors) {
    for (const Eigen::Vector3f& vector : vectors) {
      for (const float value : vector) put(binary_, value);
    }
  }

  std::size_t add_positions(const TubeMesh& mesh) {
    const std::size_t first = binary_.size();
    const std::span<const Eigen::Vector3f> points = mesh.points;
    put_vectors(points);
    put_vectors(points.first(mesh.sides));
    put_vectors(points.last(mesh.sides));
    Eigen::Vector3f lowest = points.front(), highest = lowest;
    for (const Eigen::Vector3f& point : points) {
      lowest = lowest.cwiseMin(point);
      highest = highest.cwiseMax(point);
    }
    return described(first, kVertices,
                     {{"componentType", kFloat},
                      {"count", n_vertices(mesh)},
                      {"type", "VEC3"},
                      {"min", as_numbers(lowest)},
                      {"max", as_numbers(highest)}});
  }

  std::size_t add_normals(const TubeMesh& mesh) {
    const std::size_t first = binary_.size();
    const std::size_t n_points = mesh.points.size();
    put_vectors(std::span(mesh.normals).first(n_points));
    for (const std::size_t end : {n_points, n_points + 1}) {
      put_vectors(std::vector<Eigen::Vector3f>(mesh.sides, mesh.normals[end]));
    }
    return described(first, kVertices, {{"componentType", kFloat}, {"count", n_vertices(mesh)}, {"type", "VEC3"}});
  }

  std::size_t add_indices(const TubeMesh& mesh) {
    const std::size_t first = binary_.size();
    const bool is_short = fits_short(n_vertices(mesh));
    for (const auto& triangle : mesh.triangles) {
      for (const TubeCorner& corner : triangle) {
        const std::uint32_t vertex = vertex_of(mesh, corner);
        is_short ? put(binary_, static_cast<std::uint16_t>(vertex)) : put(binary_, vertex);
      }
    }
    return described(first, kIndices,
                     {{"componentType", is_short ? kUnsignedShort : kUnsignedInt},
                      {"count", 3 * mesh.triangles.size()},
                      {"type", "SCALAR"}});
  }

  Json json_;
  std::string binary_;
  int yarn_ = -1;
};

}  // namespace

std::string glb_bytes(const YarnTubes& tubes) {
  const std::vector<YarnRow> rows = tube_rows(tubes.pieces);
  const auto sides = static_cast<std::uint64_t>(tubes.sides);
  std::uint64_t n_bytes = 0;
  for (const YarnRow row : rows) n_bytes += binary_bytes(tube_size(row, tubes.sides), sides);
  check_file_size(n_bytes);
  Glb glb(tubes, n_bytes);
  for (const YarnRow row : rows) glb.add(tube_mesh(row, tubes.sides));
  return std::move(glb).bytes();
}

}  // namespace knitmech::exchange
