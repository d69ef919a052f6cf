#include "run/run_estimate.h"

#include <algorithm>
#include <cmath>

#include "model/places.h"
#include "solve/constants.h"
#include "solve/mass_scaling.h"
#include "solve/threads.h"

namespace knitmech::run {
namespace {

/// Steps at an adapted speed, in units of gauge length / (kQuasiStaticSpeed sqrt(EI / (k l))), are kStartSteps to get
/// going and kStepsPerStrain for each unit of strain [-].
constexpr double kStartSteps = 0.095;
constexpr double kStepsPerStrain = 0.82;

/// Stable step of the contacts in units of sqrt(s rho A l / k) [-].
constexpr double kContactStep = 0.48;

/// Real time of a step on one thread of a laptop of 2022 [s]: per element, per stitch, and per stitch whose loops are
/// drawn tight.
constexpr double kSecondsPerElement = 0.022e-6;
constexpr double kSecondsPerStitch = 0.42e-6;
constexpr double kSecondsPerTightStitch = 8e-6;

/// Strain at which loops are drawn tight, in units of (H - T) / T [-].
constexpr double kTightShare = 0.55;

/// (H - T) / T of a usual jersey, for a fabric from a file, which does not say [-].
constexpr double kUsualOpenness = 0.4;

/// n threads are faster by n to this power [-].
constexpr double kThreadGain = 0.72;

/// What the steps of a run stand on.
struct StepScale {
  const model::Model& model;
  const yarn::Section& section;
  double half_stitch;  ///< l [mm]

  explicit StepScale(const model::Model& of)
      : model(of), section(of.sections.front()), half_stitch(of.half_stitch_length) {}

  /// Steps per mm of the grip at the speed that is allowed.
  [[nodiscard]] double per_length() const {
    return std::sqrt(half_stitch * model.contact_stiffness / section.bending_stiffness) / solve::kQuasiStaticSpeed;
  }
  [[nodiscard]] double contact_step(double mass_scaling) const {
    return kContactStep * std::sqrt(mass_scaling * section.mass_per_length * half_stitch / model.contact_stiffness);
  }
  /// Of the waves along an element of a length [mm].
  [[nodiscard]] double element_step(double mass_scaling, double length) const {
    return length * std::sqrt(mass_scaling * section.mass_per_length / section.axial_stiffness);
  }
};

double steps_to(const LoadedCase& loaded, double strain, double mass_scaling) {
  const StepScale scale(loaded.model);
  const model::TensileTest& test = loaded.model.test;
  if (solve::adapts_pace(loaded.input, mass_scaling)) {
    return test.gauge_length * scale.per_length() * (kStartSteps + kStepsPerStrain * strain);
  }
  const double element = loaded.model.has_stitches ? scale.half_stitch / loaded.input.fabric.elements_per_erc
                                                   : model::yarn_length_of(loaded.model) / loaded.model.n_elements();
  const double step = loaded.input.solver.step_factor *
                      std::min(scale.contact_step(mass_scaling), scale.element_step(mass_scaling, element));
  return test.time_at(strain) / step;
}

/// (H - T) / T [-].
double openness_of(const model::Case& input) {
  if (input.fabric.yarn_file) return kUsualOpenness;
  const double spacing = input.fabric.course_spacing;
  return (input.loop.height - spacing) / spacing;
}

double stitches_of(const LoadedCase& loaded) {
  const model::Case::Fabric& fabric = loaded.input.fabric;
  if (loaded.model.has_stitches) return static_cast<double>(fabric.wales) * fabric.courses;
  return model::yarn_length_of(loaded.model) / (2 * loaded.model.half_stitch_length);
}

}  // namespace

RunEstimate estimate_run(const LoadedCase& loaded) {
  const model::Model& model = loaded.model;
  const model::Case& input = loaded.input;
  const double mass_scaling =
      input.solver.mass_scaling ? *input.solver.mass_scaling : solve::automatic_mass_scaling(model);
  const double tight = std::min(model.test.strain, kTightShare * openness_of(input));
  const double steps = steps_to(loaded, model.test.strain, mass_scaling);
  const double tight_steps = steps - steps_to(loaded, tight, mass_scaling);
  const double stitches = stitches_of(loaded);
  const double on_one_thread = steps * (kSecondsPerElement * model.n_elements() + kSecondsPerStitch * stitches) +
                               tight_steps * kSecondsPerTightStitch * stitches;
  return {steps, on_one_thread / std::pow(solve::automatic_threads(model), kThreadGain)};
}

}  // namespace knitmech::run
