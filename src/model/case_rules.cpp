#include "model/case_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace knitmech::model {
namespace {

/// A model of this size needs about 20 GB; what is larger is a slip of the keyboard.
constexpr double kMostElements = 20e6;

std::optional<BrokenRule> yarn_rule(const Case::Yarn& yarn) {
  const int from_material = (yarn.youngs_modulus ? 1 : 0) + (yarn.poissons_ratio ? 1 : 0);
  const int outright =
      (yarn.axial_stiffness ? 1 : 0) + (yarn.bending_stiffness ? 1 : 0) + (yarn.torsional_stiffness ? 1 : 0);
  const char* const either_or =
      "give either youngs_modulus and poissons_ratio, or axial_stiffness, bending_stiffness and torsional_stiffness";
  const auto missing = [&](const char* key) {
    return BrokenRule{std::string("yarn.") + key, fmt::format("is missing; {}", either_or)};
  };
  if (from_material > 0 && outright > 0) {
    const char* key = yarn.axial_stiffness     ? "yarn.axial_stiffness"
                      : yarn.bending_stiffness ? "yarn.bending_stiffness"
                                               : "yarn.torsional_stiffness";
    return BrokenRule{key, fmt::format("the yarn's stiffness is given twice; {}", either_or)};
  }
  if (outright > 0) {
    if (!yarn.axial_stiffness) return missing("axial_stiffness");
    if (!yarn.bending_stiffness) return missing("bending_stiffness");
    if (!yarn.torsional_stiffness) return missing("torsional_stiffness");
    return std::nullopt;
  }
  if (!yarn.youngs_modulus) return missing("youngs_modulus");
  if (!yarn.poissons_ratio) return missing("poissons_ratio");
  return std::nullopt;
}

std::optional<BrokenRule> frames_rule(const Case& input) {
  const auto beyond =
      std::ranges::find_if(input.output.frames_at, [&](double strain) { return strain > input.test.strain; });
  if (beyond == input.output.frames_at.end()) return std::nullopt;
  return BrokenRule{
      "output.frames_at",
      fmt::format("the frame at strain {} lies beyond the end of the test; remove it or raise test.strain, "
                  "which is {}",
                  *beyond, input.test.strain)};
}

std::optional<BrokenRule> size_rule(const Case::Fabric& fabric) {
  const double elements = 2.0 * fabric.elements_per_erc * fabric.wales * fabric.courses;
  if (elements <= kMostElements) return std::nullopt;
  return BrokenRule{"fabric.elements_per_erc",
                    fmt::format("the fabric would have {:.0f} elements (2 x {} elements_per_erc x {} wales x {} "
                                "courses), but at most {:.0f} are possible; make one of the three smaller",
                                elements, fabric.elements_per_erc, fabric.wales, fabric.courses, kMostElements)};
}

}  // namespace

std::optional<BrokenRule> broken_rule(const Case& input) {
  if (auto broken = yarn_rule(input.yarn)) return broken;
  if (auto broken = frames_rule(input)) return broken;
  return size_rule(input.fabric);
}

void cut_frames_to_test(Case& input) {
  std::erase_if(input.output.frames_at, [&](double strain) { return strain > input.test.strain; });
}

}  // namespace knitmech::model
