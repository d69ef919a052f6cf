#include "exchange/lsdyna_writer.h"

#include <fmt/format.h>

#include <numeric>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exchange/abaqus_number.h"
#include "exchange/constants.h"
#include "exchange/lsdyna_parts.h"

namespace knitmech::exchange {

namespace {

using dyna::card;
using dyna::keyword;
using dyna::real;

/// What OpenRadioss, as its reader stands, does not make of this deck, but of its native one.
std::vector<std::string> openradioss_remarks(const model::Model& model, const std::vector<int>& parts) {
  std::vector<std::string> remarks;
  const auto add = [&](std::string_view what) {
    remarks.push_back(fmt::format("OpenRadioss {}; its native deck has that.", what));
  };
  if (!model.ties.empty()) add("does not read the ties of this deck");
  if (!used_pair_friction(model, parts).empty()) add("does not take the friction of pairs of yarns from this deck");
  if (!have_one_diameter(model, parts)) add("takes all yarns of this deck for as thick as that of section 1");
  return remarks;
}

/// *TITLE, *CONTROL_UNITS (LS-DYNA Keyword User's Manual I, the pages of these names). OpenRadioss takes its units from
/// the latter.
void write_head(std::ostream& out, const model::Model& model, const std::vector<int>& parts,
                const LsDynaOptions& options) {
  out << "*KEYWORD\n";
  out << "$ A knitted fabric, yarn by yarn, in a tensile test; written by KnitMech.\n";
  out << "$ Units: mass t, length mm, time s; hence force N, stress MPa, energy mJ, density t/mm^3.\n";
  out << "$ x runs along the courses, y along the wales, z out of the plane of the fabric.\n";
  out << fmt::format("$ {} {}, {} nodes, {} beam elements; the density is {:.6g} times that of the yarn.\n",
                     model.yarns.size(), model.yarns.size() == 1 ? "yarn" : "yarns", model.n_nodes(),
                     model.n_elements(), options.mass_scaling);
  out << fmt::format("$ Strain = displacement of {} / {:.12g} mm.\n", model.test.driven_set, model.test.gauge_length);
  out << "$ Two lines of *CONTACT_AUTOMATIC_GENERAL are for OpenRadioss; for LS-DYNA change them as it says there.\n";
  for (const std::string& remark : openradioss_remarks(model, parts)) out << "$ " << remark << '\n';
  for (const std::string& remark : difference_remarks(model)) out << "$ " << remark << '\n';
  out << "*TITLE\n" << ("KnitMech: " + abaqus_text(model.title)).substr(0, kDynaTitle) << '\n';
  keyword(out, "*CONTROL_UNITS", "$   LENGTH      TIME      MASS");
  out << fmt::format("{:<10}{:<10}{:<10}\n", "mm", "sec", "mtrc_ton");
}

/// A keyword whose only card begins with an interval of time [s].
void write_interval(std::ostream& out, std::string_view name, double interval) {
  keyword(out, name, "$       DT");
  FixedCard fields;
  card(out, real(fields, interval));
}

/// *CONTROL_TERMINATION, *CONTROL_TIMESTEP, *CONTROL_ENERGY, *DATABASE_option, *DATABASE_BINARY_D3PLOT,
/// *DATABASE_HISTORY_NODE_SET (LS-DYNA Keyword User's Manual I, the pages of these names).
void write_control(std::ostream& out, const model::Model& model, const LsDynaOptions& options) {
  const double duration = test_duration(model.test);
  FixedCard end, step;
  keyword(out, "*CONTROL_TERMINATION", "$   ENDTIM");
  card(out, real(end, duration));
  keyword(out, "*CONTROL_TIMESTEP", "$   DTINIT    TSSFAC");
  card(out, real(step.whole(0), kStepShare));
  keyword(out, "*CONTROL_ENERGY", "$     HGEN      RWEN    SLNTEN     RYLEN");
  card(out, FixedCard().whole(1).whole(1).whole(2).whole(1));
  for (const char* name :
       {"*DATABASE_GLSTAT", "*DATABASE_MATSUM", "*DATABASE_BNDOUT", "*DATABASE_SPCFORC", "*DATABASE_NODOUT"}) {
    write_interval(out, name, duration / options.history_points);
  }
  write_interval(out, "*DATABASE_BINARY_D3PLOT", duration / options.pictures);
  keyword(out, "*DATABASE_HISTORY_NODE_SET", "$      ID1       ID2");
  card(out, FixedCard().whole(dyna::kHeldNodes).whole(dyna::kDrivenNodes));
}

/// *NODE, *ELEMENT_BEAM (LS-DYNA Keyword User's Manual I, the pages of these names).
void write_mesh(std::ostream& out, const model::Model& model, const BeamMesh& mesh) {
  keyword(out, "*NODE", "$    NID               X               Y               Z");
  int number = 0;
  const auto write = [&](const Eigen::Vector3d& node) {
    card(out, FixedCard().whole(++number, 8).real(node.x(), 16).real(node.y(), 16).real(node.z(), 16));
  };
  for (const Eigen::Vector3d& node : model.nodes) write(node);
  for (const Eigen::Vector3d& node : mesh.orientation_nodes) write(node);
  keyword(out, "*ELEMENT_BEAM", "$    EID     PID      N1      N2      N3");
  number = 0;
  for (const BeamElement& element : mesh.elements) {
    card(out, FixedCard()
                  .whole(++number, 8)
                  .whole(element.part, 8)
                  .whole(element.first, 8)
                  .whole(element.last, 8)
                  .whole(element.third, 8));
  }
}

/// *SET_NODE_LIST (LS-DYNA Keyword User's Manual I, "*SET_NODE"): eight nodes on a line.
void write_set(std::ostream& out, int number, std::string_view name, const std::vector<int>& nodes) {
  if (nodes.empty()) return;
  out << "$ " << name << '\n';
  keyword(out, "*SET_NODE_LIST", "$      SID");
  card(out, FixedCard().whole(number));
  out << cards_of_numbers(nodes, kDynaNumbersOnALine);
}

void write_sets(std::ostream& out, const model::Model& model, const BeamMesh& mesh) {
  write_set(out, dyna::kHeldNodes, model.test.held_set, node_numbers(model, model.test.held_set));
  write_set(out, dyna::kDrivenNodes, model.test.driven_set, node_numbers(model, model.test.driven_set));
  std::vector<int> orientation(mesh.orientation_nodes.size());
  std::iota(orientation.begin(), orientation.end(), model.n_nodes() + 1);
  write_set(out, dyna::kOrientationNodes, "orientation of the beams", orientation);
  for (const auto& [name, number] :
       {std::pair{model::kLeftEdge, dyna::kLeftEdge}, std::pair{model::kRightEdge, dyna::kRightEdge}}) {
    if (model.node_sets.contains(name)) write_set(out, number, name, node_numbers(model, name));
  }
}

}  // namespace

void write_lsdyna(std::ostream& out, const model::Model& model, const LsDynaOptions& options) {
  check_for_elastic_deck(model, "LS-DYNA");
  const BeamMesh mesh = beam_mesh(model);
  const std::vector<int> parts = used_parts(mesh);
  write_head(out, model, parts, options);
  write_control(out, model, options);
  dyna::write_parts(out, model, parts, options.mass_scaling);
  write_mesh(out, model, mesh);
  write_sets(out, model, mesh);
  dyna::write_ties(out, model);
  dyna::write_grips(out, model.test);
  dyna::write_contact(out, model, parts);
  out << "*END\n";
}

}  // namespace knitmech::exchange
