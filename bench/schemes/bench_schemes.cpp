// Ways to the quasi-static curve of force over strain, on a small fabric of the main example: what they cost, and how
// far from a slow test they end.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "bench_fabric.h"
#include "schemes/dynamic_relaxation.h"
#include "schemes/explicit_scheme.h"
#include "schemes/newton.h"
#include "schemes/table.h"

namespace knitmech::bench {
namespace {

struct Options {
  int wales = 3, courses = 5;
  bool on_chords = false;
  double strain = 0.22;
  double friction = 0.1;
  double slower = 8;
  double budget = 120;
  std::string only;
};

Options read_options(int argc, char** argv, CLI::App& app) {
  Options options;
  app.add_option("--wales", options.wales, "of the fabric");
  app.add_option("--courses", options.courses, "of the fabric");
  app.add_flag("--chords", options.on_chords, "contact on chords in place of the smooth centreline");
  app.add_option("--strain", options.strain, "to which the fabric is pulled");
  app.add_option("--friction", options.friction, "coefficient mu of all yarns");
  app.add_option("--slower", options.slower, "by which the reference is slower than the model");
  app.add_option("--budget", options.budget, "seconds after which Newton's method ends");
  app.add_option("--only", options.only, "schemes with this in their name, besides the reference");
  app.parse(argc, argv);
  return options;
}

using Scheme = std::function<SchemeResult(const model::Model&)>;

struct NamedScheme {
  std::string name;
  Scheme run;
};

void add_explicit(std::vector<NamedScheme>& schemes, const ExplicitScheme& scheme) {
  schemes.push_back({scheme.name, [=](const model::Model& model) { return run_explicit(model, scheme); }});
}

void add_relaxation(std::vector<NamedScheme>& schemes, Relaxation scheme) {
  scheme.name = fmt::format("relaxation, {}{}, {:.2g} % steps, to {:.2g} %",
                            scheme.calming == Calming::kinetic ? "kinetic" : "viscous",
                            scheme.selective_mass ? ", selective" : "", 100 * scheme.increment, 100 * scheme.tolerance);
  schemes.push_back({scheme.name, [=](const model::Model& model) { return relax(model, scheme); }});
}

void add_newton(std::vector<NamedScheme>& schemes, Newton scheme) {
  scheme.name = fmt::format("Newton, {:.2g} % steps, to {:.2g} %", 100 * scheme.increment, 100 * scheme.tolerance);
  schemes.push_back({scheme.name, [=](const model::Model& model) { return run_newton(model, scheme); }});
}

std::vector<NamedScheme> all_schemes(double budget) {
  std::vector<NamedScheme> schemes;
  add_explicit(schemes, {.name = "explicit, constant speed"});
  add_explicit(schemes, {.name = "explicit, adapted pace", .adapts_pace = true});
  add_explicit(schemes, {.name = "explicit, constant speed, selective mass", .selective_mass = true});
  add_explicit(schemes,
               {.name = "explicit, adapted pace, selective mass", .adapts_pace = true, .selective_mass = true});
  for (const double increment : {1e-3, 4e-3}) {
    for (const Calming calming : {Calming::kinetic, Calming::viscous}) {
      add_relaxation(schemes, {.name = {}, .increment = increment, .calming = calming, .tolerance = 0.01});
    }
  }
  add_relaxation(schemes, {.name = {}, .increment = 1e-3, .calming = Calming::viscous, .tolerance = 0.001});
  add_relaxation(
      schemes, {.name = {}, .increment = 1e-3, .calming = Calming::viscous, .tolerance = 0.01, .selective_mass = true});
  for (const double increment : {1e-3, 4e-3}) {
    add_newton(schemes, {.name = {}, .increment = increment, .tolerance = 0.01, .budget = budget});
  }
  return schemes;
}

void compare(const Options& options) {
  model::Model model = main_example(10, options.wales, options.courses);
  model.centreline = options.on_chords ? model::Centreline::chords : model::Centreline::smooth;
  model.test.strain = options.strain;
  model.friction = options.friction;
  fmt::print("{} x {} stitches, {} elements, to {:.3g} % strain\n\n{}\n", options.wales, options.courses,
             model.n_elements(), 100 * options.strain, table_head());
  const auto print = [](const std::string& row) {
    fmt::print("{}\n", row);
    (void)std::fflush(stdout);
  };
  const SchemeResult reference = run_explicit(
      model, {.name = fmt::format("reference: explicit, speed / {:.3g}", options.slower), .slower = options.slower});
  print(table_row(reference, reference));
  for (const NamedScheme& scheme : all_schemes(options.budget)) {
    if (scheme.name.find(options.only) == std::string::npos) continue;
    print(table_row(scheme.run(model), reference));
  }
}

}  // namespace
}  // namespace knitmech::bench

int main(int argc, char** argv) try {
  CLI::App app{"Compares ways to the quasi-static curve of a small fabric"};
  try {
    knitmech::bench::compare(knitmech::bench::read_options(argc, argv, app));
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return 0;
} catch (const std::exception& error) {
  (void)std::fputs(error.what(), stderr);
  return 1;
}
