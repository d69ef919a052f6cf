#pragma once

#include <ctime>
#include <string>

#include "schemes/force_curve.h"

namespace knitmech::bench {

/// What a way to the quasi-static curve came to.
struct SchemeResult {
  std::string name;
  long evaluations = 0;  ///< of all forces on the nodes
  double seconds = 0;    ///< of the processor [s]
  ForceCurve curve;
  std::string note;  ///< what else is to be told of it
};

/// Processor time of this program since it was made, which says more than real time on a machine that has other work;
/// all schemes use one thread.
class Clock {
 public:
  [[nodiscard]] double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace knitmech::bench
