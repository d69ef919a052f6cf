#pragma once

#include <vector>

#include "model/model.h"

namespace knitmech::exchange {

/// A tie as a linear equation between displacements, the same in each of the three directions:
///
///     sum of coefficient times displacement = 0,
///
/// on straight elements: displacement of the first place of the tie less that of the second. It has two to four terms;
/// those with a coefficient of 0 are left out.
struct TieEquation {
  struct Term {
    int node;  ///< from 0
    double coefficient;
  };
  std::vector<Term> terms;
};

/// The equations of Model::ties, in their order.
///
/// Programs eliminate the node of the first term (Abaqus Keywords Guide, *EQUATION). It is one that no other equation
/// eliminates, no grip holds and, where there is one, no other equation has. Throws std::invalid_argument where a tie
/// has no such node.
[[nodiscard]] std::vector<TieEquation> tie_equations(const model::Model& model);

}  // namespace knitmech::exchange
