#pragma once

#include <iosfwd>
#include <string>

#include "exchange/lsdyna_deck.h"

namespace knitmech::exchange {

/// Reads an LS-DYNA keyword deck of beams: the keywords that write_lsdyna() writes, in any order, in the fixed columns
/// of the standard format.
///
/// Strict about columns: a value that does not stand in its field, a missing or superfluous card and a second
/// definition of a number are errors. Other keywords are passed over and listed in LsDynaDeck::unread. Throws
/// InputError "source, line n: ...". What refers to what is not looked at; check_lsdyna() does that. \param source name
/// of the file, for messages
[[nodiscard]] LsDynaDeck read_lsdyna(std::istream& in, const std::string& source);

/// Finds what a deck refers to and is not there, empty sets, beams with a node twice or of another formulation than the
/// resultant one, and nodes that are driven and held in the same direction or held and constrained. Throws InputError
/// for the first.
void check_lsdyna(const LsDynaDeck& deck, const std::string& source);

}  // namespace knitmech::exchange
