#include "exchange/calculix_beams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/errors.h"
#include "deck_models.h"
#include "exchange/calculix_section.h"
#include "exchange/yarn_path.h"

namespace knitmech::exchange {
namespace {

std::string deck_of(const model::Case& input) {
  std::ostringstream text;
  write_calculix_beams(text, model::build_model(input));
  return std::move(text).str();
}

/// The data lines behind each line that begins with a keyword, as numbers; words are left out.
std::vector<std::vector<double>> numbers_behind(const std::string& deck, const std::string& keyword) {
  std::vector<std::vector<double>> cards;
  std::istringstream lines(deck);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('*')) {
      inside = line.starts_with(keyword);
      if (inside) cards.emplace_back();
    } else if (inside) {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream words(line);
      for (double number = 0; words >> number;) cards.back().push_back(number);
    }
  }
  return cards;
}

}  // namespace

// By hand: EA = E a^2, EI = E a^4 / 12, GJ = G a^4 / 6 of a square whose torsion constant is the polar moment.
TEST(CalculixSquare, GivenAMultifilament_ThenItHasItsEaEiAndGj) {
  const yarn::Section yarn = model::build_model(measured_yarn_case()).sections.front();
  const CalculixSquare square = calculix_square(yarn);
  const double area = square.side * square.side;
  EXPECT_NEAR(square.youngs_modulus * area, 19, 1e-12);
  EXPECT_NEAR(square.youngs_modulus * area * area / 12, 5e-6, 1e-18);
  EXPECT_NEAR(square.shear_modulus * area * area / 6, 4e-6, 1e-18);
}

// The middle of an arc is l^2 / (8 r) off its chord.
TEST(YarnPaths, GivenALargestRise_ThenNoElementRisesMoreOverItsChord) {
  const model::Model model = model::build_model(measured_yarn_case());
  const yarn::Section& section = model.sections.front();
  const double gyration = std::sqrt(section.bending_stiffness / section.axial_stiffness);
  double largest = 0;
  for (const YarnPath& path : yarn_paths(model, {.largest_rise = 0.5})) {
    for (std::size_t i = 1; i < path.points.size(); i += 2) {
      const Eigen::Vector3d chord_middle = 0.5 * (path.points[i - 1].point + path.points[i + 1].point);
      largest = std::max(largest, (path.points[i].point - chord_middle).norm());
    }
  }
  EXPECT_LE(largest, 1.15 * 0.5 * gyration);  // the cubic runs a little faster at its ends
  EXPECT_GE(largest, 0.5 * 0.5 * gyration);
}

TEST(CalculixBeams, GivenATiedFabric_ThenEachTieJoinsTwoNodesAtItsPlacesInAllThreeDirections) {
  const model::Case input = structure_case(knit::Structure::tied);
  const model::Model model = model::build_model(input);
  const std::string deck = deck_of(input);
  std::map<int, Eigen::Vector3d> nodes;
  const std::vector<double> table = numbers_behind(deck, "*NODE").front();
  for (std::size_t i = 0; i + 3 < table.size(); i += 4) {
    nodes[static_cast<int>(table[i])] = {table[i + 1], table[i + 2], table[i + 3]};
  }
  const std::vector<std::vector<double>> equations = numbers_behind(deck, "*EQUATION");
  ASSERT_EQ(equations.size(), 3 * model.ties.size());
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const std::vector<double>& terms = equations[i];
    ASSERT_EQ(terms.size(), 7U);
    EXPECT_EQ(terms[0], 2);
    EXPECT_EQ(terms[2], 1 + i % 3);
    EXPECT_EQ(terms[5], 1 + i % 3);
    EXPECT_EQ(terms[3], -terms[6]);
    const double apart = (nodes.at(static_cast<int>(terms[1])) - nodes.at(static_cast<int>(terms[4]))).norm();
    EXPECT_LT(apart, 3 * input.yarn.diameter) << "the yarns of a tie cross there";
  }
}

TEST(CalculixBeams, GivenCoursesThatOnlyContactJoins_ThenRefused) {
  EXPECT_THROW(deck_of(fabric_case(3, 2)), InputError);
  EXPECT_NO_THROW(deck_of(fabric_case(3, 1)));
}

TEST(CalculixBeams, GivenTurningArcsOfFarSofterYarn_ThenRefused) {
  model::Case input = structure_case(knit::Structure::adjusted);
  EXPECT_THROW(deck_of(input), InputError);
  input.edge_yarn.bending_stiffness = 1e-3;
  EXPECT_NO_THROW(deck_of(input));
}

TEST(CalculixBeams, GivenTheSameModelTwice_ThenTheSameText) {
  EXPECT_EQ(deck_of(fabric_case(2, 1)), deck_of(fabric_case(2, 1)));
}

}  // namespace knitmech::exchange
