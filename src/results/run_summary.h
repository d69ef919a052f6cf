#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/contact_summary.h"
#include "results/quality.h"
#include "results/ravelling.h"
#include "results/section_peaks.h"
#include "results/yarn_place.h"

namespace knitmech::results {

/// Where and when a section result of the yarns was largest.
struct StoredPeak {
  double value = 0;   ///< in the unit that kPeakFields[i].key ends with
  int frame = 0;      ///< index of the frame
  double strain = 0;  ///< [-], of that frame
  YarnPlace place;
};

/// A break of a yarn.
struct StoredBreak {
  double strain = 0;        ///< [-]
  double axial_force = 0;   ///< [N]
  double axial_strain = 0;  ///< [-]
  YarnPlace place;
  Eigen::Vector3d position{0, 0, 0};  ///< [mm]
};

/// A yarn end that slipped out of a loop.
struct StoredRavelling {
  double strain = 0;  ///< [-]
  RavelledPlace place;
  Eigen::Vector3d position{0, 0, 0};  ///< [mm]
};

/// What the summary.json of a run says (docs/results.md). What it does not say, because it is null, the run is still
/// under way or the file is of an older version, is empty.
struct RunSummary {
  std::string program_version, title;
  std::string status;          ///< "running", "completed", "interrupted" or "failed"
  std::string reason, advice;  ///< may be empty

  struct Model {
    int yarns = 0, nodes = 0, elements = 0;
    std::optional<double> gauge_length;       ///< [mm]
    std::optional<double> friction;           ///< [-]
    std::optional<double> contact_stiffness;  ///< [N/mm]
  } model;

  std::optional<double> mass_scaling;  ///< [-]
  std::optional<int> threads;
  std::optional<long> steps;
  std::optional<double> smallest_step;        ///< [s]
  std::optional<double> simulated_time;       ///< [s]
  std::optional<double> wall_seconds;         ///< [s], real time in the solver
  std::optional<double> element_steps_per_s;  ///< [1/s]

  std::optional<long> history_rows, n_frames;
  std::optional<double> strain;               ///< [-], reached
  std::optional<double> largest_penetration;  ///< [mm]
  std::optional<double> tie_stretch;          ///< [mm]; empty also without ties

  std::optional<ContactSummary> contacts;                                      ///< of the last frame
  std::optional<Quality> quality;                                              ///< empty while the run is under way
  std::array<std::optional<StoredPeak>, kPeakFields.size()> largest_in_yarns;  ///< in the order of kPeakFields
  std::vector<StoredRavelling> ravelled;                                       ///< in the order of time
  std::vector<StoredBreak> breaks;                                             ///< in the order of time
};

/// Reads a summary.json.
///
/// Throws FileError if the file cannot be read; InputError with its name if it is not the summary of a KnitMech run,
/// has a schema that this version does not know, or has an entry of the wrong kind.
[[nodiscard]] RunSummary read_summary(const std::filesystem::path& path);

}  // namespace knitmech::results
