// Contact alone, on the fabric as it looks when its loops have closed: search for neighbours, and forces.

#include <benchmark/benchmark.h>

#include "bench_fabric.h"
#include "contact/neighbour_search.h"
#include "contact/yarn_contact.h"
#include "solve/explicit_solver.h"

namespace knitmech::bench {
namespace {

/// The main example pulled fast to a strain at which most crossings press.
model::State pulled_state(model::Model& model) {
  model.test.speed = 20;
  model.test.ramp = 0.1;
  solve::ExplicitSolver solver(model, {1e4, 0.06, 0.0, 0.9});
  const double end = model.test.time_at(0.2);
  while (solver.time() < end) solver.step();
  return solver.state();
}

void contact_forces(benchmark::State& benchmark) {
  model::Model model = main_example();
  const model::State state = pulled_state(model);
  contact::YarnContact contact(model);
  model::NodalLoads loads(model.nodes.size());
  for ([[maybe_unused]] auto _ : benchmark) {
    contact.add_forces(state, 1e-6, loads);
    benchmark::DoNotOptimize(loads.force.x.data());
  }
  benchmark.counters["element_steps"] =
      benchmark::Counter(static_cast<double>(model.n_elements()) * static_cast<double>(benchmark.iterations()),
                         benchmark::Counter::kIsRate);
  benchmark.counters["contacts"] = contact.n_contacts();
}
BENCHMARK(contact_forces);

void neighbour_search(benchmark::State& benchmark) {
  const auto size = static_cast<int>(benchmark.range(0));
  model::Model model = main_example(10, size, size);
  model.centreline = model::Centreline::chords;
  const contact::ContactElements elements = contact::make_contact_elements(model);
  const model::State state = state_of(model);
  for ([[maybe_unused]] auto _ : benchmark) {
    benchmark::DoNotOptimize(
        contact::find_neighbours(elements, state.position, std::vector<double>(elements.n_nodes(), 0.0), 0.05).data());
  }
  benchmark.counters["elements_per_second"] =
      benchmark::Counter(static_cast<double>(model.n_elements()) * static_cast<double>(benchmark.iterations()),
                         benchmark::Counter::kIsRate);
}
BENCHMARK(neighbour_search)->Arg(10)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace knitmech::bench
