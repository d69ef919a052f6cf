#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace knitmech::exchange {

/// Something in a deck that Abaqus would not take, or that this check does not know.
struct DeckFinding {
  int line = 0;  ///< from 1; 0: of the deck as a whole
  bool is_error = true;
  std::string message;  ///< one sentence
};

/// Checks an Abaqus/Explicit input file of beams against the published syntax of its keywords: each keyword is known
/// and stands in the part of the deck and after the keyword to which it belongs; its options are there if required, are
/// known, and have values that are allowed; its data lines are as many, with as many entries, of the kinds that its
/// page in the Abaqus Keywords Guide tells; each name is defined before it is used and not twice; sets are not empty.
/// Then read_abaqus() checks the numbers and what refers to what. A keyword that is not known here is a note, not an
/// error, unless it is nearly one that is. All findings, in the order of the lines.
[[nodiscard]] std::vector<DeckFinding> lint_abaqus(std::istream& in, const std::string& source);

}  // namespace knitmech::exchange
