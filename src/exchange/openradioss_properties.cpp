#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "exchange/constants.h"
#include "exchange/openradioss_parts.h"

namespace knitmech::exchange::radioss {

namespace {

/// Part and name: "yarn", or "yarn of section 2".
std::string part_title(int part, const std::vector<int>& parts) {
  return parts.size() == 1 ? "yarn" : fmt::format("yarn of section {}", part);
}

/// /MAT/ELAST (Radioss Reference Guide, "/MAT/LAW1 (ELAST)").
void write_material(std::ostream& out, int part, const std::string& title, const BeamSection& section) {
  keyword(out, fmt::format("/MAT/ELAST/{}", part), title, "#              RHO_I");
  card(out, FixedCard().real(section.density));
  out << "#                  E                  nu\n";
  card(out, FixedCard().real(section.youngs_modulus).real(section.poissons_ratio));
}

/// /PROP/BEAM (Radioss Reference Guide, "/PROP/TYPE3 (BEAM)"): no damping of its own but the small default, no hinges,
/// with transverse shear.
void write_property(std::ostream& out, int part, const std::string& title, const BeamSection& section) {
  keyword(out, fmt::format("/PROP/BEAM/{}", part), title, "#             Ismstr");
  card(out, FixedCard().whole(0, 20));
  out << "#                 Dm                  Df\n";
  card(out, FixedCard().whole(0, 20).whole(0, 20));
  out << "#               Area                 Iyy                 Izz                 Ixx\n";
  card(out, FixedCard().real(section.area).real(section.inertia).real(section.inertia).real(section.torsion_constant));
  out << "#  OmegaDOF    Ishear\n";
  card(out, FixedCard().word("000 000").whole(0));
}

/// /PART (Radioss Reference Guide, "/PART"). Its thickness is what the contact takes for the diameter where the gap is
/// variable.
void write_part(std::ostream& out, int part, const std::string& title, double thickness) {
  keyword(out, fmt::format("/PART/{}", part), title, "#  prop_ID    mat_ID subset_ID               Thick");
  FixedCard fields;
  fields.whole(part).whole(part).whole(0);
  if (thickness > 0) fields.real(thickness);
  card(out, fields);
}

/// /FRICTION (Radioss Reference Guide, "/FRICTION"): Coulomb friction, incremental, of pairs of parts.
void write_pair_friction(std::ostream& out, double friction, const std::vector<model::PairFriction>& pairs) {
  const auto coefficients = [&](double value) {
    out << "#                 C1                  C2                  C3                  C4                  C5\n";
    card(out, FixedCard().whole(0, 20).whole(0, 20).whole(0, 20).whole(0, 20).whole(0, 20));
    out << "#                 C6                Fric               VIS_f\n";
    card(out, FixedCard().whole(0, 20).real(value).whole(0, 20));
  };
  keyword(out, fmt::format("/FRICTION/{}", kFriction), "friction of pairs",
          "#   I_fric  I_filtr               Xfreq     Iform");
  card(out, FixedCard().whole(0).whole(0).whole(0, 20).whole(2));
  coefficients(friction);
  for (const model::PairFriction& pair : pairs) {
    out << "#grpart_I1 grpart_I2  part_ID1  part_ID2\n";
    card(out, FixedCard().whole(0).whole(0).whole(pair.first_section + 1).whole(pair.second_section + 1));
    coefficients(pair.friction);
  }
}

/// /LINE/PART (Radioss Reference Guide, "/LINE/PART").
void write_lines(std::ostream& out, const std::vector<int>& parts) {
  keyword(out, fmt::format("/LINE/PART/{}", kLines), "yarns");
  out << cards_of_numbers(parts, kNumbersOnALine);
}

}  // namespace

void write_materials_and_parts(std::ostream& out, const model::Model& model, const std::vector<int>& parts,
                               double mass_scaling) {
  caption(out, "MATERIALS, PROPERTIES AND PARTS, one for each section of the yarn");
  const bool with_thickness = !have_one_diameter(model, parts);
  for (const int part : parts) {
    const BeamSection section = beam_section(model.sections[static_cast<std::size_t>(part) - 1], mass_scaling);
    const std::string title = part_title(part, parts);
    write_material(out, part, title, section);
    write_property(out, part, title, section);
    write_part(out, part, title, with_thickness ? section.diameter : 0);
  }
}

/// /INTER/TYPE11 (Radioss Reference Guide, "/INTER/TYPE11"), of all lines with themselves: line_IDm 0.
///
/// Istf 1 gives the stiffness of a line. Two lines work in series, and the force at the penetration p of a gap g is
/// half of that times p g / (g - p) (OpenRadioss, engine/source/interfaces/int11, i11cor3.F and i11for3.F): with Stfac
/// = 4 K this is the normal law of contact/normal_law.h for the stiffness K of a crossing. Gaps: constant, or, where
/// yarns differ in diameter, half the sum of the thicknesses of their parts (Igap 1). Iform 2: friction as an elastic
/// stick. Irem_gap 2 leaves out the contact of a yarn with itself along less than a few gaps of its length.
void write_contact(std::ostream& out, const model::Model& model, const std::vector<int>& parts) {
  caption(out, "CONTACT: every yarn with every yarn and with itself");
  write_lines(out, parts);
  const std::vector<model::PairFriction> pairs = used_pair_friction(model, parts);
  if (!pairs.empty()) write_pair_friction(out, model.friction, pairs);
  double thinnest = model.sections[static_cast<std::size_t>(parts.front()) - 1].diameter;
  for (const int part : parts) {
    thinnest = std::min(thinnest, model.sections[static_cast<std::size_t>(part) - 1].diameter);
  }
  keyword(out, fmt::format("/INTER/TYPE11/{}", kContact), "yarn on yarn",
          "# line_IDs  line_IDm      Istf      Ithe      Igap            Irem_gap      Idel");
  FixedCard first;
  first.whole(kLines).whole(0).whole(1).whole(0).whole(have_one_diameter(model, parts) ? 0 : 1).blank();
  if (openradioss_year(model) == kRadiossYear) {
    first.blank();
  } else {
    first.whole(2);
  }
  card(out, first.whole(0));
  out << "#              Stmin               Stmax   Percent_mesh_size               dtmin     Iform   sens_ID\n";
  card(out, FixedCard().whole(0, 20).whole(0, 20).whole(0, 20).whole(0, 20).whole(2).whole(0));
  out << "#              Stfac                Fric              Gapmin              Tstart               Tstop\n";
  card(out, FixedCard()
                .real(kLinesInSeries * model.contact_stiffness)
                .real(model.friction)
                .real(thinnest)
                .whole(0, 20)
                .whole(0, 20));
  out << "#      IBC                        Inacti               VIS_S               VIS_F              Bumult\n";
  card(out, FixedCard().word("000").blank(20).whole(0).whole(0, 20).whole(0, 20).whole(0, 20));
  out << "#                                                                                            fric_ID\n";
  card(out, FixedCard().blank(90).whole(pairs.empty() ? 0 : kFriction));
}

}  // namespace knitmech::exchange::radioss
