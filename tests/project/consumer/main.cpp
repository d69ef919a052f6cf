#include <cstdio>

#include "model/build_model.h"
#include "model/case_file.h"
#include "solve/simulate.h"

int main(int /*argc*/, char* argv[]) {
  const knitmech::model::Case input = knitmech::model::read_case_file(argv[1]);
  const knitmech::model::Model model = knitmech::model::build_model(input);
  knitmech::solve::SimulationSettings settings = knitmech::solve::settings_from(input);
  settings.mass_scaling = 1e4;
  int n_rows = 0;
  const auto outcome = knitmech::solve::simulate(
      model, settings,
      {.on_history = [&](const auto& /*row*/) { ++n_rows; }, .keep_going = [](const auto& /*row*/) { return false; }});
  const bool is_interrupted = outcome.status == knitmech::model::RunStatus::interrupted;
  std::printf("%d nodes, %d elements, %s", model.n_nodes(), model.n_elements(),
              is_interrupted && n_rows > 0 ? "interrupted" : "not interrupted");
}
