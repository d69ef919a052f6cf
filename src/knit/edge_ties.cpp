#include "knit/edge_ties.h"

#include <set>

#include "knit/interlock.h"

namespace knitmech::knit {

std::vector<YarnTie> edge_ties(const Erc& erc, const FabricLayout& layout) {
  const double stitch = 2 * erc.length;
  const std::vector<PlanCrossing> crossings = plan_crossings(erc, layout.course_spacing, kCrossingPieces);
  std::vector<YarnTie> ties;
  for (int course = 0; course + 1 < layout.courses; ++course) {
    for (const int wale : std::set{0, layout.wales - 1}) {
      const auto tie = [&](double lower, double upper) {
        ties.push_back({{course, wale * stitch + lower}, {course + 1, wale * stitch + upper}});
      };
      // The crossings are those of the right half; the left one is its mirror image.
      for (const PlanCrossing& at : crossings) tie(erc.length - at.arc_length, stitch - at.upper_arc_length);
      for (const PlanCrossing& at : crossings) tie(erc.length + at.arc_length, at.upper_arc_length);
    }
  }
  return ties;
}

}  // namespace knitmech::knit
