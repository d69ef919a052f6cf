#pragma once

#include <functional>

#include "compare/simulated_curve.h"
#include "yarn/yarn_test.h"

namespace knitmech::test {

inline constexpr double kFabricWidth = 25;  // [mm]

/// A simulated curve of a fabric 25 mm wide whose force per width is a function of the strain.
inline compare::SimulatedCurve simulated(double end, const std::function<double(double)>& force_per_width) {
  compare::SimulatedCurve curve{
      .title = "known", .status = "completed", .width = kFabricWidth, .strains = {}, .forces = {}};
  constexpr int kPoints = 1000;
  for (int i = 0; i <= kPoints; ++i) {
    curve.strains.push_back(end * i / kPoints);
    curve.forces.push_back(kFabricWidth * force_per_width(curve.strains.back()));
  }
  return curve;
}

/// A measured mean whose force per width is a function of the strain, with a range of 10 % to either side.
inline yarn::MeanCurve measured(double from, double to, const std::function<double(double)>& force_per_width) {
  yarn::MeanCurve mean;
  mean.n_curves = 3;
  constexpr int kPoints = 1000;
  for (int i = 0; i <= kPoints; ++i) {
    mean.strains.push_back(from + (to - from) * i / kPoints);
    mean.forces.push_back(force_per_width(mean.strains.back()));
    mean.least.push_back(0.9 * mean.forces.back());
    mean.greatest.push_back(1.1 * mean.forces.back());
  }
  return mean;
}

}  // namespace knitmech::test
