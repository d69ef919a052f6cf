// Steps of the solver on several threads: fork and join, beams with integration, and whole steps.

#include <benchmark/benchmark.h>

#include "beam/internal_force.h"
#include "bench_fabric.h"
#include "solve/explicit_solver.h"

namespace knitmech::bench {
namespace {

void report(benchmark::State& benchmark, const model::Model& model) {
  benchmark.counters["element_steps"] =
      benchmark::Counter(static_cast<double>(model.n_elements()) * static_cast<double>(benchmark.iterations()),
                         benchmark::Counter::kIsRate);
}

void fork_and_join(benchmark::State& benchmark) {
  const base::ThreadTeam team(static_cast<std::size_t>(benchmark.range(0)));
  for ([[maybe_unused]] auto _ : benchmark) {
    team.run([](std::size_t part) { benchmark::DoNotOptimize(part); });
  }
}
BENCHMARK(fork_and_join)->ArgNames({"threads"})->Arg(1)->Arg(2)->Arg(4)->UseRealTime();

/// \param range stitches along either side, threads
void beams_and_integration(benchmark::State& benchmark) {
  const auto size = static_cast<int>(benchmark.range(0));
  const model::Model model = main_example(10, size, size);
  const base::ThreadTeam team(static_cast<std::size_t>(benchmark.range(1)));
  const beam::Elements elements = beam::make_elements(model, 1e4, 0.06);
  const beam::NodalInertia inertia = beam::lump_inertia(elements, 1e4);
  model::State state = state_of(model);
  beam::ElementWork work(model.nodes.size());
  model::NodalLoads loads(model.nodes.size());
  for ([[maybe_unused]] auto _ : benchmark) {
    beam::set_internal_force(elements, state, 1e-6, work, loads, team);
    solve::integrate(inertia, loads, {1e-6, 1e-6}, 0.0, state, team);
  }
  report(benchmark, model);
}
BENCHMARK(beams_and_integration)
    ->ArgNames({"stitches", "threads"})
    ->ArgsProduct({{3, 4, 6, 8, 12, 40, 100}, {1, 2}})
    ->UseRealTime();

/// The main example as it looks when its loops have closed. \param range smooth centreline or chords, threads
void whole_step(benchmark::State& benchmark) {
  model::Model model = main_example();
  model.centreline = benchmark.range(0) == 0 ? model::Centreline::chords : model::Centreline::smooth;
  model.test.speed = 20;
  model.test.ramp = 0.1;
  solve::ExplicitSolver solver(model, {1e4, 0.06, 0.0, 0.9, false, static_cast<int>(benchmark.range(1))});
  const double end = model.test.time_at(0.2);
  while (solver.time() < end) solver.step();
  for ([[maybe_unused]] auto _ : benchmark) solver.step();
  report(benchmark, model);
}
BENCHMARK(whole_step)
    ->ArgNames({"smooth", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Iterations(5000)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace knitmech::bench
