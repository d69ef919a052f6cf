#include "study/samples.h"

#include <boost/random/sobol.hpp>
#include <numeric>
#include <random>
#include <utility>

namespace knitmech::study {
namespace {

/// An even number in [0, 1) of 53 random bits: the standard leaves its own distributions to the library.
double unit_number(std::mt19937_64& random) {
  constexpr int kSpareBits = 11;
  return static_cast<double>(random() >> kSpareBits) * 0x1p-53;
}

/// 0 to n - 1 in random order (Fisher and Yates).
std::vector<std::size_t> shuffled(std::size_t n, std::mt19937_64& random) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) {
    const auto other = static_cast<std::size_t>(unit_number(random) * static_cast<double>(i));
    std::swap(order[i - 1], order[other]);
  }
  return order;
}

}  // namespace

Samples latin_hypercube(std::size_t n_samples, std::size_t n_dimensions, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Samples samples(n_samples, std::vector<double>(n_dimensions));
  for (std::size_t dimension = 0; dimension < n_dimensions; ++dimension) {
    const std::vector<std::size_t> part = shuffled(n_samples, random);
    for (std::size_t i = 0; i < n_samples; ++i) {
      samples[i][dimension] = (static_cast<double>(part[i]) + unit_number(random)) / static_cast<double>(n_samples);
    }
  }
  return samples;
}

Samples sobol(std::size_t n_samples, std::size_t n_dimensions) {
  boost::random::sobol sequence(n_dimensions);
  const double span = static_cast<double>(boost::random::sobol::max()) + 1;
  Samples samples(n_samples, std::vector<double>(n_dimensions));
  for (auto& sample : samples) {
    for (double& number : sample) number = static_cast<double>(sequence()) / span;
  }
  return samples;
}

}  // namespace knitmech::study
