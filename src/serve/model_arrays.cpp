#include "serve/model_arrays.h"

#include <nlohmann/json.hpp>

namespace knitmech::serve {

nlohmann::ordered_json fabric_json(const model::Model& model) {
  nlohmann::ordered_json yarns = nlohmann::ordered_json::array();
  for (const model::ModelYarn& yarn : model.yarns) {
    yarns.push_back({{"first_node", yarn.first_node}, {"nodes", yarn.n_nodes}});
  }
  nlohmann::ordered_json edge_diameter;
  if (model.sections.size() > 1) edge_diameter = model.sections[1].diameter;
  return {{"nodes", model.n_nodes()},
          {"yarns", yarns},
          {"diameter", model.sections.front().diameter},
          {"edge_diameter", edge_diameter},
          {"gauge_length", model.test.gauge_length}};
}

void add_model(Blob& blob, const model::Model& model) {
  blob.add("positions", coordinates(model.nodes));
  blob.add("course", std::vector<std::int32_t>(model.course.begin(), model.course.end()));
  blob.add("wale", std::vector<std::int32_t>(model.wale.begin(), model.wale.end()));
}

std::vector<float> coordinates(const std::vector<Eigen::Vector3d>& points) {
  std::vector<float> numbers;
  numbers.reserve(3 * points.size());
  for (const Eigen::Vector3d& point : points) {
    for (const double number : point) numbers.push_back(static_cast<float>(number));
  }
  return numbers;
}

}  // namespace knitmech::serve
