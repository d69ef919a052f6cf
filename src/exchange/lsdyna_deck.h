#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace knitmech::exchange {

/// An LS-DYNA keyword deck of beams as data: numbers as written, in whatever units the deck has, referred to by the
/// numbers that the deck gives them. Every `line` is that of the keyword or card, from 1.
struct LsDynaDeck {
  struct Section {
    int formulation = 0;  ///< ELFORM
    double area = 0, inertia_s = 0, inertia_t = 0, torsion_constant = 0, shear_area = 0;
    int line = 0;
  };

  struct Material {
    double density = 0;
    double youngs_modulus = 0;
    double poissons_ratio = 0;
    int line = 0;
  };

  struct Part {
    std::string title;
    int section = 0, material = 0;
    int line = 0;
  };

  struct Beam {
    int part = 0;
    std::array<int, 3> nodes{};
    int line = 0;
  };

  struct Group {
    std::vector<int> members;
    int line = 0;
  };

  struct Held {
    std::array<bool, 6> directions{};  ///< x, y, z, rotations about them
    int group = 0;
    int line = 0;
  };

  struct Curve {
    std::vector<std::pair<double, double>> points;
    int line = 0;

    /// Linear between the points, constant before the first and after the last.
    [[nodiscard]] double value(double x) const;
  };

  struct Motion {
    int group = 0;
    int direction = 0;  ///< 1 to 3
    int kind = 0;       ///< VAD: 0 velocity, 1 acceleration, 2 displacement
    int curve = 0;
    double scale = 0;
    int line = 0;
  };

  struct Friction {
    double of_all = 0;
    std::map<std::pair<int, int>, double> of_pairs;  ///< by part
    int line = 0;
  };

  struct Contact {
    int group = 0;               ///< SSID
    int group_kind = 0;          ///< SSTYP: 2 a part set
    double friction = 0;         ///< FS; -2: that of a table
    int friction_table = 0;      ///< FD, if FS is -2
    double stiffness_scale = 0;  ///< SFS
    double thickness = 0;        ///< SST, MST
    int soft = 0;
    int line = 0;
  };

  /// sum of coefficient times displacement = 0
  struct Constraint {
    struct Term {
      int node = 0;
      int direction = 0;  ///< 1 to 6
      double coefficient = 0;
    };
    std::vector<Term> terms;
    int line = 0;
  };

  struct Unread {
    std::string keyword;
    int line = 0;
  };

  std::string title;
  std::array<std::string, 3> units;  ///< length, time, mass
  double end_time = 0;
  double step_share = 0;                    ///< TSSFAC
  std::map<std::string, double> intervals;  ///< of *DATABASE_..., by what follows: GLSTAT, BINARY_D3PLOT
  std::vector<int> history_groups;          ///< node sets of *DATABASE_HISTORY_NODE_SET
  int histories_line = 0;
  std::map<int, Section> sections;
  std::map<int, Material> materials;
  std::map<int, Part> parts;
  std::map<int, Eigen::Vector3d> nodes;
  std::map<int, Beam> beams;
  std::map<int, Group> groups;       ///< node sets
  std::map<int, Group> part_groups;  ///< part sets
  std::vector<Held> held;
  std::map<int, Curve> curves;
  std::vector<Motion> motions;
  std::map<int, Friction> frictions;
  std::vector<Contact> contacts;
  std::map<int, Constraint> constraints;
  std::vector<Unread> unread;  ///< keywords that were passed over, with their cards
};

}  // namespace knitmech::exchange
