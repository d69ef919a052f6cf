#include "compare/measured_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/errors.h"
#include "base/text.h"
#include "yarn/curve_file.h"

namespace knitmech::compare {
namespace {

using Specimens = std::vector<yarn::TensileCurve>;

Specimens read_specimens(const std::vector<std::string>& files, const SpecimenFacts& facts) {
  const yarn::TestFacts of_test{.gauge_length = facts.gauge_length, .width = facts.width, .columns = facts.columns};
  Specimens all;
  for (const std::string& file : files) {
    for (yarn::TensileCurve& curve : yarn::read_tensile_curves(yarn::curve_file_bytes(file), file, of_test)) {
      all.push_back(std::move(curve));
    }
  }
  return all;
}

[[noreturn]] void refuse_sample(const std::string& sample, const Specimens& all) {
  std::vector<std::string_view> names;
  for (const yarn::TensileCurve& curve : all) {
    if (std::ranges::find(names, curve.specimen) == names.end()) names.push_back(curve.specimen);
  }
  throw InputError(fmt::format("no specimen is called {}; there {} {}", base::in_quotes(sample),
                               names.size() == 1 ? "is" : "are", base::alternatives(names)));
}

/// Those with the wanted names, in the order of the files.
Specimens chosen(Specimens all, const std::vector<std::string>& samples) {
  for (const std::string& sample : samples) {
    if (std::ranges::find(all, sample, &yarn::TensileCurve::specimen) == all.end()) refuse_sample(sample, all);
  }
  if (samples.empty()) return all;
  std::erase_if(all, [&](const yarn::TensileCurve& curve) {
    return std::ranges::find(samples, curve.specimen) == samples.end();
  });
  return all;
}

}  // namespace

MeasuredCurve average(Specimens specimens, double width) {
  MeasuredCurve result;
  for (yarn::TensileCurve& curve : specimens) {
    result.per_width = result.per_width || curve.per_width;
    curve = yarn::up_to_break(curve);
  }
  result.mean = yarn::mean_of(specimens);
  for (std::vector<double>* forces : {&result.mean.forces, &result.mean.least, &result.mean.greatest}) {
    for (double& force : *forces) force /= width;
  }
  result.specimens = std::move(specimens);
  return result;
}

MeasuredCurve read_measured_curve(const std::vector<std::string>& files, const SpecimenFacts& facts) {
  return average(chosen(read_specimens(files, facts), facts.samples), facts.width);
}

}  // namespace knitmech::compare
