#include "throughput/machine.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "base/vectorise.h"
#include "throughput/stopwatch.h"

namespace knitmech::bench {

namespace {

/// A register of the widest kind; two or four where the processor has narrower ones.
using Lanes [[gnu::vector_size(64)]] = double;
constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(double);

/// Chains of x <- a x + b that do not wait for each other [-]: as many as hide how long a product and a sum take on two
/// units of each kind, and with a and b no more than there are registers of 256 bits.
constexpr std::size_t kChains = 14;
constexpr int kRepeats = 10000;

/// Returns something that depends on all of it, so that it is not left out.
KNITMECH_VECTORISE double multiply_and_add(double a, double b) {
  std::array<Lanes, kChains> x{};
  // From different starts, or the compiler would see that they are all the same.
  for (std::size_t c = 0; c < kChains; ++c) x[c] += static_cast<double>(c);
  for (int i = 0; i < kRepeats; ++i) {
#pragma GCC unroll 14
    for (std::size_t c = 0; c < kChains; ++c) x[c] = a * x[c] + b;
  }
  double sum = 0;
  for (const Lanes& chain : x) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) sum += chain[lane];
  }
  return sum;
}

KNITMECH_VECTORISE void triad(double* __restrict a, const double* b, const double* c, double s, std::size_t begin,
                              std::size_t end) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) a[i] = b[i] + s * c[i];
}

double peak(const base::ThreadTeam& team) {
  constexpr double kOperations = 2.0 * kChains * kLanes * kRepeats;
  std::vector<double> results(team.size());
  const double seconds = shortest_time([&] {
    team.run([&](std::size_t part) { results[part] = multiply_and_add(0.5, static_cast<double>(part + 1)); });
  });
  for (std::size_t part = 0; part < team.size(); ++part) {
    if (results[part] != 2.0 * static_cast<double>((part + 1) * kChains * kLanes)) {
      throw std::logic_error("x <- x / 2 + b must end at 2 b.");
    }
  }
  return kOperations * static_cast<double>(team.size()) / seconds;
}

/// \param n entries of each array for each thread   \param passes over them in one go
double bandwidth(const base::ThreadTeam& team, std::size_t n, int passes) {
  const std::size_t all = n * team.size();
  std::vector<double> a(all), b(all, 1.0), c(all, 2.0);
  const double seconds = shortest_time([&] {
    team.for_ranges(all, n, [&](std::size_t begin, std::size_t end) {
      for (int pass = 0; pass < passes; ++pass) triad(a.data(), b.data(), c.data(), 0.5 * pass, begin, end);
    });
  });
  return 4.0 * sizeof(double) * static_cast<double>(all) * passes / seconds;
}

}  // namespace

Machine measure_machine(const base::ThreadTeam& team) {
  constexpr std::size_t kInCache = 20'000;      // entries, 480 kB in the three arrays
  constexpr std::size_t kInMemory = 8'000'000;  // entries, 192 MB
  return {peak(team), bandwidth(team, kInCache, 100), bandwidth(team, kInMemory, 1)};
}

}  // namespace knitmech::bench
