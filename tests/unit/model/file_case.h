#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "curves/write_lines.h"
#include "curves/yarn_file.h"
#include "example_case.h"
#include "model/model.h"

namespace knitmech::model {

/// Fewer stitches of the example: 3 wales x 3 courses, with room between the yarns.
inline Case small_case(int elements_per_erc = 10) {
  Case input = example_case(elements_per_erc);
  input.fabric.wales = 3;
  input.fabric.courses = 3;
  input.loop.out_of_plane = 0.0175;
  return input;
}

/// The nodes of a model as yarns of a file.
inline std::vector<curves::YarnLine> yarns_of(const Model& model) {
  std::vector<curves::YarnLine> yarns;
  for (const ModelYarn& yarn : model.yarns) {
    const auto first = model.nodes.begin() + yarn.first_node;
    yarns.push_back({.points = {first, first + yarn.n_nodes}, .radius = model.sections.front().diameter / 2});
  }
  return yarns;
}

/// The same case with the fabric from yarns that lie as they are on the centreline [mm], changed by a function.
inline Case case_of_yarns(
    Case input, const std::vector<curves::YarnLine>& yarns,
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& change = [](const auto& point) { return point; }) {
  curves::YarnFile file{.path = "swatch.csv", .ending = ".csv", .bytes = {}, .lines = {}};
  file.lines.yarns = yarns;
  file.lines.in_millimetres = true;
  for (curves::YarnLine& yarn : file.lines.yarns) {
    for (Eigen::Vector3d& point : yarn.points) point = change(point);
  }
  input.loop = {};
  input.fabric = {};
  input.fabric.yarns = "yarns.csv";
  input.fabric.yarn_file = std::make_shared<const curves::YarnFile>(std::move(file));
  return input;
}

}  // namespace knitmech::model
