#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.h"

namespace knitmech::exchange {

/// What decks of elastic beams for OpenRadioss and LS-DYNA have in common: the model in their terms.

/// A yarn section as an elastic beam of one material:
///
///     E = EA / A,  I = EI / E,  J = GJ / G,  G = E / (2 (1 + nu)),  with A = pi D^2 / 4,
///
/// so that the products EA, EI and GJ are those of the yarn. nu is that of the material where the yarn is a solid
/// circle of one with nu from 0 to 0.5 (and then J = 2 I); else 0, and E, G, I and J mean nothing one by one.
struct BeamSection {
  double diameter = 0;          ///< D [mm]
  double area = 0;              ///< A [mm^2]
  double inertia = 0;           ///< I [mm^4], about both axes
  double torsion_constant = 0;  ///< J [mm^4]
  double shear_area = 0;        ///< k A [mm^2], k G A that of the yarn
  double youngs_modulus = 0;    ///< E [MPa]
  double poissons_ratio = 0;    ///< nu [-]
  double density = 0;           ///< rho [t/mm^3], times the mass scaling
};

/// \param mass_scaling factor on the density, > 0
[[nodiscard]] BeamSection beam_section(const yarn::Section& section, double mass_scaling);

/// An element of a deck; all numbers from 1.
struct BeamElement {
  int part = 0;             ///< index of its section into Model::sections, plus 1
  int first = 0, last = 0;  ///< nodes
  int third = 0;            ///< node that spans the plane of its first axis with the other two
};

/// Nodes of the model have their index plus 1; those of orientation follow. Elements are numbered along the yarns.
struct BeamMesh {
  std::vector<BeamElement> elements;
  /// [mm], far from the fabric along a coordinate axis each, so that no element points at its own within 45 degrees.
  /// They have no mass and are held.
  std::vector<Eigen::Vector3d> orientation_nodes;
};

[[nodiscard]] BeamMesh beam_mesh(const model::Model& model);

/// The parts that have elements, ascending.
[[nodiscard]] std::vector<int> used_parts(const BeamMesh& mesh);

/// Friction of pairs of parts that both have elements, where it is not Model::friction.
[[nodiscard]] std::vector<model::PairFriction> used_pair_friction(const model::Model& model,
                                                                  const std::vector<int>& parts);

/// Whether all parts have the same yarn diameter.
[[nodiscard]] bool have_one_diameter(const model::Model& model, const std::vector<int>& parts);

/// Length of the shortest element [mm].
[[nodiscard]] double shortest_element(const model::Model& model);

/// Velocity of the driven grip as a share of the test's speed: times [s] and values [-], linear between them, from 0 to
/// far behind the end of the test. See TensileTest::velocity().
[[nodiscard]] std::vector<std::pair<double, double>> velocity_curve(const model::TensileTest& test);

/// [s]
[[nodiscard]] double test_duration(const model::TensileTest& test);

/// Nodes of a set, numbered from 1.
[[nodiscard]] std::vector<int> node_numbers(const model::Model& model, const std::string& set);

/// Throws InputError for a model with a measured yarn curve, which an elastic beam does not have, and
/// std::invalid_argument for one whose grips are not among its node sets or are empty.
/// \param program its name, for the message
void check_for_elastic_deck(const model::Model& model, std::string_view program);

/// What the head of a deck says of differences to KnitMech: where the contact sees the yarns, and yarns that break.
[[nodiscard]] std::vector<std::string> difference_remarks(const model::Model& model);

}  // namespace knitmech::exchange
