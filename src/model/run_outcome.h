#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace knitmech::model {

enum class RunStatus { completed, interrupted, failed };

/// A free yarn end that slipped out of a loop. The fabric ravels; no yarn passed through another.
struct Ravelling {
  double strain = 0;                  ///< [-]
  int yarn = 0;                       ///< whose end, index into Model::yarns
  bool is_last_end = false;           ///< the end at the yarn's last node, else that at its first
  std::optional<int> broken_end;      ///< the end is not one of these but where the yarn broke: its node
  int other_yarn = 0;                 ///< that it slipped over
  double other_place = 0;             ///< [mm], along the other yarn from its first node
  Eigen::Vector3d position{0, 0, 0};  ///< [mm], of that place

  template <class Archive>
  void serialize(Archive& archive) {
    archive(strain, yarn, is_last_end, broken_end, other_yarn, other_place, position);
  }
};

/// An element of a yarn whose axial force reached the strength of its section.
struct YarnBreak {
  double strain = 0;                  ///< [-], of the test
  int element = 0;                    ///< by its first node
  double axial_strain = 0;            ///< [-], of the element
  double axial_force = 0;             ///< [N], without viscosity
  Eigen::Vector3d position{0, 0, 0};  ///< [mm], of the element's middle

  template <class Archive>
  void serialize(Archive& archive) {
    archive(strain, element, axial_strain, axial_force, position);
  }
};

/// How a simulation ended. A simulation that cannot go on is an outcome with its reason, not an exception.
struct RunOutcome {
  RunStatus status = RunStatus::completed;
  std::string reason;  ///< failed, or completed before its end by a break: when, where and what happened; else empty
  std::string advice;  ///< failed: what to try
  double time = 0;     ///< [s], simulated
  double strain = 0;   ///< [-], reached
  long steps = 0;
  double smallest_step = 0;         ///< [s]
  double largest_penetration = 0;   ///< [mm], over the whole run
  double largest_tie_stretch = 0;   ///< [mm], by which a tie has given way, at any history row
  double mass_scaling = 1;          ///< factor used
  int threads = 1;                  ///< used by the solver
  int lost_crossings = 0;           ///< yarns that passed through each other
  long crossing_checks = 0;         ///< how often all crossings were checked
  std::vector<Ravelling> ravelled;  ///< in the order of time
  std::vector<YarnBreak> breaks;    ///< in the order of time
  double wall_seconds = 0;          ///< [s], real time in the solver

  template <class Archive>
  void serialize(Archive& archive) {
    archive(status, reason, advice, time, strain, steps, smallest_step, largest_penetration, largest_tie_stretch,
            mass_scaling, threads, lost_crossings, crossing_checks, ravelled, breaks, wall_seconds);
  }
};

}  // namespace knitmech::model
