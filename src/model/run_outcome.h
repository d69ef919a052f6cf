#pragma once

#include <string>

namespace knitmech::model {

enum class RunStatus { completed, interrupted, failed };

/// How a simulation ended. A simulation that cannot go on is an outcome with its reason, not an exception.
struct RunOutcome {
  RunStatus status = RunStatus::completed;
  std::string reason;  ///< failed: when, where and what happened; empty otherwise
  std::string advice;  ///< failed: what to try
  double time = 0;     ///< [s], simulated
  double strain = 0;   ///< [-], reached
  long steps = 0;
  double smallest_step = 0;        ///< [s]
  double largest_penetration = 0;  ///< [mm], over the whole run
  double mass_scaling = 1;         ///< factor used
  int lost_crossings = 0;          ///< yarns that passed through each other
  double wall_seconds = 0;         ///< [s], real time in the solver
};

}  // namespace knitmech::model
