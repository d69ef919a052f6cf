// Element-steps per second of the whole explicit step, contact and friction included.
//
//   throughput WALES COURSES ELEMENTS smooth|chords THREADS [STRAIN [STEPS]]
//
// runs examples/02-wale-tension at that size, with that many elements per half stitch, as `knitmech run` does, to a
// strain [%] (0 if not given: from the start, where no yarn touches yet), then measures STEPS steps (5000) and prints
// one line, tab separated: wales, courses, elements per half stitch, centreline, threads, strain where the measured
// steps begin [%], elements, contacts behind the last of them, million element-steps per second. Time is wall time, so
// that threads count: other programs disturb it.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

#include "throughput/main_example.h"

namespace knitmech::bench {
namespace {

struct Request {
  Example example;
  int threads = 1;
  double strain = 0;  ///< [-]
  int steps = 5000;
};

void require_sound(const solve::ExplicitSolver& solver) {
  if (!solver.is_finite() || solver.lost_crossing()) throw std::runtime_error("The simulation went wrong.");
}

void run_to(double strain, double last_strain, solve::ExplicitSolver& solver) {
  if (strain >= last_strain) throw std::invalid_argument("The strain lies beyond the end of the test.");
  while (solver.strain() < strain) {
    solver.step();
    require_sound(solver);
  }
  solver.evaluate();  // from the start, this searches the neighbours
}

/// Wall time.
double seconds_of_steps(int n, solve::ExplicitSolver& solver) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < n; ++i) solver.step();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void measure(const Request& request) {
  const model::Case input = case_of(request.example);
  const model::Model model = model::build_model(input);
  solve::ExplicitSolver solver(model, settings_of(input, model, request.threads));
  run_to(request.strain, model.test.strain, solver);
  constexpr int kWarmUp = 20;
  seconds_of_steps(kWarmUp, solver);
  const double strain = solver.strain();
  const double seconds = seconds_of_steps(request.steps, solver);
  require_sound(solver);
  const double element_steps = static_cast<double>(model.n_elements()) * request.steps;
  fmt::print("{}\t{}\t{}\t{}\t{}\t{:.1f}\t{}\t{}\t{:.2f}\n", request.example.wales, request.example.courses,
             request.example.elements_per_erc,
             request.example.centreline == model::Centreline::smooth ? "smooth" : "chords", request.threads,
             100 * strain, model.n_elements(), solver.history().contacts, 1e-6 * element_steps / seconds);
}

}  // namespace
}  // namespace knitmech::bench

int main(int argc, char** argv) {
  using knitmech::model::Centreline;
  const std::string centreline = argc > 4 ? argv[4] : "";
  if (argc < 6 || argc > 8 || (centreline != "smooth" && centreline != "chords")) {
    fmt::print(stderr, "usage: throughput WALES COURSES ELEMENTS smooth|chords THREADS [STRAIN [STEPS]]\n");
    return 2;
  }
  try {
    knitmech::bench::Request request;
    request.example = {std::atoi(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
                       centreline == "smooth" ? Centreline::smooth : Centreline::chords};
    request.threads = std::max(1, std::atoi(argv[5]));
    if (argc > 6) request.strain = 0.01 * std::atof(argv[6]);
    if (argc > 7) request.steps = std::atoi(argv[7]);
    knitmech::bench::measure(request);
  } catch (const std::exception& error) {
    fmt::print(stderr, "throughput: {}\n", error.what());
    return 1;
  }
  return 0;
}
