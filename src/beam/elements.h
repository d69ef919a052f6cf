#pragma once

#include <vector>

#include "model/model.h"

namespace knitmech::beam {

/// The two-node shear-flexible beam elements of a model as a struct of arrays.
///
/// Entry i joins node i to node i + 1. The entry that starts at the last node of a yarn joins it to the first node of
/// the next: it has no stiffness, so every array runs through all yarns without a break and without indices. All
/// vectors have n_nodes entries.
struct Elements {
  std::vector<double> axis_x, axis_y, axis_z;  ///< unit vector along the stress-free chord
  std::vector<double> inverse_length;          ///< 1/L0 [1/mm]
  std::vector<double> axial;                   ///< EA [N]; N / strain where a measured curve is followed
  std::vector<double> stiffest;                ///< [N], largest dN / d(strain): EA, or largest slope of the curve
  std::vector<double> shear;                   ///< k G A', after slenderness compensation [N]
  std::vector<double> torsion;                 ///< GJ [N mm^2]
  std::vector<double> bending;                 ///< EI [N mm^2]
  std::vector<double> fold;                    ///< k [N mm] of FoldLimit; 0 where there is none
  std::vector<double> mass;                    ///< of the whole element, not scaled [t]
  std::vector<double> viscosity;               ///< bulk viscosity force per axial speed difference [N s/mm]

  [[nodiscard]] std::size_t size() const { return inverse_length.size(); }

  /// Frees what only the set-up needs: `stiffest`, `fold` and `mass`.
  void forget_set_up() {
    for (auto* of_set_up : {&stiffest, &fold, &mass}) std::vector<double>().swap(*of_set_up);
  }
};

/// The shear stiffness that a slender element works with, so that shear does not rule the time step:
///
///     k G A' = k G A / (1 + 0.25 L0^2 A / (12 I)),
///
/// as Abaqus does it for B31 (Abaqus Theory Guide, "Shear flexible small-strain beams", slenderness compensation
/// factor). For a circle A / I = 16 / D^2; with stiffnesses given outright, Section::slenderness() stands for it.
/// \param length L0 [mm]
[[nodiscard]] double compensated_shear_stiffness(const yarn::Section& section, double length);

/// Cuts the yarns of a model into elements.
/// \param mass_scaling factor on all masses; enters the viscosity only, `mass` stays unscaled
/// \param bulk_viscosity linear coefficient b1 [-]: axial force b1 rho c A (v_b - v_a) . t along the chord, t its
/// direction, with c = sqrt(E / rho), E that of the largest slope of a measured curve
[[nodiscard]] Elements make_elements(const model::Model& model, double mass_scaling, double bulk_viscosity);

}  // namespace knitmech::beam
