#include "results/section_peaks.h"

#include <cmath>

namespace knitmech::results {

void update(SectionPeaks& peaks, const model::Frame& frame) {
  for (std::size_t k = 0; k < kPeakFields.size(); ++k) {
    const std::vector<double>& values = frame.*kPeakFields[k].values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double largest = peaks[k] ? std::abs(peaks[k]->value) : 0.0;
      if (std::abs(values[i]) > largest) peaks[k] = SectionPeak{values[i], frame.index, frame.history.strain, i};
    }
  }
}

}  // namespace knitmech::results
