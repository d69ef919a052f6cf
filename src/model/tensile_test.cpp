#include <algorithm>
#include <cmath>

#include "model/model.h"

namespace knitmech::model {

double TensileTest::velocity(double time) const {
  if (time <= 0 && ramp > 0) return 0;
  return time < ramp ? speed * time / ramp : speed;
}

double TensileTest::displacement(double time) const {
  if (time <= 0) return 0;
  if (time < ramp) return 0.5 * speed * time * time / ramp;
  return speed * (time - 0.5 * ramp);
}

double TensileTest::time_at(double at_strain) const {
  const double wanted = std::max(0.0, at_strain * gauge_length);
  const double at_end_of_ramp = 0.5 * speed * ramp;
  if (wanted < at_end_of_ramp) return std::sqrt(2 * wanted * ramp / speed);
  return wanted / speed + 0.5 * ramp;
}

}  // namespace knitmech::model
