#pragma once

#include <chrono>
#include <string>

#include "schemes/force_curve.h"

namespace knitmech::bench {

/// What a way to the quasi-static curve came to.
struct SchemeResult {
  std::string name;
  long evaluations = 0;  ///< of all forces on the nodes
  double seconds = 0;    ///< [s]
  ForceCurve curve;
  std::string note;  ///< what else is to be told of it
};

/// Real time since it was made.
class Clock {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace knitmech::bench
