#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "model/case.h"
#include "yarn/axial_law.h"
#include "yarn/section.h"

namespace knitmech::model {

/// One yarn of the model: its nodes are consecutive, and element i joins node i to node i + 1.
struct ModelYarn {
  int first_node = 0;
  int n_nodes = 0;
};

/// A place on a yarn: a share of the way along an element.
struct ElementPlace {
  int element = 0;   ///< by its first node
  double share = 0;  ///< in [0, 1]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(element, share);
  }
};

/// Two places that are tied to each other: they keep their relative position. See solve/ties.h.
struct Tie {
  ElementPlace first, second;
};

/// Names of the node sets that every fabric has. bottom_feet and top_heads are the grips.
inline constexpr const char* kBottomFeet = "bottom_feet";
inline constexpr const char* kTopHeads = "top_heads";
inline constexpr const char* kLeftEdge = "left_edge";
inline constexpr const char* kRightEdge = "right_edge";

/// The tensile test: one set held with all six degrees of freedom, the other driven along y.
struct TensileTest {
  std::string held_set = kBottomFeet;
  std::string driven_set = kTopHeads;
  Grips grips = Grips::clamped;
  double gauge_length =
      0;              ///< [mm], highest minus lowest centreline y at the start; strain = displacement / gauge_length
  double strain = 0;  ///< [-], at the end
  double speed = 0;   ///< [mm/s]
  double ramp = 0;    ///< [s], the speed grows linearly from 0 over this time, then stays
  OnBreak on_break = OnBreak::stop;  ///< what follows when a yarn breaks

  /// Displacement of the driven set [mm] at a time [s].
  [[nodiscard]] double displacement(double time) const;
  /// Velocity of the driven set [mm/s] at a time [s].
  [[nodiscard]] double velocity(double time) const;
  /// Time [s] at which a strain is reached.
  [[nodiscard]] double time_at(double strain) const;
};

/// Friction between two kinds of yarn, or of one kind with itself, where it is not Model::friction.
struct PairFriction {
  int first_section = 0, second_section = 0;  ///< indices into Model::sections, in any order
  double friction = 0;                        ///< mu [-]
};

/// The finite-element model: nodes, two-node beam elements along yarns, sections, node sets, contact, test.
///
/// Nodes are numbered along each yarn, yarn after yarn. Element i exists if node i is not the last of its yarn and
/// joins nodes i and i + 1; per-element vectors have one entry per node, the entry of a yarn's last node is unused.
struct Model {
  std::string title;
  std::vector<Eigen::Vector3d> nodes;     ///< [mm], stress-free
  std::vector<Eigen::Vector3d> tangents;  ///< unit tangents of the true centreline at the nodes
  /// [mm], point of the true centreline half the arc length from each node to the next, that of a yarn's last node
  /// unused. Empty: all yarns lie on the cubic curves through their nodes with their tangents.
  std::vector<Eigen::Vector3d> middles;
  std::vector<double> arc_length;  ///< [mm], along the true centreline from the yarn's first node
  std::vector<ModelYarn> yarns;
  std::vector<yarn::Section> sections;
  /// Of sections that follow a measured curve, by index; others are linear, N = EA strain. The section's EA is the
  /// law's slope at zero.
  std::map<int, yarn::AxialLaw> axial_laws;
  std::map<int, double> strengths;   ///< [N], axial force at which a section breaks, by index; others never do
  std::vector<int> element_section;  ///< index into sections, per element; a yarn's last entry repeats the one before
  std::vector<int> course, wale;     ///< of each node, counted from 0; knit::kNoWale on a turning arc between courses
  /// Whether course and wale are known. Not in a fabric from a file: there course is the number of the yarn, and wale
  /// is knit::kNoWale everywhere.
  bool has_stitches = true;
  std::vector<Tie> ties;
  std::map<std::string, std::vector<int>> node_sets;  ///< ascending node indices
  double half_stitch_length = 0;  ///< [mm], arc length of one ERC; from a file: mean length between turns along y
  double friction = 0;            ///< mu [-], of all pairs of yarns but those in pair_friction
  std::vector<PairFriction> pair_friction;
  double contact_stiffness = 0;  ///< [N/mm], penalty of one crossing
  Centreline centreline = Centreline::smooth;
  TensileTest test;

  [[nodiscard]] const yarn::Section& section_of(std::size_t element) const {
    return sections[static_cast<std::size_t>(element_section[element])];
  }
  [[nodiscard]] int n_nodes() const { return static_cast<int>(nodes.size()); }
  [[nodiscard]] int n_elements() const { return n_nodes() - static_cast<int>(yarns.size()); }
};

}  // namespace knitmech::model
