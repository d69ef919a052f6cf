#pragma once

#include <string>

#include "model/model.h"
#include "schemes/scheme.h"

namespace knitmech::bench {

struct Newton {
  std::string name;
  double increment = 0;  ///< of strain [-], the largest
  double tolerance = 0;  ///< residual over grip force [-], see StaticFabric::is_at_rest()
  double budget = 0;     ///< [s], processor time after which it ends
};

/// Newton's method in increments of strain that are cut where it fails and grow where it does not.
///
/// Every increment starts from an even stretch of the fabric at rest before it. An iteration solves
///
///     (M / tau^2 + K) dx = F,      K = -dF/dx,
///
/// with F all forces, friction with the motion since the last rest among them, and its derivatives complete but for
/// contacts that open or close (see jacobian()). M / tau^2 holds yarns that touch nothing and takes the fabric over
/// snaps; tau grows as the residual falls, so that the end is Newton's method itself, and falls where the residual
/// would grow (pseudo-transient continuation, Kelley and Keyes 1998).
[[nodiscard]] SchemeResult run_newton(const model::Model& model, const Newton& scheme);

}  // namespace knitmech::bench
