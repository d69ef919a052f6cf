// How near the kernels of the step come to what the machine can do.
//
//   roofline FOLDER
//
// writes two tables, tab separated with a line of titles: FOLDER/machine.tsv, peak and bandwidths on one thread and on
// all, and FOLDER/kernels.tsv, flops and bytes of every kernel for an element and a step (see kernels.h), what it
// attains in a fabric that fits the caches and in one that does not, and its share of the roof: of the lesser of the
// peak and of what the bandwidth feeds, that of the second-level cache or that of memory.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

#include "throughput/kernels.h"
#include "throughput/machine.h"
#include "throughput/main_example.h"

namespace knitmech::bench {
namespace {

struct Fabric {
  int wales, courses;
  bool fits_cache;
};

std::string machine_row(int threads, const Machine& machine) {
  return fmt::format("{}\t{:.1f}\t{:.1f}\t{:.1f}\n", threads, 1e-9 * machine.peak, 1e-9 * machine.cache,
                     1e-9 * machine.memory);
}

std::string kernel_row(const KernelTime& kernel, const Fabric& fabric, int threads, const Machine& machine) {
  const double flops = kernel.cost.flops / kernel.seconds;
  const double bytes = kernel.cost.bytes / kernel.seconds;
  const double intensity = kernel.cost.flops / kernel.cost.bytes;
  const double roof = std::min(machine.peak, intensity * (fabric.fits_cache ? machine.cache : machine.memory));
  return fmt::format("{}\t{} x {}\t{}\t{:.0f}\t{:.0f}\t{:.2f}\t{:.1f}\t{:.1f}\t{:.0f}\t{:.0f}\n", kernel.name,
                     fabric.wales, fabric.courses, threads, kernel.cost.flops, kernel.cost.bytes, intensity,
                     1e-9 * flops, 1e-9 * bytes, 100 * flops / roof, 1e-6 / kernel.seconds);
}

std::string kernel_rows(const Fabric& fabric, const std::map<int, Machine>& machines) {
  const model::Case input = case_of({.wales = fabric.wales, .courses = fabric.courses});
  const model::Model model = model::build_model(input);
  std::string rows;
  for (const auto& [threads, machine] : machines) {
    for (const KernelTime& kernel : time_kernels(model, settings_of(input, model, threads))) {
      rows += kernel_row(kernel, fabric, threads, machine);
    }
  }
  return rows;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error(fmt::format("{} cannot be written.", path.string()));
}

void measure(const std::filesystem::path& folder) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::map<int, Machine> machines;
  for (const int threads : {1, all}) {
    machines[threads] = measure_machine(base::ThreadTeam(static_cast<std::size_t>(threads)));
  }
  std::string machine_rows = "threads\tpeak [GFlop/s]\tcache [GB/s]\tmemory [GB/s]\n";
  for (const auto& [threads, machine] : machines) machine_rows += machine_row(threads, machine);
  std::string kernels =
      "kernel\tfabric\tthreads\tflops\tbytes\tflops / byte\tGFlop/s\tGB/s\tshare of the roof [%]\tmillion elements/s\n";
  for (const Fabric& fabric : {Fabric{9, 15, true}, Fabric{300, 300, false}}) kernels += kernel_rows(fabric, machines);
  write(folder / "machine.tsv", machine_rows);
  write(folder / "kernels.tsv", kernels);
}

}  // namespace
}  // namespace knitmech::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: roofline FOLDER\n");
    return 2;
  }
  try {
    knitmech::bench::measure(argv[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "roofline: {}\n", error.what());
    return 1;
  }
  return 0;
}
