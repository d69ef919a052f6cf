#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <string>
#include <vector>

#include "exchange/calculix_parts.h"
#include "exchange/tube_hexahedra.h"
#include "exchange/yarn_path.h"
#include "model/model.h"

/// How the grips hold yarns that are solids, for calculix_solids.cpp alone.
namespace knitmech::exchange::deck {

/// The end of a free piece of yarn at a grip, held as a clamp holds a rod: it stays plane and keeps its direction, its
/// centre and its twist, and is free to grow and shrink across the yarn. A section with all nodes held could not
/// contract, which stiffens a loop by 2 % and more (docs/calculix.md).
struct ClampedSection {
  std::string name;
  Eigen::Vector3d along, across, other;  ///< axes 1, 2 and 3 of its nodes; 1 along the yarn
  std::vector<int> nodes;  ///< numbers in the deck; the first and third lie on axis 2, the second and fourth on axis 3
  Grip grip = Grip::none;
};

/// \param number of the section, for its name \param ring nodes of the section in the tube
/// \param first_node number of the tube's first node in the deck
[[nodiscard]] ClampedSection clamped_section(int number, const PathPoint& place, const TubeHexahedra& tube,
                                             const std::vector<int>& ring, int first_node);

/// Sets and axes of the sections, and the conditions of the held grip: model data.
/// \param bodies nodes of the parts of the yarns in the grips, all of which are held
void write_clamps(std::ostream& out, const std::vector<ClampedSection>& sections, const GripNodes& bodies);

/// Data lines of *BOUNDARY for the driven grip at the end of the step.
[[nodiscard]] std::string driven_conditions(const std::vector<ClampedSection>& sections, const GripNodes& bodies,
                                            const model::TensileTest& test);

}  // namespace knitmech::exchange::deck
