#pragma once

#include <string>

#include "model/build_model.h"
#include "model/case_file.h"
#include "model/state.h"

namespace knitmech::bench {

/// The model of examples/02-wale-tension, at another mesh and size where asked for.
inline model::Model main_example(int elements_per_erc = 10, int wales = 9, int courses = 15) {
  model::Case input = model::read_case_file(std::string(KNITMECH_SOURCE_DIR) + "/examples/02-wale-tension/case.toml");
  input.fabric.elements_per_erc = elements_per_erc;
  input.fabric.wales = wales;
  input.fabric.courses = courses;
  return model::build_model(input);
}

inline model::State state_of(const model::Model& model) {
  model::State state(model.nodes.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    state.position.set(i, {model.nodes[i].x(), model.nodes[i].y(), model.nodes[i].z()});
  }
  return state;
}

}  // namespace knitmech::bench
