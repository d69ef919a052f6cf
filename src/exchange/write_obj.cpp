#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "exchange/tube_files.h"

namespace knitmech::exchange {
namespace {

// Its line, that of its normal, and two triangles, of which every point of a long tube has its share.
constexpr std::uint64_t kFewestBytesOfPoint = 60, kUsualBytesOfPoint = 180;

/// A text on one line, as a comment needs it.
std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char letter) { return letter < ' '; }, ' ');
  return text;
}

std::uint64_t n_points_of(const std::vector<YarnRow>& rows, int sides) {
  std::uint64_t n_points = 0;
  for (const YarnRow row : rows) n_points += tube_size(row, sides).points;
  return n_points;
}

/// Numbers of points and normals that came before; both are counted from 1 through the whole file.
struct Before {
  std::uint64_t points = 1, normals = 1;
};

void add_mesh(std::string& text, const TubeMesh& mesh, Before& before) {
  auto out = std::back_inserter(text);
  for (const Eigen::Vector3f& point : mesh.points) fmt::format_to(out, "v {} {} {}\n", point.x(), point.y(), point.z());
  for (const Eigen::Vector3f& normal : mesh.normals) {
    fmt::format_to(out, "vn {:.6g} {:.6g} {:.6g}\n", normal.x(), normal.y(), normal.z());
  }
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    for (const TubeCorner& corner : triangle) {
      fmt::format_to(out, " {}//{}", before.points + corner.point, before.normals + corner.normal);
    }
    text += '\n';
  }
  before.points += mesh.points.size();
  before.normals += mesh.normals.size();
}

}  // namespace

std::string obj_text(const YarnTubes& tubes) {
  const std::vector<YarnRow> rows = tube_rows(tubes.pieces);
  const std::uint64_t n_points = n_points_of(rows, tubes.sides);
  check_file_size(kFewestBytesOfPoint * n_points);
  std::string text = fmt::format("# {}\n# Yarns as tubes, written by KnitMech; lengths in mm, y up the wales\n",
                                 in_one_line(tubes.title));
  text.reserve(kUsualBytesOfPoint * n_points);
  Before before;
  int yarn = -1;
  for (const YarnRow row : rows) {
    const TubeMesh mesh = tube_mesh(row, tubes.sides);
    if (mesh.yarn != yarn) text += fmt::format("o yarn_{}\n", mesh.yarn + 1);
    yarn = mesh.yarn;
    add_mesh(text, mesh, before);
    check_file_size(text.size());
  }
  return text;
}

}  // namespace knitmech::exchange
