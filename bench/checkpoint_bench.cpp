// A checkpoint: the time for which the run stops to copy its memory, beside the time of a step, and bytes per element.

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

#include "bench_fabric.h"
#include "solve/checkpoint.h"
#include "solve/mass_scaling.h"

namespace knitmech::bench {
namespace {

constexpr int kSteps = 100;

/// \param wales the fabric has 5 courses for 3 wales
void checkpoint_of_main_example(benchmark::State& benchmark) {
  const auto wales = static_cast<int>(benchmark.range(0));
  const model::Model model = main_example(10, wales, wales * 5 / 3);
  solve::ExplicitSolver solver(model, {.mass_scaling = solve::automatic_mass_scaling(model), .step_factor = 0.9});
  solver.step();
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kSteps; ++i) solver.step();
  const double step = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / kSteps;
  std::string checkpoint;
  for ([[maybe_unused]] auto _ : benchmark) {
    checkpoint = solve::checkpoint_of(solver, {});
    benchmark::DoNotOptimize(checkpoint.data());
  }
  benchmark.counters["step_ms"] = 1e3 * step;
  benchmark.counters["bytes_per_element"] = static_cast<double>(checkpoint.size()) / model.n_elements();
}
BENCHMARK(checkpoint_of_main_example)->Arg(9)->Arg(30)->Arg(60)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace knitmech::bench
