#pragma once

#include <fmt/format.h>

#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include "exchange/beam_deck.h"
#include "exchange/fixed_card.h"
#include "exchange/openradioss_writer.h"

/// The parts of an OpenRadioss deck, for openradioss_*.cpp alone.
namespace knitmech::exchange::radioss {

/// Numbers of what the deck refers to.
inline constexpr int kHeldNodes = 1, kDrivenNodes = 2, kOrientationNodes = 3, kLeftEdge = 4, kRightEdge = 5;
inline constexpr int kVelocity = 1, kLines = 1, kContact = 1, kFriction = 1;

inline void card(std::ostream& out, const FixedCard& fields) {
  out << fields.text() << '\n';
}

/// A keyword with its title, and the names of the fields of the card behind it where they are given.
inline void keyword(std::ostream& out, std::string_view name, std::string_view title, std::string_view fields = "") {
  out << name << '\n' << title << '\n';
  if (!fields.empty()) out << fields << '\n';
}

/// A comment between two groups of keywords.
inline void caption(std::ostream& out, std::string_view text) {
  out << "#\n# " << text << "\n#\n";
}

void write_materials_and_parts(std::ostream& out, const model::Model& model, const std::vector<int>& parts,
                               double mass_scaling);
void write_contact(std::ostream& out, const model::Model& model, const std::vector<int>& parts);
/// Model::ties as linear equations between the velocities of nodes.
void write_ties(std::ostream& out, const model::Model& model);
void write_grips(std::ostream& out, const model::TensileTest& test);
void write_histories(std::ostream& out, const model::Model& model, const std::vector<int>& parts);

}  // namespace knitmech::exchange::radioss
