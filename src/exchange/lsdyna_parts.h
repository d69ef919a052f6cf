#pragma once

#include <fmt/format.h>

#include <ostream>
#include <string_view>
#include <vector>

#include "exchange/beam_deck.h"
#include "exchange/fixed_card.h"

/// The parts of an LS-DYNA deck, for lsdyna_*.cpp alone.
namespace knitmech::exchange::dyna {

/// Numbers of what the deck refers to.
inline constexpr int kHeldNodes = 1, kDrivenNodes = 2, kOrientationNodes = 3, kLeftEdge = 4, kRightEdge = 5;
inline constexpr int kYarns = 10;  ///< part set
inline constexpr int kVelocity = 1, kContact = 1, kFriction = 1;

inline void card(std::ostream& out, const FixedCard& fields) {
  out << fields.text() << '\n';
}

/// A real number that fills a field of ten columns.
inline FixedCard& real(FixedCard& fields, double value) {
  return fields.real(value, 10, 10);
}

/// A keyword, and the names of the fields of its first card.
inline void keyword(std::ostream& out, std::string_view name, std::string_view fields = "") {
  out << name << '\n';
  if (!fields.empty()) out << fields << '\n';
}

void write_parts(std::ostream& out, const model::Model& model, const std::vector<int>& parts, double mass_scaling);
void write_contact(std::ostream& out, const model::Model& model, const std::vector<int>& parts);
/// Model::ties as linear equations between the displacements of nodes.
void write_ties(std::ostream& out, const model::Model& model);
void write_grips(std::ostream& out, const model::TensileTest& test);

}  // namespace knitmech::exchange::dyna
