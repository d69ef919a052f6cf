#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "exchange/abaqus_reader.h"
#include "exchange/abaqus_writer.h"
#include "model/build_model.h"

namespace knitmech::exchange {

/// A monofilament fabric of the loop of the main example, N10, mu 0.1, clamped, 22 % at 5 mm/s after a ramp of 0.5 s.
inline model::Case fabric_case(int wales, int courses) {
  model::Case input;
  input.title = "Monofilament jersey, wale-wise tension";
  input.loop = {7.0, 3.9, 0.2, 1.1, 0.2, 1.0, 0.02};
  input.fabric.wales = wales;
  input.fabric.courses = courses;
  input.fabric.course_spacing = 5.0;
  input.fabric.elements_per_erc = 10;
  input.yarn.diameter = 0.12;
  input.yarn.density = 1.14e-9;
  input.yarn.youngs_modulus = 1700;
  input.yarn.poissons_ratio = 0.39;
  input.contact.friction = 0.1;
  input.test = {model::TestKind::wale_tension, 0.22, 5.0, 0.5, model::Grips::clamped};
  return input;
}

/// A small fabric of a multifilament yarn, EA, EI and GJ given outright: far softer in bending than a solid circle.
inline model::Case measured_yarn_case() {
  model::Case input = fabric_case(3, 2);
  input.yarn.youngs_modulus.reset();
  input.yarn.poissons_ratio.reset();
  input.yarn.axial_stiffness = 19.0;
  input.yarn.bending_stiffness = 5e-6;
  input.yarn.torsional_stiffness = 4e-6;
  return input;
}

/// A fabric of 4 x 3 stitches of a structure; if it has turning arcs, with another friction of the edge yarn.
inline model::Case structure_case(knit::Structure structure) {
  model::Case input = fabric_case(4, 3);
  input.fabric.structure = structure;
  if (structure == knit::Structure::adjusted) input.contact.edge_friction = 0.3;
  return input;
}

/// Expects the terms of equations, three for each tie of a model, to be the displacement of the first place of the tie
/// less that of the second, whatever the displacements of the nodes. \param constraints by number, from 1
template <typename Constraints>
void expect_constraints_of_ties(const model::Model& model, const Constraints& constraints, double tolerance) {
  ASSERT_EQ(constraints.size(), 3 * model.ties.size());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Eigen::Vector3d> moved;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    moved.emplace_back(uniform(random), uniform(random), uniform(random));
  }
  const auto at = [&](model::ElementPlace place) {
    const auto i = static_cast<std::size_t>(place.element);
    return Eigen::Vector3d((1 - place.share) * moved[i] + place.share * moved[i + 1]);
  };
  int number = 0;
  for (const model::Tie& tie : model.ties) {
    for (int axis = 0; axis < 3; ++axis) {
      double left = 0;
      for (const auto& term : constraints.at(++number).terms) {
        EXPECT_EQ(term.direction, axis + 1);
        left += term.coefficient * moved[static_cast<std::size_t>(term.node) - 1][axis];
      }
      EXPECT_NEAR(left, (at(tie.first) - at(tie.second))[axis], tolerance);
    }
  }
}

inline std::string deck_text(const model::Model& model, const AbaqusOptions& options = {}) {
  std::ostringstream out;
  write_abaqus(out, model, options);
  return out.str();
}

inline AbaqusDeck deck_of(const std::string& text) {
  std::istringstream in(text);
  return read_abaqus(in, "deck.inp");
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace knitmech::exchange
