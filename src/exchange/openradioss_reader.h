#pragma once

#include <iosfwd>
#include <string>

#include "exchange/openradioss_deck.h"

namespace knitmech::exchange {

/// Reads a starter deck of OpenRadioss of beams: the keywords that write_openradioss_starter() writes, in any order, in
/// the columns of the format years 2018 to 2020.
///
/// Strict about columns: a value that does not stand in its field, a missing or superfluous card and a second
/// definition of a number are errors. Other keywords are passed over and listed in OpenRadiossDeck::unread. Throws
/// InputError "source, line n: ...". What refers to what is not looked at; check_openradioss() does that. \param source
/// name of the file, for messages
[[nodiscard]] OpenRadiossDeck read_openradioss_starter(std::istream& in, const std::string& source);

/// Reads an engine deck: the keywords that write_openradioss_engine() writes.
[[nodiscard]] OpenRadiossEngine read_openradioss_engine(std::istream& in, const std::string& source);

/// Finds what the two decks refer to and is not there, empty groups, beams with a node twice, nodes that are driven and
/// held in the same direction or held and constrained, friction formulations that are no stick, and starter and engine
/// of different runs. Throws InputError for the first.
void check_openradioss(const OpenRadiossDeck& starter, const OpenRadiossEngine& engine, const std::string& source);

}  // namespace knitmech::exchange
