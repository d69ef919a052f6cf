#pragma once

#include <string>
#include <vector>

namespace knitmech::picture {

/// An axis that ends on round numbers.
struct Ticks {
  std::vector<double> values;       ///< ascending; evenly spaced multiples of 1, 2 or 5 times a power of ten
  std::vector<std::string> labels;  ///< the values, all with the same number of decimals

  [[nodiscard]] double first() const { return values.front(); }
  [[nodiscard]] double last() const { return values.back(); }
};

/// Ticks that enclose [lowest, highest] in about `intervals` steps (between half and twice as many).
///
/// A range of no width, or with an end that is not finite, is widened to one that has a width. intervals is at least 1.
[[nodiscard]] Ticks nice_ticks(double lowest, double highest, int intervals);

/// The same of a logarithmic axis: values are decadic logarithms, as the ends of the range are; labels are the numbers.
/// Powers of ten, and 2 and 5 times them where there are fewer than three of them.
[[nodiscard]] Ticks nice_log_ticks(double lowest, double highest);

/// The largest 1, 2 or 5 times a power of ten that is not above a positive limit.
[[nodiscard]] double round_number_below(double limit);

}  // namespace knitmech::picture
