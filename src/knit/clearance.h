#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knit/erc.h"
#include "knit/fabric.h"

namespace knitmech::knit {

/// Which pieces of yarn come close to each other.
enum class Neighbours {
  next_course,     ///< a course and the one above it
  further_course,  ///< a course and the second, third ... above it
  next_wale,       ///< two loops side by side in one course
  same_loop        ///< a loop and itself, see kSelfContactArc
};

inline constexpr std::array kAllNeighbours = {Neighbours::next_course, Neighbours::further_course,
                                              Neighbours::next_wale, Neighbours::same_loop};
inline constexpr std::array kCourseNeighbours = {Neighbours::next_course, Neighbours::further_course};

/// A place in the fabric; course and wale count from 0.
struct Place {
  int course = 0;
  int wale = 0;
  ErcPiece piece = ErcPiece::head_flat;
};

/// Where two pieces of yarn come closest. All stitches are alike, so it stands for every such place in the fabric.
struct Approach {
  Neighbours neighbours = Neighbours::next_course;
  double gap = 0;  ///< [mm], distance of the centrelines minus the yarn diameter; negative where the yarns overlap
  Place a;
  Place b;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [mm], half way between the two centrelines
};

/// The closest places of a fabric, one for each of the wanted kinds that it has: a single course has no next course.
///
/// The centreline is taken as pieces_per_erc straight pieces of equal arc length on each ERC. With
/// layout.elements_per_erc that is the yarn as its elements see it, exactly; with kCurvePieces it is the true curve, up
/// to the sag of such a short piece. Because the fabric is periodic, one ERC and the 3 x 3 stitches around it stand for
/// the whole (and further courses, as far as they reach down), so the cost does not depend on the size of the fabric.
/// Within one course only yarn that comes back upon itself counts, see kSelfContactArc; a kind without any such place,
/// like the neighbouring wale of a very wide loop, has no entry. diameter: D of the yarn [mm].
[[nodiscard]] std::vector<Approach> closest_approaches(const Erc& erc, const FabricLayout& layout, double diameter,
                                                       int pieces_per_erc,
                                                       std::span<const Neighbours> wanted = kAllNeighbours);

/// The one with the least gap; empty if there is none.
[[nodiscard]] std::optional<Approach> least_gap(const std::vector<Approach>& approaches);

/// "the head arc of course 1, wale 2" with courses and wales counted from 1, for messages.
[[nodiscard]] std::string describe(const Place& place);

}  // namespace knitmech::knit
