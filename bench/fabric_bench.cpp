// The whole main example to 22 % strain: element steps per second with contact and friction, and wall time.

#include <benchmark/benchmark.h>

#include "bench_fabric.h"
#include "solve/simulate.h"

namespace knitmech::bench {
namespace {

void whole_main_example(benchmark::State& benchmark) {
  const model::Model model = main_example();
  double element_steps = 0;
  for ([[maybe_unused]] auto _ : benchmark) {
    const model::RunOutcome outcome = solve::simulate(model, {}, {});
    if (outcome.status != model::RunStatus::completed) benchmark.SkipWithError(outcome.reason.c_str());
    element_steps += static_cast<double>(outcome.steps) * model.n_elements();
  }
  benchmark.counters["element_steps"] = benchmark::Counter(element_steps, benchmark::Counter::kIsRate);
}
BENCHMARK(whole_main_example)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace knitmech::bench
