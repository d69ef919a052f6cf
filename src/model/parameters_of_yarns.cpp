#include "model/parameters.h"

namespace knitmech::model {
namespace {

using base::Dimension;

// Upper ends of ranges are there to catch slips (a metre for a millimetre, per cent for a ratio), not to limit physics.
constexpr double kStiffestMaterial = 1e6;             // [MPa], about that of diamond
constexpr double kDensestMaterial = 1e5 / 1e12;       // [t/mm^3]
constexpr double kGreatestStiffness = 1e9;            // [N], [N mm^2]
constexpr double kThickestYarn = 100;                 // [mm]
constexpr double kMostFilaments = 1e6;                //
constexpr double kTightestTwist = 100;                // [1/mm]
constexpr double kGreatestStrain = 10;                // 1000 %
constexpr double kPerTonnePerCubicMillimetre = 1e12;  // [kg/m^3]

Range above_zero_to(double greatest) {
  return {.least = 0, .greatest = greatest, .least_excluded = true};
}
Range from(double least, double greatest) {
  return {.least = least, .greatest = greatest};
}

/// E, nu, G and the filaments of the yarn that a member of Case holds; none of them must be given.
template <auto member>
std::vector<Parameter> material_parameters(const std::string& section) {
  return {
      {.key = section + ".youngs_modulus",
       .symbol = "E",
       .dimension = Dimension::pressure,
       .need = Need::optional,
       .value = 1700.0,
       .range = above_zero_to(kStiffestMaterial),
       .help = "Young's modulus of a monofilament or of the filaments, with poissons_ratio or shear_modulus",
       .slot = [](Case& c) -> Slot { return &(c.*member).youngs_modulus; }},
      {.key = section + ".poissons_ratio",
       .symbol = "nu",
       .need = Need::optional,
       .value = 0.39,
       .range = {.least = -1, .greatest = 0.5, .least_excluded = true},
       .help = "Poisson's ratio of a monofilament or of the filaments",
       .slot = [](Case& c) -> Slot { return &(c.*member).poissons_ratio; }},
      {.key = section + ".shear_modulus",
       .symbol = "G",
       .dimension = Dimension::pressure,
       .need = Need::optional,
       .value = 611.5,
       .range = above_zero_to(kStiffestMaterial),
       .help = "shear modulus, in place of poissons_ratio: drawn fibres are softer in shear than their E and nu say",
       .slot = [](Case& c) -> Slot { return &(c.*member).shear_modulus; }},
      {.key = section + ".filaments",
       .symbol = "n",
       .need = Need::optional,
       .value = 24,
       .range = from(1, kMostFilaments),
       .help = "number of filaments of a multifilament yarn, with the next two and the material of one filament",
       .slot = [](Case& c) -> Slot { return &(c.*member).filaments; }},
      {.key = section + ".filament_diameter",
       .symbol = "d_f",
       .dimension = Dimension::length,
       .need = Need::optional,
       .value = 0.02,
       .range = above_zero_to(kThickestYarn),
       .help = "diameter of one filament",
       .slot = [](Case& c) -> Slot { return &(c.*member).filament_diameter; }},
      {.key = section + ".twist",
       .symbol = "t",
       .dimension = Dimension::inverse_length,
       .need = Need::optional,
       .value = 0.2,
       .range = from(0, kTightestTwist),
       .help = "turns of the filaments per length of yarn",
       .slot = [](Case& c) -> Slot { return &(c.*member).twist; }},
  };
}

std::vector<Parameter> yarn_diameter_and_density() {
  return {
      {.key = "yarn.diameter",
       .symbol = "D",
       .dimension = Dimension::length,
       .value = 0.12,
       .range = above_zero_to(kThickestYarn),
       .help = "diameter of the yarn",
       .slot = [](Case& c) -> Slot { return &c.yarn.diameter; }},
      {.key = "yarn.density",
       .symbol = "rho",
       .dimension = Dimension::density,
       .value = 1140 / kPerTonnePerCubicMillimetre,
       .range = above_zero_to(kDensestMaterial),
       .help =
           "mass per volume, of the filaments if they are given, of the yarn over its whole circular section if not",
       .slot = [](Case& c) -> Slot { return &c.yarn.density; }},
  };
}

std::vector<Parameter> yarn_stiffnesses() {
  return {
      {.key = "yarn.axial_stiffness",
       .symbol = "EA",
       .dimension = Dimension::force,
       .need = Need::optional,
       .value = 19.2,
       .range = above_zero_to(kGreatestStiffness),
       .help = "axial stiffness, with the next two in place of the material",
       .slot = [](Case& c) -> Slot { return &c.yarn.axial_stiffness; }},
      {.key = "yarn.bending_stiffness",
       .symbol = "EI",
       .dimension = Dimension::bending_stiffness,
       .need = Need::optional,
       .value = 0.0173,
       .range = above_zero_to(kGreatestStiffness),
       .help = "bending stiffness, the same about every axis of the section",
       .slot = [](Case& c) -> Slot { return &c.yarn.bending_stiffness; }},
      {.key = "yarn.torsional_stiffness",
       .symbol = "GJ",
       .dimension = Dimension::bending_stiffness,
       .need = Need::optional,
       .value = 0.0124,
       .range = above_zero_to(kGreatestStiffness),
       .help = "torsional stiffness",
       .slot = [](Case& c) -> Slot { return &c.yarn.torsional_stiffness; }},
      {.key = "yarn.curve_strains",
       .need = Need::optional,
       .value = std::vector<double>{0, 0.05, 0.1, 0.2},
       .range = from(0, kGreatestStrain),
       .help = "strains of a measured tensile curve, from 0 on, in place of youngs_modulus or axial_stiffness",
       .slot = [](Case& c) -> Slot { return &c.yarn.curve_strains; }},
      {.key = "yarn.curve_forces",
       .dimension = Dimension::force,
       .need = Need::optional,
       .value = std::vector<double>{0, 0.9, 1.6, 2.6},
       .range = from(0, kGreatestStiffness),
       .help = "the yarn's force at each of these strains, from 0 N on",
       .slot = [](Case& c) -> Slot { return &c.yarn.curve_forces; }},
      {.key = "yarn.strength",
       .dimension = Dimension::force,
       .need = Need::optional,
       .value = 6.0,
       .range = above_zero_to(kGreatestStiffness),
       .help = "tensile force at which the yarn breaks, see test.on_break; without it it never does",
       .slot = [](Case& c) -> Slot { return &c.yarn.strength; }},
  };
}

std::vector<Parameter> edge_diameter_and_density() {
  return {
      {.key = "edge_yarn.diameter",
       .symbol = "D",
       .dimension = Dimension::length,
       .need = Need::automatic,
       .value = 0.12,
       .range = above_zero_to(kThickestYarn),
       .help = "diameter of the edge yarn; auto takes that of the yarn",
       .slot = [](Case& c) -> Slot { return &c.edge_yarn.diameter; }},
      {.key = "edge_yarn.density",
       .symbol = "rho",
       .dimension = Dimension::density,
       .need = Need::automatic,
       .value = 1140 / kPerTonnePerCubicMillimetre,
       .range = above_zero_to(kDensestMaterial),
       .help = "mass per volume, as yarn.density; auto takes that of the yarn",
       .slot = [](Case& c) -> Slot { return &c.edge_yarn.density; }},
  };
}

std::vector<Parameter> edge_stiffnesses() {
  return {
      {.key = "edge_yarn.axial_stiffness",
       .symbol = "EA",
       .dimension = Dimension::force,
       .need = Need::automatic,
       .value = 19.2,
       .range = above_zero_to(kGreatestStiffness),
       .help = "axial stiffness; auto takes that of the yarn",
       .slot = [](Case& c) -> Slot { return &c.edge_yarn.axial_stiffness; }},
      {.key = "edge_yarn.bending_stiffness",
       .symbol = "EI",
       .dimension = Dimension::bending_stiffness,
       .need = Need::automatic,
       .value = 5e-6,
       .range = above_zero_to(kGreatestStiffness),
       .help = "bending stiffness; auto takes 5e-6 N mm^2, that of a soft multifilament",
       .slot = [](Case& c) -> Slot { return &c.edge_yarn.bending_stiffness; }},
      {.key = "edge_yarn.torsional_stiffness",
       .symbol = "GJ",
       .dimension = Dimension::bending_stiffness,
       .need = Need::automatic,
       .value = 3.6e-6,
       .range = above_zero_to(kGreatestStiffness),
       .help = "torsional stiffness; auto takes the same share of EI as in the yarn",
       .slot = [](Case& c) -> Slot { return &c.edge_yarn.torsional_stiffness; }},
  };
}

}  // namespace

std::vector<Parameter> parameters_of_yarns() {
  std::vector<Parameter> all;
  for (const auto& part :
       {yarn_diameter_and_density(), material_parameters<&Case::yarn>("yarn"), yarn_stiffnesses(),
        edge_diameter_and_density(), material_parameters<&Case::edge_yarn>("edge_yarn"), edge_stiffnesses()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  for (Parameter& parameter : all) {
    if (section_name_of(parameter.key) == "edge_yarn") parameter.from = FabricFrom::loops;
  }
  return all;
}

}  // namespace knitmech::model
