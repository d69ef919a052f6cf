#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace knitmech::exchange {

/// The starter and engine decks of OpenRadioss as data: numbers as written, in whatever units the deck has, referred to
/// by the numbers that the deck gives them. Every `line` is that of the keyword or card, from 1.
struct OpenRadiossDeck {
  struct Material {
    double density = 0;
    double youngs_modulus = 0;
    double poissons_ratio = 0;
    int line = 0;
  };

  struct Property {
    double area = 0;
    double inertia_y = 0, inertia_z = 0;
    double torsion_constant = 0;
    bool shear = true;  ///< transverse shear is not left out: Ishear 0
    int line = 0;
  };

  struct Part {
    int property = 0, material = 0;
    double thickness = 0;
    int line = 0;
  };

  struct Beam {
    int part = 0;
    std::array<int, 3> nodes{};
    int line = 0;
  };

  struct Group {
    std::string title;
    std::vector<int> members;
    int line = 0;
  };

  struct Held {
    std::array<bool, 6> directions{};  ///< x, y, z, rotations about them
    int group = 0;
    int line = 0;
  };

  struct Function {
    std::vector<std::pair<double, double>> points;
    int line = 0;

    /// Linear between the points, constant before the first and after the last.
    [[nodiscard]] double value(double x) const;
  };

  struct Velocity {
    int function = 0;
    std::string direction;  ///< X, Y, Z, XX, ...
    int group = 0;
    double time_scale = 1, scale = 1;
    int line = 0;
  };

  struct Friction {
    int formulation = 0;  ///< 2: incremental
    double of_all = 0;
    std::map<std::pair<int, int>, double> of_pairs;  ///< by part
    int line = 0;
  };

  struct Contact {
    int secondary = 0, main = 0;  ///< lines; main 0: the secondary ones with themselves
    int stiffness_flag = 0;       ///< Istf
    int gap_flag = 0;             ///< Igap
    int removed_gap = 0;          ///< Irem_gap
    int friction_form = 0;        ///< Iform
    double stiffness = 0, friction = 0, gap = 0;
    int friction_table = 0;  ///< 0: none
    int line = 0;
  };

  /// sum of coefficient times velocity = 0
  struct Constraint {
    struct Term {
      int node = 0;
      int direction = 0;  ///< 1 to 6
      double coefficient = 0;
    };
    std::vector<Term> terms;
    int line = 0;
  };

  struct History {
    std::string kind;  ///< NODE, PART, INTER
    std::vector<std::string> variables;
    std::vector<int> members;
    int line = 0;
  };

  struct Unread {
    std::string keyword;
    int line = 0;
  };

  std::string run_name;
  int year = 0;
  std::array<std::string, 3> units;  ///< mass, length, time of the input
  std::string title;
  std::map<int, Material> materials;
  std::map<int, Property> properties;
  std::map<int, Part> parts;
  std::map<int, Eigen::Vector3d> nodes;
  std::map<int, Beam> beams;
  std::map<int, Group> groups;
  std::map<int, Group> lines;  ///< /LINE/PART; members: parts
  std::map<int, Held> held;
  std::map<int, Function> functions;
  std::map<int, Velocity> velocities;
  std::map<int, Friction> frictions;
  std::map<int, Contact> contacts;
  std::map<int, Constraint> constraints;
  std::map<int, History> histories;
  std::vector<Unread> unread;  ///< keywords that were passed over, with their cards
};

/// The engine deck of OpenRadioss.
struct OpenRadiossEngine {
  std::string run_name;
  int run = 0;
  double end_time = 0;
  int year = 0;
  double history_interval = 0;
  double first_picture = 0, picture_interval = 0;
  std::vector<std::string> vectors;  ///< of the pictures: DISP, CONT
  double step_share = 0;             ///< of the stable time step
  double least_step = 0;
  std::vector<OpenRadiossDeck::Unread> unread;
};

}  // namespace knitmech::exchange
