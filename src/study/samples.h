#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knitmech::study {

/// Points of the unit cube: n_samples rows of n_dimensions numbers in [0, 1).
using Samples = std::vector<std::vector<double>>;

/// A Latin hypercube: in each dimension every n-th part of [0, 1) has exactly one point, at random within it. The same
/// seed gives the same points on every machine.
///
/// Source: M. D. McKay, R. J. Beckman, W. J. Conover: A comparison of three methods for selecting values of input
/// variables in the analysis of output from a computer code. Technometrics 21 (1979), doi:10.2307/1268522.
[[nodiscard]] Samples latin_hypercube(std::size_t n_samples, std::size_t n_dimensions, std::uint64_t seed);

/// The first points of Sobol's sequence (Boost.Random), which leave out the origin: 0.5, then 0.75, 0.25, ...
///
/// Source: S. Joe, F. Y. Kuo: Constructing Sobol sequences with better two-dimensional projections. SIAM J. Sci.
/// Comput. 30 (2008), doi:10.1137/070709359.
[[nodiscard]] Samples sobol(std::size_t n_samples, std::size_t n_dimensions);

}  // namespace knitmech::study
