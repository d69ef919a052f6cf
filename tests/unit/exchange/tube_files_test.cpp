#include "exchange/tube_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/errors.h"
#include "yarn_rows.h"

// What is tested here is the layout of the bytes; tests/geometry has other programs' readers look at whole fabrics.
namespace knitmech::exchange {
namespace {

using Eigen::Vector3f;

template <typename Number>
Number at(const std::string& bytes, std::size_t place) {
  Number value;
  std::memcpy(&value, bytes.data() + place, sizeof(Number));
  return value;
}

Vector3f vector_at(const std::string& bytes, std::size_t place) {
  return {at<float>(bytes, place), at<float>(bytes, place + 4), at<float>(bytes, place + 8)};
}

/// Two yarns, the second of which has a break.
YarnTubes two_yarns() {
  YarnTubes tubes{.title = "Two yarns\nv 1 2 3", .pieces = straight_pieces(), .sides = 5};
  for (model::CurvePiece piece : helix_pieces(1, 0.3, 1, 0.1)) {
    piece.yarn = 1;
    piece.continues_piece_before = piece.node != 0 && piece.node != 7;
    tubes.pieces.push_back(piece);
  }
  return tubes;
}

std::vector<TubeMesh> meshes_of(const YarnTubes& tubes) {
  std::vector<TubeMesh> meshes;
  for (const YarnRow row : tube_rows(tubes.pieces)) meshes.push_back(tube_mesh(row, tubes.sides));
  return meshes;
}

TEST(StlBytes, GivenTubes_ThenItHasTheirTrianglesOneAfterTheOther) {
  const YarnTubes tubes = two_yarns();
  const std::string bytes = stl_bytes(tubes);
  EXPECT_NE(bytes.substr(0, 80).find("mm"), std::string::npos);
  EXPECT_NE(bytes.substr(0, 5), "solid") << "that is how the text form begins";
  std::size_t place = 84;
  std::uint32_t count = 0;
  for (const TubeMesh& mesh : meshes_of(tubes)) {
    for (const auto& triangle : mesh.triangles) {
      const auto corner = [&](std::size_t i) { return vector_at(bytes, place + 12 + 12 * i); };
      for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(corner(i), mesh.points[triangle[i].point]);
      const Vector3f expected = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
      ASSERT_LT((vector_at(bytes, place) - expected).norm(), 1e-4);
      ASSERT_EQ(at<std::uint16_t>(bytes, place + 48), 0);
      place += 50;
      ++count;
    }
  }
  EXPECT_EQ(at<std::uint32_t>(bytes, 80), count);
  EXPECT_EQ(bytes.size(), place);
}

TEST(ObjText, GivenTubes_ThenItHasAnObjectOfEachYarnAndCountsPointsThroughTheFile) {
  const YarnTubes tubes = two_yarns();
  std::vector<std::string> objects;
  std::vector<Vector3f> points, normals;
  std::vector<std::array<std::size_t, 6>> faces;
  std::istringstream text(obj_text(tubes));
  for (std::string line; std::getline(text, line);) {
    if (line[0] == '#') continue;
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "o") {
      words >> objects.emplace_back();
    } else if (kind == "v" || kind == "vn") {
      Vector3f& vector = (kind == "v" ? points : normals).emplace_back();
      words >> vector.x() >> vector.y() >> vector.z();
    } else {
      ASSERT_EQ(kind, "f") << line;
      std::ranges::replace(line, '/', ' ');
      std::istringstream numbers(line.substr(1));
      for (std::size_t& number : faces.emplace_back()) numbers >> number;
    }
  }
  EXPECT_EQ(objects, (std::vector<std::string>{"yarn_1", "yarn_2"}));
  std::size_t points_before = 0, normals_before = 0, face = 0;
  for (const TubeMesh& mesh : meshes_of(tubes)) {
    for (const auto& triangle : mesh.triangles) {
      ASSERT_LT(face, faces.size());
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(faces[face][2 * i], points_before + triangle[i].point + 1);
        EXPECT_EQ(faces[face][2 * i + 1], normals_before + triangle[i].normal + 1);
        EXPECT_EQ(points.at(faces[face][2 * i] - 1), mesh.points[triangle[i].point]);
        EXPECT_LT((normals.at(faces[face][2 * i + 1] - 1) - mesh.normals[triangle[i].normal]).norm(), 1e-5F);
      }
      ++face;
    }
    points_before += mesh.points.size();
    normals_before += mesh.normals.size();
  }
  EXPECT_EQ(faces.size(), face);
  EXPECT_EQ(points.size(), points_before) << "the title's second line is no point";
}

