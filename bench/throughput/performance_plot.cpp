// Draws docs/pictures/performance.svg.
//
//   performance_plot FOLDER PICTURE
//
// FOLDER has the tables of bench/renew_document.sh: throughput.tsv, curves.tsv, machine.tsv and kernels.tsv.

#include <cstdio>
#include <exception>
#include <string>

#include "picture/chart.h"
#include "results/atomic_file.h"
#include "throughput/table.h"

namespace knitmech::bench {
namespace {

constexpr int kWidth = 900;   // [px]
constexpr int kHeight = 420;  // [px]

std::string threads_text(const std::string& n) {
  return n + (n == "1" ? " thread" : " threads");
}

/// The series of a name, made if there is none yet.
picture::Series& series_of(const std::string& name, picture::Chart& chart) {
  for (picture::Series& series : chart.series) {
    if (series.name == name) return series;
  }
  return chart.series.emplace_back(picture::Series{name, {}, {}});
}

void add_point(double x, double y, picture::Series& series) {
  series.x.push_back(x);
  series.y.push_back(y);
}

picture::Chart throughput_chart(const Table& table) {
  picture::Chart chart{.title = "Throughput over the size of the fabric: lines from the start, where no yarn touches",
                       .x_label = "Elements [thousand]",
                       .y_label = "Throughput [million element-steps/s]",
                       .log_x = true,
                       .log_y = true,
                       .width = kWidth,
                       .height = kHeight};
  picture::Series touching{.name = "", .x = {}, .y = {}, .only_marks = true};
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    const std::string name = table.text(row, "centreline") + ", " + threads_text(table.text(row, "threads"));
    const double elements = 1e-3 * table.number(row, "elements");
    const double rate = table.number(row, "million element-steps/s");
    if (table.number(row, "strain [%]") == 0) {
      add_point(elements, rate, series_of(name, chart));
    } else {
      add_point(elements, rate, touching);
      chart.notes.push_back({elements, rate, name + ", at " + table.text(row, "strain [%]") + " % strain"});
    }
  }
  chart.series.push_back(touching);
  return chart;
}

picture::Chart times_chart(const Table& table) {
  picture::Chart chart{.title = "Time to a curve",
                       .x_label = "Elements per half stitch [-]",
                       .y_label = "Time [s]",
                       .width = kWidth,
                       .height = kHeight};
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    add_point(table.number(row, "N"), table.number(row, "time [s]"),
              series_of("to " + table.text(row, "strain [%]") + " % strain", chart));
  }
  return chart;
}

/// What a bandwidth feeds at intensities from `lowest` on, up to the peak.
picture::Series roof(const std::string& name, double peak, double bandwidth, double lowest, double highest) {
  return {name, {lowest, peak / bandwidth, highest}, {bandwidth * lowest, peak, peak}};
}

/// One thread only.
picture::Chart roofline_chart(const Table& machine, const Table& kernels) {
  constexpr double kLowest = 0.05;  // [1/byte]
  constexpr double kHighest = 10;   // [1/byte]
  picture::Chart chart{.title = "Kernels under the roof, one thread",
                       .x_label = "Operations per byte [1/byte]",
                       .y_label = "Operations per second [GFlop/s]",
                       .log_x = true,
                       .log_y = true,
                       .width = kWidth,
                       .height = kHeight + 60};
  const double peak = machine.number(0, "peak [GFlop/s]");
  chart.series = {roof("roof, cache", peak, machine.number(0, "cache [GB/s]"), kLowest, kHighest),
                  roof("roof, memory", peak, machine.number(0, "memory [GB/s]"), kLowest, kHighest)};
  const std::string first_fabric = kernels.text(0, "fabric");
  bool at_left = false;  // in turn: some kernels are close neighbours
  for (std::size_t row = 0; row < kernels.n_rows(); ++row) {
    if (kernels.text(row, "threads") != "1") continue;
    const double x = kernels.number(row, "flops / byte");
    const double y = kernels.number(row, "GFlop/s");
    picture::Series& fabric = series_of("fabric " + kernels.text(row, "fabric"), chart);
    fabric.only_marks = true;
    add_point(x, y, fabric);
    if (kernels.text(row, "fabric") == first_fabric)
      chart.notes.push_back({x, y, kernels.text(row, "kernel"), at_left});
    at_left = !at_left;
  }
  return chart;
}

void draw(const std::string& folder, const std::string& picture) {
  results::write_file_atomically(
      picture,
      picture::charts_svg({throughput_chart(read_table(folder + "/throughput.tsv")),
                           times_chart(read_table(folder + "/curves.tsv")),
                           roofline_chart(read_table(folder + "/machine.tsv"), read_table(folder + "/kernels.tsv"))}));
}

}  // namespace
}  // namespace knitmech::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: performance_plot FOLDER PICTURE\n", stderr);
    return 2;
  }
  try {
    knitmech::bench::draw(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "performance_plot: %s\n", error.what());
    return 1;
  }
  return 0;
}
