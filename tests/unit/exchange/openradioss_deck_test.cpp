// The OpenRadioss deck of every structure, read back and compared with the model number by number.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/errors.h"
#include "deck_models.h"
#include "exchange/openradioss_reader.h"
#include "exchange/openradioss_writer.h"

namespace knitmech::exchange {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

constexpr double kMassScaling = 1e4;

struct Decks {
  explicit Decks(const model::Case& input)
      : model(model::build_model(input)),
        options{.run_name = "jersey", .mass_scaling = kMassScaling, .history_points = 200, .pictures = 20} {
    std::ostringstream starter_out, engine_out;
    write_openradioss_starter(starter_out, model, options);
    write_openradioss_engine(engine_out, model, options);
    starter_text = starter_out.str();
    std::istringstream starter_in(starter_text), engine_in(engine_out.str());
    starter = read_openradioss_starter(starter_in, "jersey_0000.rad");
    engine = read_openradioss_engine(engine_in, "jersey_0001.rad");
  }

  [[nodiscard]] std::vector<int> group(const std::string& title) const {
    for (const auto& [number, group] : starter.groups) {
      if (group.title == title) return group.members;
    }
    return {};
  }

  model::Model model;
  OpenRadiossOptions options;
  std::string starter_text;
  OpenRadiossDeck starter;
  OpenRadiossEngine engine;
};

class OpenRadiossStructures : public testing::TestWithParam<knit::Structure> {
 protected:
  const Decks decks_{structure_case(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(All, OpenRadiossStructures,
                         testing::Values(knit::Structure::basic, knit::Structure::tied, knit::Structure::adjusted));

TEST_P(OpenRadiossStructures, IsReadWithoutALeftoverAndHoldsTogether) {
  EXPECT_THAT(decks_.starter.unread, IsEmpty());
  EXPECT_THAT(decks_.engine.unread, IsEmpty());
  EXPECT_NO_THROW(check_openradioss(decks_.starter, decks_.engine, "jersey_0000.rad"));
}

TEST_P(OpenRadiossStructures, HasTheNodesOfTheModelAndOneOfOrientationThatIsHeld) {
  const auto& nodes = decks_.starter.nodes;
  ASSERT_EQ(nodes.size(), decks_.model.nodes.size() + 1);
  for (std::size_t i = 0; i < decks_.model.nodes.size(); ++i) {
    // 20 columns, one of them blank: coordinates keep all but their last bits.
    ASSERT_LT((nodes.at(static_cast<int>(i) + 1) - decks_.model.nodes[i]).norm(), 1e-14) << "node " << i + 1;
  }
  EXPECT_THAT(decks_.group("orientation"), ElementsAre(decks_.model.n_nodes() + 1));
}

TEST_P(OpenRadiossStructures, HasTheElementsAlongTheYarnsEachInThePartOfItsSection) {
  int number = 0;
  for (const model::ModelYarn& yarn : decks_.model.yarns) {
    for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes - 1; ++i) {
      const OpenRadiossDeck::Beam& beam = decks_.starter.beams.at(++number);
      EXPECT_THAT(beam.nodes, ElementsAre(i + 1, i + 2, decks_.model.n_nodes() + 1));
      EXPECT_EQ(beam.part, decks_.model.element_section[static_cast<std::size_t>(i)] + 1);
    }
  }
  EXPECT_THAT(decks_.starter.beams, SizeIs(static_cast<std::size_t>(decks_.model.n_elements())));
}

TEST_P(OpenRadiossStructures, NoBeamPointsAtItsNodeOfOrientation) {
  for (const auto& [number, beam] : decks_.starter.beams) {
    const auto& nodes = decks_.starter.nodes;
    const Eigen::Vector3d along = (nodes.at(beam.nodes[1]) - nodes.at(beam.nodes[0])).normalized();
    const Eigen::Vector3d away = (nodes.at(beam.nodes[2]) - nodes.at(beam.nodes[0])).normalized();
    EXPECT_LT(std::abs(along.dot(away)), 0.8) << "beam " << number;
  }
}

TEST_P(OpenRadiossStructures, HasTheStiffnessesAndTheScaledMassOfEverySection) {
  for (const auto& [number, part] : decks_.starter.parts) {
    const yarn::Section& section = decks_.model.sections.at(static_cast<std::size_t>(number) - 1);
    const OpenRadiossDeck::Property& property = decks_.starter.properties.at(part.property);
    const OpenRadiossDeck::Material& material = decks_.starter.materials.at(part.material);
    const auto expect = [](double found, double value) { EXPECT_NEAR(found, value, 1e-11 * value); };
    const double shear_modulus = material.youngs_modulus / (2 * (1 + material.poissons_ratio));
    expect(material.youngs_modulus * property.area, section.axial_stiffness);
    expect(material.youngs_modulus * property.inertia_y, section.bending_stiffness);
    expect(material.youngs_modulus * property.inertia_z, section.bending_stiffness);
    expect(shear_modulus * property.torsion_constant, section.torsional_stiffness);
    expect(property.area, std::numbers::pi * section.diameter * section.diameter / 4);
    expect(material.density * property.area, kMassScaling * section.mass_per_length);
    EXPECT_GE(material.poissons_ratio, 0);
    EXPECT_LT(material.poissons_ratio, 0.5);
    EXPECT_TRUE(property.shear);
  }
}

TEST_P(OpenRadiossStructures, HoldsTheFeetAndTheHeadsAcrossThePull) {
  const auto numbers = [](std::vector<int> nodes) {
    for (int& node : nodes) ++node;
    return nodes;
  };
  EXPECT_EQ(decks_.group("bottom_feet"), numbers(decks_.model.node_sets.at("bottom_feet")));
  EXPECT_EQ(decks_.group("top_heads"), numbers(decks_.model.node_sets.at("top_heads")));
  const auto held = [&](const std::string& title) {
    for (const auto& [number, held] : decks_.starter.held) {
      if (decks_.starter.groups.at(held.group).title == title) return held.directions;
    }
    return std::array<bool, 6>{};
  };
  EXPECT_THAT(held("bottom_feet"), testing::Each(true));
  EXPECT_THAT(held("top_heads"), ElementsAre(true, false, true, true, true, true));
  EXPECT_THAT(held("orientation"), testing::Each(true));
}

TEST_P(OpenRadiossStructures, DrivesTheHeadsWithTheVelocityOfTheTest) {
  ASSERT_THAT(decks_.starter.velocities, SizeIs(1));
  const OpenRadiossDeck::Velocity& velocity = decks_.starter.velocities.begin()->second;
  const OpenRadiossDeck::Function& function = decks_.starter.functions.at(velocity.function);
  EXPECT_EQ(velocity.direction, "Y");
  EXPECT_EQ(decks_.starter.groups.at(velocity.group).title, "top_heads");
  const model::TensileTest& test = decks_.model.test;
  for (const double time : {0.0, 0.1, 0.25, 0.5, 0.6, test.time_at(test.strain)}) {
    EXPECT_NEAR(velocity.scale * function.value(time / velocity.time_scale), test.velocity(time), 1e-12) << time;
  }
}

TEST_P(OpenRadiossStructures, HasTheContactLawAndStiffnessOfChords) {
  ASSERT_THAT(decks_.starter.contacts, SizeIs(1));
  const OpenRadiossDeck::Contact& contact = decks_.starter.contacts.begin()->second;
  EXPECT_EQ(contact.main, 0);  // with themselves
  EXPECT_EQ(contact.stiffness_flag, 1);
  // Two lines in series, and half of that (OpenRadioss, i11cor3.F and i11for3.F): K / 2 / 2.
  EXPECT_NEAR(contact.stiffness / 4, decks_.model.contact_stiffness, 1e-12);
  EXPECT_EQ(contact.friction, decks_.model.friction);
  EXPECT_EQ(contact.friction_form, 2);
  EXPECT_EQ(contact.gap, 0.12);
  EXPECT_EQ(contact.gap_flag, 0);
  std::set<int> of_lines;
  for (const int part : decks_.starter.lines.at(contact.secondary).members) of_lines.insert(part);
  EXPECT_EQ(of_lines.size(), decks_.starter.parts.size());
}

TEST_P(OpenRadiossStructures, RunsAsLongAsTheTestAndWritesAsOftenAsAsked) {
  const double duration = decks_.model.test.time_at(0.22);
  EXPECT_NEAR(decks_.engine.end_time, duration, 1e-12 * duration);
  EXPECT_NEAR(decks_.engine.history_interval, duration / 200, 1e-12);
  EXPECT_NEAR(decks_.engine.picture_interval, duration / 20, 1e-12);
  EXPECT_EQ(decks_.engine.first_picture, 0);
  EXPECT_EQ(decks_.engine.step_share, 0.8);
  EXPECT_EQ(decks_.engine.run, 1);
  EXPECT_THAT(decks_.engine.vectors, ElementsAre("DISP", "CONT"));
}

TEST_P(OpenRadiossStructures, NamesTheRunTheYearAndTheUnitsAlike) {
  EXPECT_EQ(decks_.starter.run_name, "jersey");
  EXPECT_EQ(decks_.engine.run_name, "jersey");
  EXPECT_EQ(decks_.starter.year, 2018);
  EXPECT_EQ(decks_.engine.year, 2018);
  EXPECT_THAT(decks_.starter.units, ElementsAre("Mg", "mm", "s"));
}

TEST_P(OpenRadiossStructures, HasTimeHistoriesOfBothGripsTheContactAndTheParts) {
  std::set<std::string> kinds;
  std::set<int> nodes;
  for (const auto& [number, history] : decks_.starter.histories) {
    kinds.insert(history.kind);
    if (history.kind == "NODE") {
      EXPECT_THAT(history.variables, ElementsAre("DEF", "REACY"));
      nodes.insert(history.members.begin(), history.members.end());
    }
  }
  EXPECT_THAT(kinds, ElementsAre("INTER", "NODE", "PART"));
  std::set<int> of_grips;
  for (const char* grip : {"bottom_feet", "top_heads"}) {
    const std::vector<int> members = decks_.group(grip);
    of_grips.insert(members.begin(), members.end());
  }
  EXPECT_EQ(nodes, of_grips);
}

TEST_P(OpenRadiossStructures, IsTheSameEveryTimeAndNoLineIsLongerThanAHundredColumns) {
  std::ostringstream again;
  write_openradioss_starter(again, decks_.model, decks_.options);
  EXPECT_EQ(again.str(), decks_.starter_text);
  for (const std::string& line : lines_of(decks_.starter_text)) {
    if (line.starts_with('#')) continue;
    ASSERT_LE(line.size(), 100U) << line;
  }
}

TEST(OpenRadiossTies, KeepTheTiedPlacesOfTheElementsTogetherInEachDirection) {
  const Decks decks(structure_case(knit::Structure::tied));
  expect_constraints_of_ties(decks.model, decks.starter.constraints, 1e-14);
}

TEST(OpenRadiossFriction, GivenAnotherOneOfTheEdgeYarn_ThenItIsThatOfItsPairs) {
  const Decks decks(structure_case(knit::Structure::adjusted));
  const int table = decks.starter.contacts.begin()->second.friction_table;
  const OpenRadiossDeck::Friction& friction = decks.starter.frictions.at(table);
  EXPECT_EQ(friction.formulation, 2);
  EXPECT_EQ(friction.of_all, 0.1);
  const std::map<std::pair<int, int>, double> expected = {{{1, 2}, 0.3}, {{2, 2}, 0.3}};
  EXPECT_EQ(friction.of_pairs, expected);
}

TEST(OpenRadiossFriction, GivenOneForAll_ThenThereIsNoTable) {
  const Decks decks(structure_case(knit::Structure::tied));
  EXPECT_THAT(decks.starter.frictions, IsEmpty());
  EXPECT_EQ(decks.starter.contacts.begin()->second.friction_table, 0);
}

TEST(OpenRadiossGap, GivenAnEdgeYarnOfAnotherDiameter_ThenItIsHalfTheSumOfThePartsThicknesses) {
  model::Case input = structure_case(knit::Structure::adjusted);
  input.edge_yarn.diameter = 0.08;
  const Decks decks(input);
  const OpenRadiossDeck::Contact& contact = decks.starter.contacts.begin()->second;
  EXPECT_EQ(contact.gap_flag, 1);
  EXPECT_EQ(contact.gap, 0.08);
  EXPECT_EQ(decks.starter.parts.at(1).thickness, 0.12);
  EXPECT_EQ(decks.starter.parts.at(2).thickness, 0.08);
}

TEST(OpenRadiossGap, GivenElementsThatAreShortForTheYarn_ThenContactAlongItIsLeftOut) {
  model::Case input = fabric_case(2, 2);
  input.fabric.elements_per_erc = 50;  // 0.18 mm, the yarn 0.12 mm
  const Decks decks(input);
  EXPECT_EQ(decks.starter.year, 2020);
  EXPECT_EQ(decks.engine.year, 2020);
  EXPECT_EQ(decks.starter.contacts.begin()->second.removed_gap, 2);
  EXPECT_NO_THROW(check_openradioss(decks.starter, decks.engine, "deck"));
}

TEST(OpenRadiossSection, GivenAYarnThatIsNoCircle_ThenItsStiffnessesAreKept) {
  const Decks decks(measured_yarn_case());
  const OpenRadiossDeck::Property& property = decks.starter.properties.at(1);
  const OpenRadiossDeck::Material& material = decks.starter.materials.at(1);
  EXPECT_NEAR(material.youngs_modulus * property.area, 19.0, 1e-10);
  EXPECT_NEAR(material.youngs_modulus * property.inertia_y, 5e-6, 1e-16);
  EXPECT_NEAR(material.youngs_modulus / 2 * property.torsion_constant, 4e-6, 1e-16);
  EXPECT_EQ(material.poissons_ratio, 0);
}

TEST(OpenRadiossGrips, GivenSlidingOnes_ThenTheHeadsAreFreeAcrossThePull) {
  model::Case input = fabric_case(2, 2);
  input.test.grips = model::Grips::sliding;
  const Decks decks(input);
  EXPECT_THAT(decks.starter.held.at(2).directions, ElementsAre(false, false, false, true, true, true));
}

TEST(OpenRadiossGrips, GivenNoRamp_ThenTheSpeedIsThereFromTheStart) {
  model::Case input = fabric_case(2, 2);
  input.test.ramp = 0;
  const Decks decks(input);
  EXPECT_EQ(decks.starter.functions.at(1).value(0), 1);
  EXPECT_EQ(decks.starter.functions.at(1).value(100), 1);
}

TEST(OpenRadiossStrength, GivenAYarnThatBreaks_ThenTheHeadSaysThatHereItDoesNot) {
  model::Case input = fabric_case(2, 2);
  input.yarn.strength = 4.5;
  EXPECT_THAT(lines_of(Decks(input).starter_text), Contains(HasSubstr("breaks at 4.5 N; here it does not")));
}

TEST(OpenRadiossCurve, GivenAMeasuredTensileCurve_ThenItIsRefused) {
  model::Case input = fabric_case(2, 2);
  input.yarn.youngs_modulus.reset();
  input.yarn.axial_stiffness.reset();
  input.yarn.poissons_ratio = 0.39;
  input.yarn.curve_strains = {0, 0.1, 0.2};
  input.yarn.curve_forces = {0, 1.0, 3.0};
  EXPECT_THAT([&] { Decks decks(input); },
              ThrowsMessage<InputError>(HasSubstr("the elastic beam of OpenRadioss has no measured tensile curve")));
}

TEST(OpenRadiossRunName, GivenOneWithABlank_ThenItIsRefused) {
  const model::Model model = model::build_model(fabric_case(2, 2));
  std::ostringstream out;
  const OpenRadiossOptions options{.run_name = "my fabric"};
  EXPECT_THAT([&] { write_openradioss_starter(out, model, options); },
              ThrowsMessage<InputError>(HasSubstr("\"my fabric\" is none: 1 to 80 letters")));
  EXPECT_EQ(out.str(), "");
}

TEST(OpenRadiossModel, GivenNoNodesInAGrip_ThenItIsRefused) {
  model::Model model = model::build_model(fabric_case(2, 2));
  model.node_sets["top_heads"].clear();
  std::ostringstream out;
  EXPECT_THROW(write_openradioss_starter(out, model, {}), std::invalid_argument);
}

}  // namespace
}  // namespace knitmech::exchange
