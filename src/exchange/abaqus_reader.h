#pragma once

#include <iosfwd>
#include <string>

#include "exchange/abaqus_deck.h"

namespace knitmech::exchange {

/// Reads an Abaqus input file of beams: everything that write_abaqus() writes, in any order, case and spelling of
/// options that Abaqus takes (docs/abaqus.md), with comments and continued lines.
///
/// Keywords that mean nothing here are passed over and listed in AbaqusDeck::unread. Checks what a deck must keep:
/// every number is one, numbers are not given twice, every node, element, set, material, amplitude, surface and
/// interaction that is named exists, every element has one section, every step ends. Throws InputError "source, line n:
/// ..." for the first thing that is wrong, and for decks in parts and instances, or with *INCLUDE: they have to be
/// written as one flat file first.
/// @param source name of the file, for messages
[[nodiscard]] AbaqusDeck read_abaqus(std::istream& in, const std::string& source);

/// The checks of read_abaqus() on what refers to what; of use after a deck was changed.
void check_references(const AbaqusDeck& deck, const std::string& source);

}  // namespace knitmech::exchange
