#pragma once

#include <vector>

#include "model/model.h"

namespace knitmech::results {

/// Element values as node values: each node gets the mean of the elements on its two sides, a yarn's end the value of
/// its only element, and a yarn of a single node 0.
///
/// element_values has one entry per node by the rule of model::Model (entry i belongs to the element that starts at
/// node i); so has the result, any unit.
[[nodiscard]] std::vector<double> average_to_nodes(const model::Model& model,
                                                   const std::vector<double>& element_values);

/// The same where yarns have broken (Frame::broken): the nodes of a broken element get the value of their other one.
[[nodiscard]] std::vector<double> average_to_nodes(const model::Model& model, const std::vector<int>& broken,
                                                   const std::vector<double>& element_values);

/// Element values without the unused entry at the end of each yarn: one entry per element, in the order of the nodes.
[[nodiscard]] std::vector<double> elements_only(const model::Model& model, const std::vector<double>& element_values);

}  // namespace knitmech::results
