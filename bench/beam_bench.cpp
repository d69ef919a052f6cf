// Forces of the beams alone: element steps per second.

#include <benchmark/benchmark.h>

#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "beam/nonlinear_axial.h"
#include "beam/strength_watch.h"
#include "bench_fabric.h"
#include "solve/integrate.h"

namespace knitmech::bench {
namespace {

void report(benchmark::State& benchmark, const model::Model& model) {
  benchmark.counters["element_steps"] =
      benchmark::Counter(static_cast<double>(model.n_elements()) * static_cast<double>(benchmark.iterations()),
                         benchmark::Counter::kIsRate);
}

void beam_forces(benchmark::State& benchmark) {
  const model::Model model = main_example(static_cast<int>(benchmark.range(0)));
  const beam::Elements elements = beam::make_elements(model, 1e3, 0.06);
  const model::State state = state_of(model);
  beam::ElementWork work(model.nodes.size());
  model::NodalLoads loads(model.nodes.size());
  for ([[maybe_unused]] auto _ : benchmark) {
    beam::set_internal_force(elements, state, 1e-6, work, loads);
    benchmark::DoNotOptimize(loads.force.x.data());
  }
  report(benchmark, model);
}
BENCHMARK(beam_forces)->Arg(10)->Arg(20)->Arg(30);

/// What a measured curve and a strength cost a step besides.
void curve_and_strength(benchmark::State& benchmark) {
  model::Model model = main_example(static_cast<int>(benchmark.range(0)));
  const double axial = model.sections.front().axial_stiffness;
  model.axial_laws.emplace(0, yarn::AxialLaw({{0, 0}, {0.05, 0.05 * axial}, {0.1, 0.08 * axial}, {0.2, 0.12 * axial}}));
  model.strengths = {{0, axial}};
  beam::Elements elements = beam::make_elements(model, 1e3, 0.06);
  const beam::NonlinearAxial nonlinear(model);
  const beam::StrengthWatch watch(model, elements);
  const model::State state = state_of(model);
  for ([[maybe_unused]] auto _ : benchmark) {
    nonlinear.set_secants(state, elements);
    benchmark::DoNotOptimize(watch.overloaded(state));
  }
  report(benchmark, model);
}
BENCHMARK(curve_and_strength)->Arg(10)->Arg(30);

void integration(benchmark::State& benchmark) {
  const model::Model model = main_example(static_cast<int>(benchmark.range(0)));
  const beam::NodalInertia inertia = beam::lump_inertia(beam::make_elements(model, 1e3, 0.06), 1e3);
  model::State state = state_of(model);
  const model::NodalLoads loads(model.nodes.size());
  for ([[maybe_unused]] auto _ : benchmark) {
    solve::integrate(inertia, loads, {1e-6, 1e-6}, 0.0, state);
    benchmark::DoNotOptimize(state.position.x.data());
  }
  report(benchmark, model);
}
BENCHMARK(integration)->Arg(10)->Arg(30);

}  // namespace
}  // namespace knitmech::bench
