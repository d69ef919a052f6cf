#include "study/compare_runs.h"

#include "compare/measured_curve.h"
#include "compare/simulated_curve.h"

namespace knitmech::study {

compare::Comparison compare_run(const std::filesystem::path& run_folder, const Measured& measured) {
  const compare::SimulatedCurve simulated = compare::read_simulated_curve(run_folder);
  const compare::SpecimenFacts facts{.gauge_length = measured.gauge_length.value_or(simulated.gauge_length),
                                     .width = measured.width.value_or(simulated.width),
                                     .columns = {.load = measured.load_column, .extension = measured.extension_column},
                                     .samples = measured.samples};
  return compare::compare(simulated, compare::read_measured_curve(measured.files, facts).mean,
                          {.at = {}, .offset = measured.offset, .finds_offset = measured.finds_offset});
}

}  // namespace knitmech::study
