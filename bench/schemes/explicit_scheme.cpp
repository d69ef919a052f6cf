#include "schemes/explicit_scheme.h"

#include "schemes/constants.h"
#include "solve/explicit_solver.h"
#include "solve/mass_scaling.h"

namespace knitmech::bench {

SchemeResult run_explicit(const model::Model& model, const ExplicitScheme& scheme) {
  const Clock clock;
  model::Model slowed = model;
  slowed.test.speed /= scheme.slower;
  slowed.test.ramp *= scheme.slower;
  solve::ExplicitSolver solver(slowed, {.mass_scaling = solve::automatic_mass_scaling(model),
                                        .bulk_viscosity = kBulkViscosity,
                                        .step_factor = kStepFactor,
                                        .adapts_pace = scheme.adapts_pace,
                                        .finest_length = scheme.selective_mass ? solve::selective_length(model) : 0});
  SchemeResult result{.name = scheme.name, .curve = ForceCurve(model.test.gauge_length), .note = {}};
  for (int i = 1; i <= kRows; ++i) {
    const double strain = model.test.strain * i / kRows;
    while (solver.strain() < strain && solver.is_finite()) solver.step();
    const model::HistoryRow row = solver.history();
    result.curve.add(row.strain, 0.5 * (row.force_top + row.force_bottom));
    if (!solver.is_finite() || solver.lost_crossing()) {
      result.note = "failed";
      break;
    }
  }
  result.evaluations = solver.steps();
  result.seconds = clock.seconds();
  return result;
}

}  // namespace knitmech::bench
