#include "exchange/calculix_solids.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "base/errors.h"
#include "deck_models.h"
#include "exchange/abaqus_lines.h"
#include "hexahedron.h"
#include "model/places.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;

/// The nodes of a section with the axes of their displacements.
struct Axes {
  std::set<int> nodes;
  Eigen::Matrix3d rows;  ///< axes 1, 2 and 3
};

struct Condition {
  std::set<int> nodes;
  int axis = 0;  ///< 1 to 3
  double value = 0;
};

struct Term {
  int node = 0, direction = 0;
  double coefficient = 0;
};

/// A deck for CalculiX, read by keyword.
struct SolidDeck {
  std::map<int, Vector3d> nodes;
  std::map<int, std::array<int, 20>> elements;
  std::map<std::string, std::set<int>> node_sets;
  std::vector<Axes> axes;
  std::vector<Condition> held, driven;  ///< before the step and in it
  std::vector<std::vector<Term>> equations;
  std::set<std::pair<std::string, std::string>> contact_pairs;
  std::map<std::string, int> keywords;
};

double number(const std::string& entry) {
  return real_number("deck", 0, entry);
}
int whole(const std::string& entry) {
  return integer("deck", 0, entry);
}

std::vector<std::string> all_entries(const KeywordBlock& block) {
  std::vector<std::string> entries;
  for (const DataLine& line : block.data) {
    for (const std::string& entry : line.entries) {
      if (!entry.empty()) entries.push_back(entry);
    }
  }
  return entries;
}

std::vector<Condition> conditions_of(const SolidDeck& deck, const KeywordBlock& block) {
  std::vector<Condition> conditions;
  for (const DataLine& line : block.data) {
    const bool one_node = looks_like_number(line.entry(0));
    const std::set<int> nodes = one_node ? std::set<int>{whole(line.entry(0))} : deck.node_sets.at(line.entry(0));
    for (int axis = whole(line.entry(1)); axis <= whole(line.entry(2)); ++axis) {
      conditions.push_back({nodes, axis, number(line.entry(3))});
    }
  }
  return conditions;
}

void read_elements(SolidDeck& deck, const KeywordBlock& block) {
  EXPECT_EQ(block.option("TYPE"), "C3D20R");
  const std::vector<std::string> entries = all_entries(block);
  ASSERT_EQ(entries.size() % 21, 0u);
  for (std::size_t i = 0; i < entries.size(); i += 21) {
    std::array<int, 20> nodes{};
    for (std::size_t k = 0; k < 20; ++k) nodes[k] = whole(entries[i + 1 + k]);
    EXPECT_TRUE(deck.elements.emplace(whole(entries[i]), nodes).second) << "element " << entries[i] << " twice";
  }
}

void read_equation(SolidDeck& deck, const KeywordBlock& block) {
  const std::vector<std::string> entries = all_entries(block);
  ASSERT_EQ(entries.size(), 1 + 3 * static_cast<std::size_t>(whole(entries[0])));
  std::vector<Term>& terms = deck.equations.emplace_back();
  for (std::size_t i = 1; i < entries.size(); i += 3) {
    terms.push_back({whole(entries[i]), whole(entries[i + 1]), number(entries[i + 2])});
  }
}

SolidDeck read_solids(const std::string& text) {
  std::istringstream in(text);
  SolidDeck deck;
  for (const KeywordBlock& block : read_keyword_blocks(in, "deck")) {
    ++deck.keywords[block.keyword];
    if (block.keyword == "NODE") {
      for (const DataLine& line : block.data) {
        deck.nodes[whole(line.entry(0))] = {number(line.entry(1)), number(line.entry(2)), number(line.entry(3))};
      }
    } else if (block.keyword == "ELEMENT") {
      read_elements(deck, block);
    } else if (block.keyword == "NSET") {
      for (const std::string& entry : all_entries(block)) deck.node_sets[block.option("NSET")].insert(whole(entry));
    } else if (block.keyword == "TRANSFORM") {
      std::vector<double> values;
      for (const std::string& entry : all_entries(block)) values.push_back(number(entry));
      const Vector3d along(values[0], values[1], values[2]), across(values[3], values[4], values[5]);
      Eigen::Matrix3d rows;
      rows << along.transpose(), across.transpose(), along.cross(across).transpose();
      deck.axes.push_back({deck.node_sets.at(block.option("NSET")), rows});
    } else if (block.keyword == "BOUNDARY") {
      (deck.keywords.contains("STEP") ? deck.driven : deck.held) = conditions_of(deck, block);
    } else if (block.keyword == "EQUATION") {
      read_equation(deck, block);
    } else if (block.keyword == "CONTACTPAIR") {
      deck.contact_pairs.emplace(block.data.at(0).entry(0), block.data.at(0).entry(1));
    }
  }
  return deck;
}

