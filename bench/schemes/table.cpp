#include "schemes/table.h"

#include <fmt/format.h>

#include <cmath>

#include "schemes/constants.h"

namespace knitmech::bench {

namespace {

double percent(double value, double reference) {
  return 100 * (value / reference - 1);
}

/// Of the mean forces in windows that end where the reference does or before, in per cent, its sign kept.
double largest_difference(const ForceCurve& curve, const ForceCurve& reference) {
  double largest = 0;
  for (double from = kFirstWindow; from + kWindow < reference.end() + 0.5 * kWindow; from += kWindow) {
    const double difference =
        percent(curve.mean_force(from, from + kWindow), reference.mean_force(from, from + kWindow));
    if (std::abs(difference) > std::abs(largest)) largest = difference;
  }
  return largest;
}

}  // namespace

std::string table_head() {
  return fmt::format(
      "| {:<48} | {:>11} | {:>7} | {:>9} | {:>10} | {:>6} | {:>7} | {:>9} |\n|{:-<50}|{:->13}|{:->9}|{:->11}|{:->12}|"
      "{:->8}|{:->9}|{:->11}|",
      "scheme", "evaluations", "s", "work [mJ]", "force [mN]", "work", "force", "any force", "", ":", ":", ":", ":",
      ":", ":", ":");
}

std::string table_row(const SchemeResult& result, const SchemeResult& reference) {
  const std::string start =
      fmt::format("| {:<48} | {:>11} | {:>7.1f} |", result.name, result.evaluations, result.seconds);
  const double end = reference.curve.end();
  const bool is_whole = result.curve.end() > end - 1e-3;
  if (!is_whole) {
    const std::string where = fmt::format("{} ended at {:.2f} % strain", start, 100 * result.curve.end());
    if (result.curve.end() < kFirstWindow) return fmt::format("{}; {} |", where, result.note);
    const double reached = result.curve.end();
    return fmt::format("{}, work {:+.1f} % there; {} |", where,
                       percent(result.curve.work(reached), reference.curve.work(reached)), result.note);
  }
  const double work = result.curve.work(end);
  const double force = result.curve.mean_force(end - kWindow, end);
  return fmt::format("{} {:>9.4f} | {:>10.3f} | {:>+5.1f}% | {:>+6.1f}% | {:>+8.1f}% | {}", start, work, 1e3 * force,
                     percent(work, reference.curve.work(end)),
                     percent(force, reference.curve.mean_force(end - kWindow, end)),
                     largest_difference(result.curve, reference.curve), result.note);
}

}  // namespace knitmech::bench