/// A binary glTF file in its parts.
struct Glb {
  nlohmann::json json;
  std::string binary;

  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(at<std::uint32_t>(bytes, 4), 2U);
    EXPECT_EQ(at<std::uint32_t>(bytes, 8), bytes.size());
    const std::size_t length = at<std::uint32_t>(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json = nlohmann::json::parse(bytes.substr(20, length));
    EXPECT_EQ(at<std::uint32_t>(bytes, 20 + length), bytes.size() - 28 - length);
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    binary = bytes.substr(28 + length);
  }
  [[nodiscard]] std::size_t offset(const nlohmann::json& accessor) const {
    return json["bufferViews"].at(accessor["bufferView"].get<std::size_t>())["byteOffset"];
  }
  /// Point and normal of a corner of a triangle.
  [[nodiscard]] std::pair<Vector3f, Vector3f> corner(const nlohmann::json& primitive, std::size_t i) const {
    const auto accessor = [&](const nlohmann::json& index) { return json["accessors"].at(index.get<std::size_t>()); };
    const auto indices = accessor(primitive["indices"]);
    const bool is_short = indices["componentType"] == 5123;
    const std::size_t place = offset(indices) + i * (is_short ? 2 : 4);
    const std::size_t vertex = is_short ? at<std::uint16_t>(binary, place) : at<std::uint32_t>(binary, place);
    const auto vertex_in = [&](const char* name) {
      return vector_at(binary, offset(accessor(primitive["attributes"][name])) + 12 * vertex);
    };
    return {vertex_in("POSITION"), vertex_in("NORMAL")};
  }
};

void expect_mesh(const Glb& glb, const nlohmann::json& primitive, const TubeMesh& mesh) {
  for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i) {
    const TubeCorner& expected = mesh.triangles[i / 3][i % 3];
    const auto [point, normal] = glb.corner(primitive, i);
    ASSERT_EQ(point, mesh.points[expected.point]);
    ASSERT_EQ(normal, mesh.normals[expected.normal]);
  }
}

TEST(GlbBytes, GivenTubes_ThenEveryYarnIsAMeshWithAPartForEachOfItsPieces) {
  const YarnTubes tubes = two_yarns();
  const Glb glb(glb_bytes(tubes));
  const std::vector<TubeMesh> meshes = meshes_of(tubes);
  ASSERT_EQ(glb.json["meshes"].size(), 2U);
  ASSERT_EQ(glb.json["meshes"][0]["primitives"].size(), 1U);
  ASSERT_EQ(glb.json["meshes"][1]["primitives"].size(), 2U);
  expect_mesh(glb, glb.json["meshes"][0]["primitives"][0], meshes[0]);
  expect_mesh(glb, glb.json["meshes"][1]["primitives"][0], meshes[1]);
  expect_mesh(glb, glb.json["meshes"][1]["primitives"][1], meshes[2]);
  EXPECT_EQ(glb.json["scenes"][0]["extras"]["title"], tubes.title);
  EXPECT_EQ(glb.json["nodes"][0]["scale"], nlohmann::json({0.001, 0.001, 0.001})) << "mm in a format of metres";
}

TEST(GlbBytes, GivenATubeOfMoreVerticesThan16BitsTell_ThenItsIndicesHave32) {
  YarnTubes tubes{.title = "", .pieces = helix_pieces(1, 0.3, 12, 0.1), .sides = 256};
  const TubeMesh mesh = meshes_of(tubes)[0];
  ASSERT_GT(mesh.points.size(), 65536U);
  const Glb glb(glb_bytes(tubes));
  EXPECT_EQ(glb.json["accessors"].back()["componentType"], 5125);
  expect_mesh(glb, glb.json["meshes"][0]["primitives"][0], mesh);
}

TEST(GlbBytes, GivenATitleThatIsNoUtf8_ThenTheJsonStillIs) {
  YarnTubes tubes{.title = "\xff", .pieces = straight_pieces()};
  EXPECT_EQ(Glb(glb_bytes(tubes)).json["scenes"][0]["name"], "\xef\xbf\xbd");
}

TEST(TubeFiles, GivenMoreThanAFileHolds_ThenNoneOfThemIsBegun) {
  YarnTubes tubes{.title = "", .pieces = {}, .sides = 256};
  // A bend so narrow for its length that it takes the most steps there are: 256 000 points an element.
  for (const model::CurvePiece& piece : helix_pieces(1, 0, 40, 1e-12)) tubes.pieces.push_back(piece);
  EXPECT_THROW(static_cast<void>(stl_bytes(tubes)), InputError);
  EXPECT_THROW(static_cast<void>(glb_bytes(tubes)), InputError);
  EXPECT_THROW(static_cast<void>(obj_text(tubes)), InputError);
}

}  // namespace
}  // namespace knitmech::exchange