std::string solids_text(const model::Model& model) {
  std::ostringstream out;
  write_calculix_solids(out, model);
  return out.str();
}

const Axes* axes_at(const SolidDeck& deck, int node) {
  for (const Axes& each : deck.axes) {
    if (each.nodes.contains(node)) return &each;
  }
  return nullptr;
}

/// How far a displacement is from fulfilling conditions, at worst [mm].
double worst_violation(const SolidDeck& deck, const std::vector<Condition>& conditions,
                       const std::function<Vector3d(int)>& displacement) {
  double worst = 0;
  for (const Condition& condition : conditions) {
    for (const int node : condition.nodes) {
      const Axes* axes = axes_at(deck, node);
      const Vector3d local = axes == nullptr ? displacement(node) : Vector3d(axes->rows * displacement(node));
      worst = std::max(worst, std::abs(local[condition.axis - 1] - condition.value));
    }
  }
  return worst;
}

Vector3d middle_of(const SolidDeck& deck, const std::set<int>& nodes) {
  Vector3d middle(0, 0, 0);
  for (const int node : nodes) middle += deck.nodes.at(node) / static_cast<double>(nodes.size());
  return middle;
}

double area_of(const model::Model& model) {
  const double diameter = model.sections.front().diameter;
  return std::numbers::pi / 4 * diameter * diameter;
}

TEST(CalculixSolids, GivenAFabric_ThenNoElementIsFoldedAndItsVolumeIsThatOfTheYarn) {
  const model::Model model = model::build_model(fabric_case(2, 2));
  const SolidDeck deck = read_solids(solids_text(model));
  double least = std::numeric_limits<double>::infinity(), volume = 0;
  for (const auto& [number, nodes] : deck.elements) {
    std::array<Vector3d, 20> corners;
    for (std::size_t i = 0; i < 20; ++i) corners[i] = deck.nodes.at(nodes[i]);
    volume += test::integrate_over(corners, 3, least, [](const Vector3d&) { return 1.0; });
  }
  EXPECT_GT(least, 0);
  const double expected = model::yarn_length_of(model) * area_of(model);
  EXPECT_NEAR(volume, expected, 2e-3 * expected);  // the model's length is that of its chords
}

TEST(CalculixSolids, GivenAFabric_ThenEachCourseTouchesTheNextAndNoOther) {
  const SolidDeck deck = read_solids(solids_text(model::build_model(fabric_case(2, 3))));
  const std::set<std::pair<std::string, std::string>> expected{{"SURFACE_2", "SURFACE_1"}, {"SURFACE_3", "SURFACE_2"}};
  EXPECT_EQ(deck.contact_pairs, expected);
}

TEST(CalculixSolids, GivenTheGrips_ThenTheirMotionFulfilsAllConditions) {
  const model::Model model = model::build_model(fabric_case(2, 2));
  const SolidDeck deck = read_solids(solids_text(model));
  const Vector3d up(0, model.test.strain * model.test.gauge_length, 0);
  ASSERT_FALSE(deck.held.empty());
  ASSERT_FALSE(deck.driven.empty());
  EXPECT_LT(worst_violation(deck, deck.held, [](int) { return Vector3d(0, 0, 0); }), 1e-15);
  EXPECT_LT(worst_violation(deck, deck.driven, [&](int) { return up; }), 1e-12);
  EXPECT_GT(worst_violation(deck, deck.driven, [&](int) { return Vector3d(0.99 * up); }), 1e-3);
  EXPECT_GT(worst_violation(deck, deck.held, [](int) { return Vector3d(0.01, 0, 0); }), 1e-3);
}

