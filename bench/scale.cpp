// What a fabric of a given size costs: set-up time, time of a step, memory.
//
//   scale WALES COURSES smooth|chords [STEPS]
//
// runs the first steps of cases/reference-9x15.toml at that size and prints one line, tab separated: wales, courses,
// centreline, elements, set-up [s], 200 steps [s], nanoseconds per element and step, contacts, bytes per element after
// the set-up, and at most. The masses and the pace are those that a run chooses for itself. Yarns first touch after
// some ten thousand steps: give as many STEPS, and a small fabric, to see what contacts take. All times are processor
// time of the program, which other programs disturb less than wall time. A size to a process: memory that an earlier
// fabric left would be counted with the next.

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#include "base/freed_memory.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "solve/explicit_solver.h"
#include "solve/mass_scaling.h"

namespace knitmech {
namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A number of /proc/self/status, VmRSS or VmHWM [bytes].
double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  std::string key;
  double kilobytes = 0;
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name + ":")) kilobytes = std::stod(line.substr(name.size() + 1));
  }
  return 1024 * kilobytes;
}

struct Request {
  int wales, courses;
  std::string centreline;
  int steps;
};

model::Model model_of(const Request& request) {
  model::Case input = model::read_case_file(std::string(KNITMECH_SOURCE_DIR) + "/cases/reference-9x15.toml");
  input.fabric.wales = request.wales;
  input.fabric.courses = request.courses;
  input.loop.out_of_plane.reset();
  input.contact.centreline = request.centreline == "chords" ? model::Centreline::chords : model::Centreline::smooth;
  return model::build_model(input);
}

void measure(const Request& request) {
  const double empty = memory("VmRSS");
  const double start = processor_seconds();
  const model::Model model = model_of(request);
  solve::ExplicitSolver solver(model, {.mass_scaling = solve::automatic_mass_scaling(model),
                                       .step_factor = 0.9,
                                       .adapts_pace = true,
                                       .finest_length = solve::selective_length(model)});
  solver.evaluate();  // searches the neighbours
  base::hand_back_freed_memory();
  const double set_up = processor_seconds() - start;
  const double elements = model.n_elements();
  const double after_set_up = (memory("VmRSS") - empty) / elements;
  const double before_steps = processor_seconds();
  for (int i = 0; i < request.steps; ++i) solver.step();
  const double per_step = (processor_seconds() - before_steps) / request.steps;
  fmt::print("{}\t{}\t{}\t{}\t{:.3f}\t{:.3f}\t{:.1f}\t{}\t{:.0f}\t{:.0f}\n", request.wales, request.courses,
             request.centreline, model.n_elements(), set_up, 200 * per_step, 1e9 * per_step / elements,
             solver.history().contacts, after_set_up, (memory("VmHWM") - empty) / elements);
}

}  // namespace
}  // namespace knitmech

int main(int argc, char** argv) {
  const std::string centreline = argc > 3 ? argv[3] : "";
  if (argc < 4 || (centreline != "smooth" && centreline != "chords")) {
    fmt::print(stderr, "usage: scale WALES COURSES smooth|chords [STEPS]\n");
    return 2;
  }
  knitmech::measure({std::atoi(argv[1]), std::atoi(argv[2]), centreline, argc > 4 ? std::atoi(argv[4]) : 400});
  return 0;
}
