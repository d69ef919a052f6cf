#include "model/case_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "model/constants.h"
#include "model/sections.h"

namespace knitmech::model {
namespace {

/// A key that is given or missing.
struct YarnKey {
  const char* name;
  bool given;
};

const YarnKey* first(const std::vector<YarnKey>& keys, bool given) {
  const auto found = std::ranges::find(keys, given, &YarnKey::given);
  return found == keys.end() ? nullptr : &*found;
}

constexpr const char* kWaysToGiveAYarn =
    "give either youngs_modulus and poissons_ratio or shear_modulus, with filaments, filament_diameter and twist for a "
    "multifilament; or axial_stiffness, bending_stiffness and torsional_stiffness";

/// What a yarn's keys say about its stiffness, in the words of the case file.
struct YarnKeys {
  std::vector<YarnKey> modulus, shear, filaments, outright;
};

YarnKeys keys_of(const YarnStiffness& yarn) {
  return {
      .modulus = {{"youngs_modulus", yarn.youngs_modulus.has_value()}},
      .shear = {{"poissons_ratio", yarn.poissons_ratio.has_value()}, {"shear_modulus", yarn.shear_modulus.has_value()}},
      .filaments = {{"filaments", yarn.filaments.has_value()},
                    {"filament_diameter", yarn.filament_diameter.has_value()},
                    {"twist", yarn.twist.has_value()}},
      .outright = {{"axial_stiffness", yarn.axial_stiffness.has_value()},
                   {"bending_stiffness", yarn.bending_stiffness.has_value()},
                   {"torsional_stiffness", yarn.torsional_stiffness.has_value()}}};
}

BrokenRule broken_at(const std::string& section, const char* key, const std::string& complaint) {
  return {section + "." + key, complaint};
}

/// The material of a monofilament or of filaments: all of E, one of nu and G, all or none of the filaments' keys.
/// \param has_curve a measured curve stands for E
std::optional<BrokenRule> material_rule(const YarnKeys& keys, const std::string& section, bool has_curve) {
  const auto missing = [&](const char* key) {
    return broken_at(section, key, fmt::format("is missing; {}", kWaysToGiveAYarn));
  };
  if (!has_curve && first(keys.modulus, false) != nullptr) return missing("youngs_modulus");
  if (first(keys.shear, true) == nullptr) return missing("poissons_ratio");
  if (first(keys.shear, false) == nullptr) {
    return broken_at(section, "shear_modulus", "is given beside poissons_ratio; keep one of the two");
  }
  if (first(keys.filaments, true) == nullptr) return std::nullopt;
  if (const YarnKey* key = first(keys.filaments, false)) return missing(key->name);
  return std::nullopt;
}

/// \param is_complete whether stiffnesses that are not given stay open
std::optional<BrokenRule> stiffness_rule(const YarnStiffness& yarn, const std::string& section, bool is_complete,
                                         bool has_curve) {
  const YarnKeys keys = keys_of(yarn);
  const YarnKey* outright = first(keys.outright, true);
  for (const auto* group : {&keys.modulus, &keys.shear, &keys.filaments}) {
    const YarnKey* material = first(*group, true);
    if (material == nullptr) continue;
    if (outright != nullptr) {
      return broken_at(
          section, outright->name,
          fmt::format("the yarn's stiffness is given twice, here and by {}; {}", material->name, kWaysToGiveAYarn));
    }
    return material_rule(keys, section, has_curve);
  }
  if (!is_complete) return std::nullopt;
  if (outright == nullptr) return material_rule(keys, section, has_curve);
  for (const YarnKey& key : keys.outright) {
    const bool by_curve = has_curve && key.name == keys.outright.front().name;
    if (!key.given && !by_curve) return broken_at(section, key.name, fmt::format("is missing; {}", kWaysToGiveAYarn));
  }
  return std::nullopt;
}

std::optional<BrokenRule> strength_rule(const Case& input) {
  const auto law = axial_law_of(input);
  if (!law || !input.yarn.strength || std::isfinite(law->strain_at(*input.yarn.strength))) return std::nullopt;
  return BrokenRule{"yarn.strength",
                    fmt::format("{} N is never reached by yarn.curve_forces, which end flat at {} N; give a strength "
                                "that is not above it",
                                *input.yarn.strength, input.yarn.curve_forces.back())};
}

std::optional<BrokenRule> curve_rule(const Case& input) {
  const Case::Yarn& yarn = input.yarn;
  const auto broken = [](const char* key, std::string complaint) { return BrokenRule{key, std::move(complaint)}; };
  if (yarn.curve_strains.empty() != yarn.curve_forces.empty() ||
      yarn.curve_strains.size() != yarn.curve_forces.size()) {
    return broken("yarn.curve_forces",
                  fmt::format("has {} forces for the {} strains of yarn.curve_strains; give as many",
                              yarn.curve_forces.size(), yarn.curve_strains.size()));
  }
  if (yarn.curve_strains.empty()) return std::nullopt;
  if (yarn.youngs_modulus || yarn.axial_stiffness) {
    return broken(yarn.youngs_modulus ? "yarn.youngs_modulus" : "yarn.axial_stiffness",
                  "is given beside yarn.curve_strains; the curve takes its place, so remove one of the two");
  }
  if (yarn.filaments) return broken("yarn.filaments", "cannot go with a measured curve; remove one of the two");
  try {
    static_cast<void>(axial_law_of(input));
  } catch (const InputError& error) {
    return broken("yarn.curve_forces", std::string("and yarn.curve_strains are no tensile curve: ") + error.what());
  }
  return strength_rule(input);
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
  if (auto broken = curve_rule(input)) return broken;
  if (auto broken = stiffness_rule(input.yarn, "yarn", true, !input.yarn.curve_strains.empty())) return broken;
  if (auto broken = stiffness_rule(input.edge_yarn, "edge_yarn", false, false)) return broken;
  if (auto broken = frames_rule(input)) return broken;
  return size_rule(input.fabric);
}

void cut_frames_to_test(Case& input) {
  std::erase_if(input.output.frames_at, [&](double strain) { return strain > input.test.strain; });
}

}  // namespace knitmech::model
