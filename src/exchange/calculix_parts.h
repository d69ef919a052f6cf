#pragma once

#include <iosfwd>
#include <set>
#include <string>
#include <vector>

#include "exchange/abaqus_parts.h"
#include "exchange/yarn_path.h"

/// Parts of a deck for CalculiX, for calculix_beams.cpp and calculix_solids.cpp alone.
namespace knitmech::exchange::deck {

/// Names in the deck of the sets of all nodes that a grip holds.
inline constexpr const char* kHeldGrip = "BOTTOM_FEET";
inline constexpr const char* kDrivenGrip = "TOP_HEADS";

/// The numbers of the nodes of both grips; ascending.
struct GripNodes {
  std::set<int> held, driven;

  void add(Grip grip, int node);
  [[nodiscard]] bool contains(int node) const { return held.contains(node) || driven.contains(node); }
};

/// Throws InputError where the deck could not be solved: a grip without nodes; a yarn that neither a grip nor a tie
/// holds; no way along yarns and ties from one grip to the other. \param touching_holds contact counts as a hold
void check_holds(const model::Model& model, const char* format, bool touching_holds);

/// The comment at the head of a deck.
void write_calculix_heading(std::ostream& out, const model::Model& model, const std::vector<std::string>& comments);

void write_grip_sets(std::ostream& out, const GripNodes& grips);

/// A node and its factor in a linear equation.
struct EquationTerm {
  int node = 0;  ///< number in the deck
  double coefficient = 0;
};

/// Three equations between displacements, sum of coefficient times displacement = 0, in x, y and z. A node that no grip
/// holds and no other equation eliminates comes first: CalculiX eliminates it. An equation between held nodes alone is
/// left out, as they do not move apart. \param eliminated nodes so far, to which this one's is added
void write_calculix_equations(std::ostream& out, std::vector<EquationTerm> terms, const GripNodes& grips,
                              std::set<int>& eliminated);

/// The static step: lines as they stand in the deck, each with its end of line.
struct StaticStep {
  std::string driven;                     ///< data lines of *BOUNDARY at the end of the step
  std::string controls;                   ///< keywords before *STATIC
  double increment = kCalculixIncrement;  ///< largest, as a share of the test [-]
  bool contact = false;
};
void write_static_step(std::ostream& out, const StaticStep& step);

}  // namespace knitmech::exchange::deck
