#pragma once

#include <string>

#include "model/model.h"
#include "model/run_outcome.h"

namespace knitmech::results {

/// Where a yarn end slipped out of a loop, in the words of the fabric; courses and wales count from 1 at the bottom
/// left.
struct RavelledPlace {
  int course = 0;        ///< of the yarn whose end it is; 0 where the stitches are not known, Model::has_stitches
  std::string side;      ///< "left" or "right": which of its ends; "broken": one that it has since it broke
  int other_course = 0;  ///< of the yarn that it slipped over; 0 where the stitches are not known
  int other_wale = 0;    ///< the same
  int yarn = 0;          ///< the yarn whose end it is, counted from 1
  int other_yarn = 0;    ///< that it slipped over
};

[[nodiscard]] RavelledPlace place_of(const model::Model& model, const model::Ravelling& event);

/// "the left end of course 3 over course 2, wale 1", "a broken end of course 3 over ..."; "the left end of yarn 3 over
/// yarn 2" where the stitches are not known. \param verb between the two ends, "slipped " or empty
[[nodiscard]] std::string ravelled_text(const RavelledPlace& place, const char* verb);

/// "Ravelling: 12 yarn ends slipped out of loops, first the left end of course 3 over course 2, wale 1, at 25.3 %
/// strain."; empty if none did.
[[nodiscard]] std::string ravelling_text(const model::Model& model, const model::RunOutcome& outcome);

}  // namespace knitmech::results
