#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "model/model.h"
#include "serve/blob.h"

namespace knitmech::serve {

/// What the page draws a fabric from: `FabricHead` of web/src/api/types.ts.
[[nodiscard]] nlohmann::ordered_json fabric_json(const model::Model& model);

/// Adds positions, course and wale of the nodes.
void add_model(Blob& blob, const model::Model& model);

/// x, y and z of each point in turn.
[[nodiscard]] std::vector<float> coordinates(const std::vector<Eigen::Vector3d>& points);

}  // namespace knitmech::serve
