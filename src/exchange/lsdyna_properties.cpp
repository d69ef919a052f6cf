#include <cmath>
#include <ostream>
#include <vector>

#include "exchange/constants.h"
#include "exchange/lsdyna_parts.h"
#include "exchange/tie_equations.h"

namespace knitmech::exchange::dyna {

namespace {

/// *PART, *SECTION_BEAM, *MAT_ELASTIC (LS-DYNA Keyword User's Manual I and II, the pages of these names).
void write_part(std::ostream& out, int part, const BeamSection& section) {
  keyword(out, "*PART");
  out << fmt::format("yarn of section {}\n", part);
  out << "$      PID     SECID       MID\n";
  card(out, FixedCard().whole(part).whole(part).whole(part));
  keyword(out, "*SECTION_BEAM", "$    SECID    ELFORM");
  card(out, FixedCard().whole(part).whole(kResultantBeam));
  out << "$        A       ISS       ITT         J        SA\n";
  FixedCard values;
  for (const double value :
       {section.area, section.inertia, section.inertia, section.torsion_constant, section.shear_area}) {
    real(values, value);
  }
  card(out, values);
  keyword(out, "*MAT_ELASTIC", "$      MID        RO         E        PR");
  FixedCard material;
  material.whole(part);
  for (const double value : {section.density, section.youngs_modulus, section.poissons_ratio}) real(material, value);
  card(out, material);
}

/// *DEFINE_FRICTION (LS-DYNA Keyword User's Manual I, the page of this name). OpenRadioss makes friction that sticks of
/// it, /FRICTION with Iform 2; the friction of *CONTACT itself becomes a viscous one there.
void write_friction(std::ostream& out, double friction, const std::vector<model::PairFriction>& pairs) {
  keyword(out, "*DEFINE_FRICTION", "$      FID      FS_D      FD_D      DC_D      VC_D");
  FixedCard of_all;
  card(out, real(real(of_all.whole(kFriction), friction), friction).whole(0).whole(0));
  for (const model::PairFriction& pair : pairs) {
    out << "$    PID_I     PID_J     FS_IJ     FD_IJ     DC_IJ     VC_IJ\n";
    FixedCard of_pair;
    of_pair.whole(pair.first_section + 1).whole(pair.second_section + 1);
    card(out, real(real(of_pair, pair.friction), pair.friction).whole(0).whole(0));
  }
}

}  // namespace

void write_parts(std::ostream& out, const model::Model& model, const std::vector<int>& parts, double mass_scaling) {
  for (const int part : parts) {
    write_part(out, part, beam_section(model.sections[static_cast<std::size_t>(part) - 1], mass_scaling));
  }
  keyword(out, "*SET_PART_LIST", "$      SID");
  card(out, FixedCard().whole(kYarns));
  out << cards_of_numbers(parts, kDynaNumbersOnALine);
}

/// *CONTACT_AUTOMATIC_GENERAL (LS-DYNA Keyword User's Manual I, "*CONTACT").
///
/// SOFT -11 is a word to OpenRadioss: contact of beams by /INTER/TYPE11, with the gap (SST + MST) / 2 and, of two lines
/// of the section A and the modulus E, the stiffness SFS sqrt(A) E, half of which counts (dyna2rad,
/// convertcontacts.cxx; starter, i11sti3.F; engine, i11for3.F). SFS = 2 K / (sqrt(A) E) is the stiffness K of a
/// crossing.
void write_contact(std::ostream& out, const model::Model& model, const std::vector<int>& parts) {
  write_friction(out, model.friction, used_pair_friction(model, parts));
  const BeamSection section = beam_section(model.sections[static_cast<std::size_t>(parts.front()) - 1], 1);
  const double scale = kLinesInParallel * model.contact_stiffness / (std::sqrt(section.area) * section.youngs_modulus);
  keyword(out, "*CONTACT_AUTOMATIC_GENERAL_ID", "$      CID");
  out << fmt::format("{:>10}yarn on yarn\n", kContact);
  out << "$     SSID      MSID     SSTYP     MSTYP\n";
  card(out, FixedCard().whole(kYarns).whole(0).whole(2).whole(0));
  out << "$ FS -2: friction of *DEFINE_FRICTION, whose number is FD\n$       FS        FD\n";
  card(out, FixedCard().whole(kFrictionOfTable).whole(kFriction));
  out << "$ For LS-DYNA: SFS and SFM 1.0, and SST and MST 0.0, which takes the diameter from the section.\n";
  out << "$      SFS       SFM       SST       MST      SFST      SFMT\n";
  FixedCard stiffness;
  real(real(real(real(stiffness, scale), scale), section.diameter), section.diameter).whole(1).whole(1);
  card(out, stiffness);
  out << "$ For LS-DYNA: SOFT 1. For OpenRadioss: SOFT -11, contact of beams with each other (/INTER/TYPE11).\n";
  out << "$     SOFT\n";
  card(out, FixedCard().whole(kSoftOfBeamContact));
}

/// *CONSTRAINED_LINEAR_GLOBAL (LS-DYNA Keyword User's Manual I, "*CONSTRAINED_LINEAR").
void write_ties(std::ostream& out, const model::Model& model) {
  if (model.ties.empty()) return;
  out << "$ Ties: yarns that keep their relative position where they cross at the side edges.\n";
  int number = 0;
  for (const TieEquation& equation : tie_equations(model)) {
    for (int direction = 1; direction <= 3; ++direction) {
      keyword(out, "*CONSTRAINED_LINEAR_GLOBAL", "$     LCID");
      card(out, FixedCard().whole(++number));
      for (const TieEquation::Term& term : equation.terms) {
        FixedCard values;
        card(out, real(values.whole(term.node + 1).whole(direction), term.coefficient));
      }
    }
  }
}

/// *BOUNDARY_SPC_SET, *DEFINE_CURVE, *BOUNDARY_PRESCRIBED_MOTION_SET (LS-DYNA Keyword User's Manual I, the pages of
/// these names): velocity (VAD 0) along y (DOF 2).
void write_grips(std::ostream& out, const model::TensileTest& test) {
  const auto hold = [&](int set, bool x, bool y, bool z) {
    keyword(out, "*BOUNDARY_SPC_SET",
            "$     NSID       CID      DOFX      DOFY      DOFZ     DOFRX     DOFRY     DOFRZ");
    FixedCard fields;
    fields.whole(set).whole(0);
    for (const bool held : {x, y, z, true, true, true}) fields.whole(held ? 1 : 0);
    card(out, fields);
  };
  const bool clamped = test.grips == model::Grips::clamped;
  hold(kHeldNodes, true, true, true);
  hold(kDrivenNodes, clamped, false, clamped);
  hold(kOrientationNodes, true, true, true);
  keyword(out, "*DEFINE_CURVE", "$     LCID");
  card(out, FixedCard().whole(kVelocity));
  out << "$                 A1                  O1\n";
  for (const auto& [time, share] : velocity_curve(test)) card(out, FixedCard().real(time).real(share));
  keyword(out, "*BOUNDARY_PRESCRIBED_MOTION_SET", "$     NSID       DOF       VAD      LCID        SF");
  FixedCard motion;
  card(out, real(motion.whole(kDrivenNodes).whole(2).whole(0).whole(kVelocity), test.speed));
}

}  // namespace knitmech::exchange::dyna
