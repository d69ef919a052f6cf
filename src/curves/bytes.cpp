#include "curves/bytes.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"

namespace knitmech::curves {

void put_point(std::string& bytes, const Eigen::Vector3d& point) {
  for (const double value : point) {
    const auto stored = static_cast<float>(value);
    if (!std::isfinite(stored)) {
      throw InputError(fmt::format("a yarn has a coordinate of {:g}, which this format cannot hold", value));
    }
    put(bytes, stored);
  }
}

Eigen::Vector3d point_at(std::string_view bytes, std::size_t place) {
  constexpr std::size_t kNumber = sizeof(float);
  return {number_at<float>(bytes, place), number_at<float>(bytes, place + kNumber),
          number_at<float>(bytes, place + 2 * kNumber)};
}

}  // namespace knitmech::curves
