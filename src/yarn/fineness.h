#pragma once

#include <optional>

namespace knitmech::yarn {

/// How thick and how heavy a yarn is. Any two of the three tell the third: linear density = density pi D^2 / 4.
struct Fineness {
  std::optional<double> diameter{};        ///< D [mm]
  std::optional<double> linear_density{};  ///< [t/mm]; 1 tex = 1e-12 t/mm
  std::optional<double> density{};         ///< rho [t/mm^3], mass over the volume of a full circle of diameter D
};

/// The fineness with the third value, if two are given; as it is, if fewer are.
///
/// Throws InputError for values that are not positive, and for three that contradict each other by more than a
/// hundredth.
[[nodiscard]] Fineness completed(Fineness fineness);

}  // namespace knitmech::yarn
