#include "exchange/abaqus_syntax.h"

#include <algorithm>
#include <array>

#include "exchange/constants.h"

namespace knitmech::exchange::syntax {
namespace {

using Fields = std::vector<Field>;
using enum Part;

constexpr Field kText{Entry::text}, kWhole{Entry::whole}, kReal{Entry::real}, kVariable{Entry::variable};

Fields reals(std::size_t n) {
  Fields fields;
  fields.assign(n, kReal);
  return fields;
}

/// Lines of up to n real numbers, at least `fewest`.
Lines numbers(std::size_t n, std::size_t fewest, int least = 1, int most = 1) {
  return {.fields = reals(n), .fewest = fewest, .least = least, .most = most};
}

Option flag(const char* name) {
  return {.name = name};
}
Option required(const char* name, std::vector<std::string> values = {}) {
  return {name, true, std::move(values)};
}
Option one_of(const char* name, std::vector<std::string> values) {
  return {name, false, std::move(values)};
}
Option defines(Names names) {
  return {"NAME", true, {}, Role::defines, names};
}
Option adds_to(const char* name, bool is_required, Names names) {
  return {name, is_required, {}, Role::adds_to, names};
}
Option refers(const char* name, bool is_required, Names names) {
  return {name, is_required, {}, Role::refers, names};
}

Lines set_members(Names names) {
  return {.fields = Fields(kAbaqusSetEntries, Field{Entry::name_or_number, names}), .fewest = 1, .most = kAnyNumber};
}
const Lines kGenerated{.fields = {kWhole, kWhole, kWhole}, .fewest = 2, .most = kAnyNumber};

const std::vector<std::string> kBeamShapes{"ARBITRARY", "BOX",  "CIRC", "ELBOW",      "HEX",      "I",
                                           "L",         "PIPE", "RECT", "THICK PIPE", "TRAPEZOID"};
const std::vector<std::string> kGeneralShapes{
    "ARBITRARY", "BOX", "CIRC", "GENERAL", "HEX", "I", "L", "MESHED", "NONLINEAR GENERAL", "PIPE", "RECT", "TRAPEZOID"};
const Lines kFirstAxis = numbers(3, 3, 0, 1);

std::vector<Keyword> mesh_keywords() {
  return {
      {"HEADING", model, {}, {}, {}, {{"", "", {{{kText}, 0, true, 0, kAnyNumber}}}}},
      {"NODE",
       model,
       {},
       {},
       {adds_to("NSET", false, Names::node_set), one_of("SYSTEM", {"R", "C", "S"})},
       {{"", "", {{{kWhole, kReal, kReal, kReal, kReal, kReal, kReal}, 2, false, 1, kAnyNumber}}}}},
      {"ELEMENT",
       model,
       {},
       {},
       {required("TYPE"), adds_to("ELSET", false, Names::element_set)},
       {{"", "", {{{kWhole}, 2, true, 1, kAnyNumber}}}}},
      {"NSET",
       model,
       {},
       {},
       {adds_to("NSET", true, Names::node_set), refers("ELSET", false, Names::element_set), flag("GENERATE"),
        flag("UNSORTED"), flag("INTERNAL")},
       {{"GENERATE", "", {kGenerated}}, {"ELSET", "", {}}, {"", "", {set_members(Names::node_set)}}}},
      {"ELSET",
       model,
       {},
       {},
       {adds_to("ELSET", true, Names::element_set), flag("GENERATE"), flag("INTERNAL")},
       {{"GENERATE", "", {kGenerated}}, {"", "", {set_members(Names::element_set)}}}},
      {"EQUATION", model, {}, {}, {}, {{"", "", {{{kText}, 1, true, 2, kAnyNumber}}}}},
      {"SURFACE",
       model,
       {},
       {},
       {defines(Names::surface), one_of("TYPE", {"ELEMENT", "NODE"}), one_of("COMBINE", {"UNION", "INTERSECTION"})},
       {{"TYPE", "NODE", {{{{Entry::name_or_number, Names::node_set}, kReal}, 1, false, 1, kAnyNumber}}},
        {"", "", {{{{Entry::name_or_number, Names::element_set}, kText}, 1, false, 1, kAnyNumber}}}}},
      {"AMPLITUDE",
       model,
       {},
       {},
       {defines(Names::amplitude), one_of("DEFINITION", {"TABULAR", "SMOOTH STEP", "EQUALLY SPACED", "PERIODIC"}),
        one_of("TIME", {"STEP TIME", "TOTAL TIME"}), one_of("VALUE", {"RELATIVE", "ABSOLUTE"}), flag("SMOOTH")},
       {{"", "", {numbers(8, 2, 1, kAnyNumber)}}}},
  };
}

std::vector<Keyword> section_keywords() {
  const std::vector<std::string> general{"BEAMGENERALSECTION"};
  const std::vector<std::string> curves{"AXIAL", "M1", "M2", "TORQUE", "TRANSVERSESHEARSTIFFNESS"};
  const std::vector<Data> behaviour{{"LINEAR", "", {numbers(2, 1, 1, kAnyNumber)}},
                                    {"", "", {numbers(3, 2, 2, kAnyNumber)}}};
  const std::vector<Option> kind{flag("ELASTIC"), flag("LINEAR"), flag("DEPENDENCIES")};
  const auto rotary = one_of("ROTARYINERTIA", {"EXACT", "ISOTROPIC"});
  return {
      {"BEAMSECTION",
       model,
       {},
       {},
       {refers("ELSET", true, Names::element_set), refers("MATERIAL", true, Names::material),
        required("SECTION", kBeamShapes), flag("POISSON"), rotary},
       {{"SECTION", "CIRC", {numbers(1, 1), kFirstAxis, {Fields(2, kWhole), 1, false, 0, 1}}},
        {"SECTION", "RECT", {numbers(2, 2), kFirstAxis, {Fields(2, kWhole), 1, false, 0, 1}}},
        {"", "", {numbers(8, 1, 1, kAnyNumber)}}}},
      // DENSITY is optional in Abaqus/Standard only.
      {"BEAMGENERALSECTION",
       model,
       {},
       {},
       {refers("ELSET", true, Names::element_set), required("DENSITY"), one_of("SECTION", kGeneralShapes),
        flag("POISSON"), flag("ZERO"), rotary},
       {{"SECTION", "GENERAL", {numbers(7, 5), numbers(3, 3, 1, 1), numbers(3, 2)}},
        {"SECTION", "NONLINEAR GENERAL", {numbers(7, 5), kFirstAxis}},
        {"", "", {numbers(8, 1, 1, kAnyNumber)}}}},
      {"AXIAL", model, general, curves, kind, behaviour},
      {"M1", model, general, curves, kind, behaviour},
      {"M2", model, general, curves, kind, behaviour},
      {"TORQUE", model, general, curves, kind, behaviour},
      {"TRANSVERSESHEARSTIFFNESS",
       model,
       {"BEAMSECTION", "BEAMGENERALSECTION"},
       curves,
       {},
       {{"", "", {numbers(3, 1)}}}},
  };
}

std::vector<Keyword> property_keywords() {
  const std::vector<std::string> of_material{"DENSITY", "ELASTIC", "DAMPING"};
  return {
      {"MATERIAL", model, {}, {}, {defines(Names::material)}, {}},
      {"DENSITY", model, {"MATERIAL"}, of_material, {flag("DEPENDENCIES")}, {{"", "", {numbers(8, 1, 1, kAnyNumber)}}}},
      {"ELASTIC",
       model,
       {"MATERIAL"},
       of_material,
       {one_of("TYPE", {"ISOTROPIC"}), one_of("MODULI", {"INSTANTANEOUS", "LONG TERM"}), flag("DEPENDENCIES")},
       {{"", "", {numbers(3, 2, 1, kAnyNumber)}}}},
      {"DAMPING", model, {"MATERIAL"}, of_material, {flag("ALPHA"), flag("BETA")}, {}},
      {"SURFACEINTERACTION", model, {}, {}, {defines(Names::interaction)}, {{"", "", {numbers(1, 0, 0, 1)}}}},
      {"FRICTION",
       both,
       {"SURFACEINTERACTION"},
       {"SURFACEBEHAVIOR", "FRICTION"},
       {flag("ROUGH"), flag("TAUMAX"), flag("SLIPTOLERANCE"), flag("ELASTICSLIP"), flag("DEPENDENCIES")},
       {{"ROUGH", "", {}}, {"", "", {numbers(4, 1, 1, kAnyNumber)}}}},
      {"SURFACEBEHAVIOR",
       both,
       {"SURFACEINTERACTION"},
       {"SURFACEBEHAVIOR", "FRICTION"},
       {one_of("PRESSURE-OVERCLOSURE", {"HARD", "EXPONENTIAL", "LINEAR", "SCALE FACTOR", "TABULAR"}),
        flag("NOSEPARATION")},
       {{"PRESSURE-OVERCLOSURE", "HARD", {}}, {"", "", {numbers(4, 0, 0, kAnyNumber)}}}},
  };
}

std::vector<Keyword> contact_keywords() {
  const Field surface{Entry::name_or_empty, Names::surface};
  const std::vector<std::string> within{"CONTACTINCLUSIONS", "CONTACTEXCLUSIONS", "CONTACTPROPERTYASSIGNMENT",
                                        "SURFACEPROPERTYASSIGNMENT"};
  return {
      {"CONTACT", both, {}, {}, {one_of("OP", {"MOD", "NEW"})}, {}},
      {"CONTACTINCLUSIONS",
       both,
       {"CONTACT"},
       within,
       {flag("ALLEXTERIOR")},
       {{"ALLEXTERIOR", "", {}}, {"", "", {{{surface, surface}, 1, false, 1, kAnyNumber}}}}},
      {"CONTACTEXCLUSIONS", both, {"CONTACT"}, within, {}, {{"", "", {{{surface, surface}, 1, false, 1, kAnyNumber}}}}},
      {"CONTACTPROPERTYASSIGNMENT",
       both,
       {"CONTACT"},
       within,
       {},
       {{"", "", {{{surface, surface, {Entry::name, Names::interaction}}, 3, false, 1, kAnyNumber}}}}},
      {"SURFACEPROPERTYASSIGNMENT",
       both,
       {"CONTACT"},
       within,
       {required("PROPERTY", {"THICKNESS", "FEATURE EDGE CRITERIA", "OFFSET FRACTION"})},
       {{"", "", {{{surface, kText, kText}, 2, false, 1, kAnyNumber}}}}},
  };
}

std::vector<Keyword> step_keywords() {
  const Field nodes{Entry::name_or_number, Names::node_set};
  return {
      {"STEP",
       model,
       {},
       {},
       {flag("NAME"), one_of("NLGEOM", {"YES", "NO", ""}), flag("INC")},
       {{"", "", {{{kText}, 0, true, 0, kAnyNumber}}}}},
      {"ENDSTEP", history, {}, {}, {}, {}},
      {"DYNAMIC",
       history,
       {},
       {},
       {required("EXPLICIT"), flag("DIRECTUSERCONTROL"), flag("SCALEFACTOR")},
       {{"", "", {numbers(4, 2)}}}},
      {"BULKVISCOSITY", history, {}, {}, {}, {{"", "", {numbers(2, 1)}}}},
      {"FIXEDMASSSCALING",
       history,
       {},
       {},
       {flag("FACTOR"), flag("DT"), one_of("TYPE", {"UNIFORM", "BELOW MIN", "SET EQUAL DT"}),
        refers("ELSET", false, Names::element_set)},
       {}},
      {"BOUNDARY",
       both,
       {},
       {},
       {one_of("TYPE", {"DISPLACEMENT", "VELOCITY", "ACCELERATION"}), refers("AMPLITUDE", false, Names::amplitude),
        one_of("OP", {"MOD", "NEW"})},
       {{"", "", {{{nodes, {Entry::degree_or_word}, {Entry::degree_or_nothing}, kReal}, 2, false, 1, kAnyNumber}}}}},
  };
}

std::vector<Keyword> output_keywords() {
  const std::vector<std::string> requests{"NODEOUTPUT", "ELEMENTOUTPUT", "CONTACTOUTPUT", "ENERGYOUTPUT"};
  const auto variables = one_of("VARIABLE", {"ALL", "PRESELECT"});
  const std::vector<Data> lines{{"VARIABLE", "", {}}, {"", "", {{{kVariable}, 1, true, 1, kAnyNumber}}}};
  return {
      {"OUTPUT",
       history,
       {},
       {},
       {flag("FIELD"), flag("HISTORY"), flag("NUMBERINTERVAL"), flag("TIMEINTERVAL"), flag("TIMEMARKS"),
        flag("FREQUENCY"), one_of("OP", {"NEW", "ADD", "REPLACE"}), variables},
       {}},
      {"NODEOUTPUT", history, {"OUTPUT"}, requests, {refers("NSET", false, Names::node_set), variables}, lines},
      {"ELEMENTOUTPUT", history, {"OUTPUT"}, requests, {refers("ELSET", false, Names::element_set), variables}, lines},
      {"CONTACTOUTPUT",
       history,
       {"OUTPUT"},
       requests,
       {flag("GENERALCONTACT"), refers("SURFACE", false, Names::surface), variables},
       lines},
      {"ENERGYOUTPUT", history, {"OUTPUT"}, requests, {refers("ELSET", false, Names::element_set), variables}, lines},
  };
}

std::vector<Keyword> all_keywords() {
  std::vector<Keyword> all;
  for (const auto& part : {mesh_keywords(), section_keywords(), property_keywords(), contact_keywords(),
                           step_keywords(), output_keywords()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

const std::vector<Keyword>& keywords() {
  static const std::vector<Keyword> all = all_keywords();
  return all;
}

}  // namespace

const Keyword* keyword_rule(std::string_view name) {
  const auto found = std::ranges::find(keywords(), name, &Keyword::name);
  return found == keywords().end() ? nullptr : &*found;
}

std::vector<std::string_view> keyword_names() {
  std::vector<std::string_view> names;
  for (const Keyword& each : keywords()) names.emplace_back(each.name);
  return names;
}

bool is_output_variable(std::string_view keyword, std::string_view variable) {
  static constexpr std::array kVectors{"U", "UR", "V", "VR", "A", "AR", "RF", "RM", "CF", "CM", "UT", "VT", "AT", "RT"};
  static constexpr std::array kNode{"COORD"};
  static constexpr std::array kElement{"SF", "SE", "SK", "SM", "S", "LE", "E", "EVOL", "ELEN", "ENER", "STATUS"};
  static constexpr std::array kContact{"CFORCE", "CSTRESS", "CSTATUS", "CTHICK", "FSLIP", "FSLIPR", "CDISP"};
  static constexpr std::array kEnergy{"ALLAE", "ALLCD", "ALLFD", "ALLIE", "ALLKE", "ALLPD", "ALLSE",
                                      "ALLVD", "ALLWK", "ALLMW", "ALLPW", "ALLCW", "ETOTAL"};
  const auto has = [&](const auto& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  if (keyword == "ELEMENTOUTPUT") return has(kElement, variable);
  if (keyword == "CONTACTOUTPUT") return has(kContact, variable);
  if (keyword == "ENERGYOUTPUT") return has(kEnergy, variable);
  const bool is_component = !variable.empty() && variable.back() >= '1' && variable.back() <= '3';
  return has(kNode, variable) || has(kVectors, is_component ? variable.substr(0, variable.size() - 1) : variable);
}

std::pair<int, int> nodes_of_type(std::string_view type) {
  if (type == "B31" || type == "B31H" || type == "B31OS") return {2, 3};
  if (type == "B32" || type == "B32H" || type == "B32OS") return {3, 4};
  if (type == "T3D2") return {2, 2};
  return {0, 0};
}

}  // namespace knitmech::exchange::syntax
