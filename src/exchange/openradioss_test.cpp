#include <array>
#include <ostream>
#include <string_view>
#include <vector>

#include "exchange/constants.h"
#include "exchange/openradioss_parts.h"
#include "exchange/tie_equations.h"

namespace knitmech::exchange::radioss {

namespace {

/// /BCS (Radioss Reference Guide, "/BCS"). \param code "TTT RRR", 1 for what is held
void write_held(std::ostream& out, int number, std::string_view title, std::string_view code) {
  keyword(out, fmt::format("/BCS/{}", number), title, "#  Tra rot   skew_ID  grnod_ID");
  card(out, FixedCard().word(code).whole(0).whole(number));
}

/// /FUNCT (Radioss Reference Guide, "/FUNCT").
void write_velocity(std::ostream& out, const model::TensileTest& test) {
  keyword(out, fmt::format("/FUNCT/{}", kVelocity), "share of the speed over time",
          "#                  X                   Y");
  for (const auto& [time, share] : velocity_curve(test)) card(out, FixedCard().real(time).real(share));
}

/// /TH/NODE (Radioss Reference Guide, "/TH/NODE"): displacements and velocities, reaction along y.
void write_node_history(std::ostream& out, int number, std::string_view title, const std::vector<int>& nodes) {
  keyword(out, fmt::format("/TH/NODE/{}", number), title);
  out << "DEF       REACY     \n";
  for (const int node : nodes) card(out, FixedCard().whole(node).whole(0));
}

}  // namespace

/// /MPC (Radioss Reference Guide, "/MPC"): sum of coefficient times velocity = 0.
void write_ties(std::ostream& out, const model::Model& model) {
  if (model.ties.empty()) return;
  caption(out, "TIES: yarns that keep their relative position where they cross at the side edges");
  static constexpr std::array<char, 3> kAxes = {'x', 'y', 'z'};
  int number = 0;
  int tie = 0;
  for (const TieEquation& equation : tie_equations(model)) {
    ++tie;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      keyword(out, fmt::format("/MPC/{}", ++number), fmt::format("tie {} {}", tie, kAxes.at(axis)),
              "#  node_ID      Idof   skew_ID               alpha");
      for (const TieEquation::Term& term : equation.terms) {
        card(out, FixedCard().whole(term.node + 1).whole(static_cast<int>(axis) + 1).whole(0).real(term.coefficient));
      }
    }
  }
}

/// /IMPVEL (Radioss Reference Guide, "/IMPVEL"), along y in the global system.
void write_grips(std::ostream& out, const model::TensileTest& test) {
  caption(out, "GRIPS");
  write_held(out, kHeldNodes, test.held_set, "111 111");
  write_held(out, kDrivenNodes, test.driven_set, test.grips == model::Grips::clamped ? "101 111" : "000 111");
  write_held(out, kOrientationNodes, "orientation", "111 111");
  write_velocity(out, test);
  keyword(out, "/IMPVEL/1", test.driven_set, "# fct_IDT        Dir   skew_ID sensor_ID  grnod_ID  frame_ID     Icoor");
  card(out, FixedCard().whole(kVelocity).word("Y").whole(0).whole(0).whole(kDrivenNodes).whole(0).whole(0));
  out << "#           Ascale_x            Fscale_Y              Tstart               Tstop\n";
  card(out, FixedCard().real(1).real(test.speed).whole(0, 20).whole(0, 20));
}

/// /TH/INTER, /TH/PART (Radioss Reference Guide, the pages of these names). Energies of the whole, among them the
/// external work, are in the time history in any case.
void write_histories(std::ostream& out, const model::Model& model, const std::vector<int>& parts) {
  caption(out, "TIME HISTORIES");
  write_node_history(out, 1, model.test.driven_set, node_numbers(model, model.test.driven_set));
  write_node_history(out, 2, model.test.held_set, node_numbers(model, model.test.held_set));
  keyword(out, "/TH/INTER/3", "yarn on yarn");
  out << "DEF       \n" << cards_of_numbers({kContact}, kNumbersOnALine);
  keyword(out, "/TH/PART/4", "yarns");
  out << "DEF       \n" << cards_of_numbers(parts, kNumbersOnALine);
}

}  // namespace knitmech::exchange::radioss
