#include "exchange/openradioss_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "exchange/abaqus_number.h"
#include "exchange/beam_deck.h"
#include "exchange/constants.h"
#include "exchange/fixed_card.h"
#include "exchange/openradioss_parts.h"

namespace knitmech::exchange {

namespace {

using radioss::caption;
using radioss::card;
using radioss::keyword;

void check_run_name(const std::string& name) {
  const auto is_taken = [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '_' || letter == '-' || letter == '.';
  };
  if (!name.empty() && name.size() <= kRadiossRunName && std::ranges::all_of(name, is_taken)) return;
  throw InputError(fmt::format(
      "the files of OpenRadioss bear the name of the run, and {} is none: 1 to {} letters, digits, -, _ and "
      ".; give another name of the file",
      base::in_quotes(name), kRadiossRunName));
}

/// /BEGIN, /TITLE, /ANALY, /SPMD (Radioss Reference Guide, the pages of these names). /SPMD leaves the number of ranks
/// and threads to the command line.
void write_head(std::ostream& out, const model::Model& model, const OpenRadiossOptions& options) {
  out << "#RADIOSS STARTER\n";
  out << "# A knitted fabric, yarn by yarn, in a tensile test; written by KnitMech.\n";
  out << "# Units: mass Mg, length mm, time s; hence force N, stress MPa, energy mJ, density Mg/mm^3.\n";
  out << "# x runs along the courses, y along the wales, z out of the plane of the fabric.\n";
  out << fmt::format("# {} {}, {} nodes, {} beam elements; the density is {:.6g} times that of the yarn.\n",
                     model.yarns.size(), model.yarns.size() == 1 ? "yarn" : "yarns", model.n_nodes(),
                     model.n_elements(), options.mass_scaling);
  out << fmt::format("# Strain = displacement of {} / {:.12g} mm.\n", model.test.driven_set, model.test.gauge_length);
  for (const std::string& remark : difference_remarks(model)) out << "# " << remark << '\n';
  out << "/BEGIN\n" << options.run_name << '\n';
  card(out, FixedCard().whole(openradioss_year(model)).whole(0));
  for (int i = 0; i < 2; ++i) card(out, FixedCard().word("Mg", 20).word("mm", 20).word("s", 20));
  out << "/TITLE\n" << ("KnitMech: " + abaqus_text(model.title)).substr(0, kRadiossTitle) << '\n';
  out << "/ANALY\n";
  card(out, FixedCard().whole(0).blank().whole(0).whole(0));
  out << "/SPMD\n";
  card(out, FixedCard().whole(0).whole(0).blank().whole(0).whole(1));
}

/// /NODE (Radioss Reference Guide, "/NODE").
void write_nodes(std::ostream& out, const model::Model& model, const BeamMesh& mesh) {
  caption(out, "NODES; the last give the beams their orientation");
  out << "/NODE\n#  node_ID                  Xc                  Yc                  Zc\n";
  int number = 0;
  const auto write = [&](const Eigen::Vector3d& node) {
    card(out, FixedCard().whole(++number).real(node.x()).real(node.y()).real(node.z()));
  };
  for (const Eigen::Vector3d& node : model.nodes) write(node);
  for (const Eigen::Vector3d& node : mesh.orientation_nodes) write(node);
}

/// /BEAM (Radioss Reference Guide, "/BEAM"): a block for each part.
void write_elements(std::ostream& out, const BeamMesh& mesh, const std::vector<int>& parts) {
  caption(out, "YARNS");
  for (const int part : parts) {
    out << fmt::format("/BEAM/{}\n#  beam_ID  node_ID1  node_ID2  node_ID3\n", part);
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
      const BeamElement& element = mesh.elements[i];
      if (element.part != part) continue;
      card(out,
           FixedCard().whole(static_cast<int>(i) + 1).whole(element.first).whole(element.last).whole(element.third));
    }
  }
}

/// /GRNOD/NODE (Radioss Reference Guide, "/GRNOD"): ten nodes on a line.
void write_group(std::ostream& out, int number, std::string_view title, const std::vector<int>& nodes) {
  if (nodes.empty()) return;
  keyword(out, fmt::format("/GRNOD/NODE/{}", number), title);
  out << cards_of_numbers(nodes, kNumbersOnALine);
}

void write_groups(std::ostream& out, const model::Model& model, const BeamMesh& mesh) {
  caption(out, "NODE GROUPS");
  write_group(out, radioss::kHeldNodes, model.test.held_set, node_numbers(model, model.test.held_set));
  write_group(out, radioss::kDrivenNodes, model.test.driven_set, node_numbers(model, model.test.driven_set));
  std::vector<int> orientation(mesh.orientation_nodes.size());
  std::iota(orientation.begin(), orientation.end(), model.n_nodes() + 1);
  write_group(out, radioss::kOrientationNodes, "orientation", orientation);
  for (const auto& [name, number] :
       {std::pair{model::kLeftEdge, radioss::kLeftEdge}, std::pair{model::kRightEdge, radioss::kRightEdge}}) {
    if (model.node_sets.contains(name)) write_group(out, number, name, node_numbers(model, name));
  }
}

}  // namespace

int openradioss_year(const model::Model& model) {
  double thickest = 0;
  for (const int part : used_parts(beam_mesh(model))) {
    thickest = std::max(thickest, model.sections[static_cast<std::size_t>(part) - 1].diameter);
  }
  return thickest > kShortForContact * shortest_element(model) ? kRadiossYearOfRemovedGaps : kRadiossYear;
}

void write_openradioss_starter(std::ostream& out, const model::Model& model, const OpenRadiossOptions& options) {
  check_for_elastic_deck(model, "OpenRadioss");
  check_run_name(options.run_name);
  const BeamMesh mesh = beam_mesh(model);
  const std::vector<int> parts = used_parts(mesh);
  write_head(out, model, options);
  radioss::write_materials_and_parts(out, model, parts, options.mass_scaling);
  write_nodes(out, model, mesh);
  write_elements(out, mesh, parts);
  write_groups(out, model, mesh);
  radioss::write_ties(out, model);
  radioss::write_grips(out, model.test);
  radioss::write_contact(out, model, parts);
  radioss::write_histories(out, model, parts);
  out << "/END\n";
}

/// /RUN, /VERS, /TFILE, /ANIM/DT, /ANIM/VECT, /PRINT, /DT (Radioss Reference Guide, "Engine Input", the pages of these
/// names).
void write_openradioss_engine(std::ostream& out, const model::Model& model, const OpenRadiossOptions& options) {
  check_for_elastic_deck(model, "OpenRadioss");
  check_run_name(options.run_name);
  const double duration = test_duration(model.test);
  const auto number = [](double value) { return number_within(value, kRadiossEngineNumber); };
  out << fmt::format("/RUN/{}/1\n{}\n", options.run_name, number(duration));
  out << fmt::format("/VERS/{}\n", openradioss_year(model));
  out << fmt::format("/TFILE\n{}\n", number(duration / options.history_points));
  out << fmt::format("/ANIM/DT\n0 {}\n", number(duration / options.pictures));
  out << "/ANIM/VECT/DISP\n/ANIM/VECT/CONT\n";
  out << fmt::format("/PRINT/-{}\n", kRadiossPrintedCycles);
  out << fmt::format("/DT\n{} 0\n", number(kStepShare));
}

}  // namespace knitmech::exchange
