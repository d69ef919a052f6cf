#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/parameters.h"

namespace knitmech::study {

/// Which cases a study makes of its variations.
enum class Plan {
  grid,             ///< every value with every value of the others, the last variation changing fastest
  one_at_a_time,    ///< the base case, and each value alone in the base case
  latin_hypercube,  ///< samples of the ranges, each range cut into as many parts as there are samples
  sobol             ///< samples of the ranges in a sequence of low discrepancy
};

/// A parameter that a study varies: over a list of values, or, where the plan takes samples, over a range.
struct Variation {
  const model::Parameter* parameter = nullptr;
  std::vector<model::Value> values;  ///< may lie outside the parameter's range; empty for a sampled range
  double from = 0, to = 0;           ///< [internal units], ends of a sampled range
  bool logarithmic = false;          ///< the range is divided evenly in the logarithm
};

/// Measured fabric curves that each run is compared with, and how they are to be read (compare::SpecimenFacts).
struct Measured {
  std::vector<std::string> files;
  std::optional<double> gauge_length, width;  ///< [mm], of the specimens; empty: those of each run
  std::string load_column, extension_column;  ///< names in the files; empty: told by their heads
  std::vector<std::string> samples;           ///< names of specimens; empty: all
  double offset = 0;                          ///< slack that is taken from the measured strains [-]
  bool finds_offset = false;                  ///< takes the slack with the least difference instead
};

/// What a study file says.
struct Study {
  std::string title;
  std::filesystem::path file;
  model::Case base;
  Plan plan = Plan::grid;
  int samples = 0;         ///< of a plan that takes samples
  std::uint64_t seed = 0;  ///< of the random numbers of latin_hypercube
  std::vector<Variation> variations;
  std::vector<double> strains;       ///< [-], at which the runs are compared; ascending
  std::optional<Measured> measured;  ///< empty: nothing is compared with measurements
};

/// One case of a study.
struct Variant {
  std::string name;                  ///< of its run folder, unique in the study
  std::vector<model::Value> values;  ///< one for each variation, in their order
  model::Case input;                 ///< the case; that of the base where the complaint is not empty
  std::string complaint;             ///< why there can be no such case; empty: there can
};

/// The cases of a study, in the order of the plan. A value that its parameter does not allow, or a case that breaks a
/// rule, is a variant with a complaint: the others can be run.
[[nodiscard]] std::vector<Variant> variants_of(const Study& study);

/// "10", "0.12 mm", "tied": a value of a parameter in words. \param digits significant ones of a number; empty: all
[[nodiscard]] std::string value_text(const model::Parameter& parameter, const model::Value& value,
                                     std::optional<int> digits = {});

}  // namespace knitmech::study
