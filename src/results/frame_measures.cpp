#include "results/frame_measures.h"

#include <algorithm>
#include <limits>

namespace knitmech::results {
namespace {

/// Least and greatest of numbers; both zero if there were none.
class Span {
 public:
  void add(double value) {
    least_ = std::min(least_, value);
    greatest_ = std::max(greatest_, value);
  }
  [[nodiscard]] bool is_empty() const { return least_ > greatest_; }
  [[nodiscard]] double least() const { return is_empty() ? 0 : least_; }
  [[nodiscard]] double greatest() const { return is_empty() ? 0 : greatest_; }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double greatest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

FrameMeasures measure_frame(const model::Frame& frame) {
  Span x, z;
  for (const Eigen::Vector3d& point : frame.points) {
    if (!point.allFinite()) continue;
    x.add(point.x());
    z.add(point.z());
  }
  FrameMeasures measures{.index = frame.index,
                         .strain = frame.history.strain,
                         .lowest_z = z.least(),
                         .highest_z = z.greatest(),
                         .contacts = static_cast<int>(frame.contacts.size()),
                         .contacts_in_middle = {},
                         .force_in_middle = {}};
  const double third = (x.greatest() - x.least()) / 3;
  int in_middle = 0;
  double force = 0, force_in_middle = 0;
  for (const model::ContactRecord& contact : frame.contacts) {
    const double place = contact.position.x() - x.least();
    const bool is_in_middle = place >= third && place <= 2 * third;
    force += contact.normal_force;
    if (!is_in_middle) continue;
    ++in_middle;
    force_in_middle += contact.normal_force;
  }
  if (measures.contacts > 0) measures.contacts_in_middle = static_cast<double>(in_middle) / measures.contacts;
  if (force > 0) measures.force_in_middle = force_in_middle / force;
  return measures;
}

}  // namespace knitmech::results