TEST(CalculixSolids, GivenClampedSections_ThenTheyMayContractButNeitherMoveNorTurn) {
  const model::Model model = model::build_model(fabric_case(1, 1));
  const SolidDeck deck = read_solids(solids_text(model));
  ASSERT_EQ(deck.axes.size(), 4u);  // a foot at each end of the yarn, and the head cuts it once on either side
  std::vector<Condition> conditions = deck.held;
  for (Condition each : deck.driven) {
    each.value = 0;
    conditions.push_back(each);
  }
  for (const Axes& section : deck.axes) {
    const Vector3d middle = middle_of(deck, section.nodes);
    EXPECT_TRUE((section.rows * section.rows.transpose()).isIdentity(1e-12));
    std::vector<Condition> here;
    for (const Condition& each : conditions) {
      if (section.nodes.contains(*each.nodes.begin())) here.push_back(each);
    }
    const auto from_middle = [&](int node) { return Vector3d(deck.nodes.at(node) - middle); };
    EXPECT_LT(worst_violation(deck, here, [&](int node) { return Vector3d(-0.1 * from_middle(node)); }), 1e-12);
    for (int k = 0; k < 3; ++k) {
      const Vector3d axis = section.rows.row(k);
      EXPECT_GT(worst_violation(deck, here, [&](int) { return Vector3d(0.01 * axis); }), 9e-3);
      const auto turned = [&](int node) { return Vector3d(0.1 * axis.cross(from_middle(node))); };
      EXPECT_GT(worst_violation(deck, here, turned), 3e-3);
    }
  }
}

TEST(CalculixSolids, GivenAPartInAGrip_ThenItSharesNoNodeWithTheFreePart) {
  const SolidDeck deck = read_solids(solids_text(model::build_model(fabric_case(1, 1))));
  std::set<int> bodies = deck.node_sets.at("HELD_BODIES");
  bodies.insert(deck.node_sets.at("DRIVEN_BODIES").begin(), deck.node_sets.at("DRIVEN_BODIES").end());
  for (const auto& [number, nodes] : deck.elements) {
    const auto in_bodies = std::ranges::count_if(nodes, [&](int node) { return bodies.contains(node); });
    EXPECT_TRUE(in_bodies == 0 || in_bodies == 20) << "element " << number;
  }
}

TEST(CalculixSolids, GivenATiedFabric_ThenItsEquationsJoinTheMiddlesOfTwoSections) {
  model::Case input = structure_case(knit::Structure::tied);
  input.fabric.elements_per_erc = 40;  // places are on chords, which lie 0.01 mm beside the yarn at most then
  const model::Model model = model::build_model(input);
  const SolidDeck deck = read_solids(solids_text(model));
  ASSERT_FALSE(model.ties.empty());
  ASSERT_EQ(deck.equations.size(), 3 * model.ties.size());
  std::set<std::pair<int, int>> eliminated;
  for (std::size_t i = 0; i < deck.equations.size(); ++i) {
    double sum = 0;
    Vector3d difference(0, 0, 0), middle(0, 0, 0);
    for (const Term& term : deck.equations[i]) {
      EXPECT_EQ(term.direction, static_cast<int>(i % 3) + 1);
      EXPECT_EQ(axes_at(deck, term.node), nullptr);
      sum += term.coefficient;
      difference += term.coefficient * deck.nodes.at(term.node);
      middle += std::abs(term.coefficient) / 2 * deck.nodes.at(term.node);
    }
    const auto& tie = model.ties[i / 3];
    const auto at = [&](model::ElementPlace place) {
      const auto node = static_cast<std::size_t>(place.element);
      return Vector3d((1 - place.share) * model.nodes[node] + place.share * model.nodes[node + 1]);
    };
    EXPECT_NEAR(sum, 0, 1e-12);
    EXPECT_NEAR((difference - (at(tie.first) - at(tie.second))).norm(), 0, 0.01);
    EXPECT_NEAR((middle - (at(tie.first) + at(tie.second)) / 2).norm(), 0, 0.02);
    EXPECT_TRUE(eliminated.emplace(deck.equations[i].front().node, deck.equations[i].front().direction).second);
  }
}

TEST(CalculixSolids, GivenWhatASolidCannotBe_ThenTheModelIsRefused) {
  EXPECT_THROW(solids_text(model::build_model(measured_yarn_case())), InputError);
  EXPECT_THROW(solids_text(model::build_model(structure_case(knit::Structure::adjusted))), InputError);
  model::Case sliding = fabric_case(2, 2);
  sliding.test.grips = model::Grips::sliding;
  EXPECT_THROW(solids_text(model::build_model(sliding)), InputError);
}

}  // namespace
}  // namespace knitmech::exchange
