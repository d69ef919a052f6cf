#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knitmech::exchange {

/// An Abaqus input file as data. Labels (names of sets, materials, ...) are in capitals, as Abaqus sees them; numbers
/// are as written, in whatever units the deck has. Every `line` is the line of the keyword or data it comes from,
/// from 1.
struct AbaqusDeck {
  struct Element {
    std::string type;        ///< B31, ...
    std::vector<int> nodes;  ///< node numbers
    int line = 0;
  };

  struct Set {
    std::vector<int> members;  ///< numbers, ascending, each once
    int line = 0;              ///< of its first definition
  };

  enum class SectionKind { beam, general_beam };

  struct Section {
    SectionKind kind = SectionKind::beam;  ///< *BEAM SECTION or *BEAM GENERAL SECTION
    std::string element_set;
    std::string shape;                        ///< CIRC, GENERAL, ...
    std::string material;                     ///< *BEAM SECTION
    std::vector<double> dimensions;           ///< first data line; CIRC: radius; GENERAL: A, I11, I12, I22, J
    Eigen::Vector3d first_axis = {0, 0, -1};  ///< n1, second data line; Abaqus' default if that is not given
    double density = 0;                       ///< *BEAM GENERAL SECTION
    std::vector<double> moduli;               ///< *BEAM GENERAL SECTION, third data line: E, G
    /// SECTION=NONLINEAR GENERAL: *AXIAL, ELASTIC, strain and force; ascending.
    std::vector<std::pair<double, double>> axial_curve;
    double axial = 0, bending_1 = 0, bending_2 = 0, torsion = 0;  ///< the same: *AXIAL, *M1, *M2, *TORQUE, LINEAR
    std::string rotary_inertia = "EXACT";
    std::vector<double> transverse_shear;  ///< K23, K13, slenderness compensation; empty if not given
    int line = 0;
  };

  struct Material {
    double density = 0;
    double youngs_modulus = 0;
    double poissons_ratio = 0;
    int line = 0;
  };

  struct Amplitude {
    std::vector<std::pair<double, double>> points;  ///< time, value; times ascending
    int line = 0;

    /// Linear between the points, constant before the first and after the last.
    [[nodiscard]] double value(double time) const;
  };

  struct Boundary {
    std::string nodes;  ///< a node set, or the number of a node
    int first_dof = 0;
    int last_dof = 0;
    double value = 0;
    std::string type = "DISPLACEMENT";
    std::string amplitude;  ///< empty if there is none
    int line = 0;
  };

  struct Surface {
    std::string type = "ELEMENT";
    std::vector<std::string> sets;  ///< element sets
    int line = 0;
  };

  struct Interaction {
    double friction = 0;
    std::string pressure_overclosure = "HARD";
    int line = 0;
  };

  struct Contact {
    bool all_exterior = false;
    std::vector<std::pair<std::string, std::string>> inclusions;  ///< surfaces
    struct Property {
      std::string surface_a, surface_b, interaction;
    };
    std::vector<Property> properties;
    std::map<std::string, double> thickness;  ///< by surface
    int line = 0;
  };

  /// sum of coefficient times displacement = 0
  struct Equation {
    struct Term {
      std::string nodes;  ///< a node set, or the number of a node
      int dof = 0;
      double coefficient = 0;
    };
    std::vector<Term> terms;
    int line = 0;
  };

  struct OutputRequest {
    std::string kind;                            ///< NODEOUTPUT, ELEMENTOUTPUT, CONTACTOUTPUT, ENERGYOUTPUT
    bool history = false;                        ///< history or field
    std::map<std::string, std::string> options;  ///< of the request and its *OUTPUT
    std::vector<std::string> variables;
    int line = 0;
  };

  struct Step {
    std::string name;
    bool large_displacements = false;  ///< NLGEOM=YES
    bool explicit_dynamics = false;
    double duration = 0;
    double linear_bulk_viscosity = 0.06;
    double quadratic_bulk_viscosity = 1.2;
    std::optional<double> mass_scaling;  ///< FACTOR of *FIXED MASS SCALING on all elements
    std::vector<Boundary> boundaries;
    std::vector<OutputRequest> output;
    int line = 0;
  };

  struct Unread {
    std::string keyword;
    int line = 0;
  };

  std::vector<std::string> heading;
  std::map<int, Eigen::Vector3d> nodes;  ///< by number
  std::map<int, Element> elements;       ///< by number
  std::map<std::string, Set> node_sets;
  std::map<std::string, Set> element_sets;
  std::vector<Section> sections;
  std::map<std::string, Material> materials;
  std::map<std::string, Amplitude> amplitudes;
  std::map<std::string, Surface> surfaces;
  std::map<std::string, Interaction> interactions;
  std::vector<Equation> equations;
  std::optional<Contact> contact;
  std::vector<Boundary> boundaries;  ///< model data, outside any step
  std::vector<Step> steps;
  std::vector<Unread> unread;  ///< keywords that were passed over, with their data
};

}  // namespace knitmech::exchange
