#pragma once

#include <optional>
#include <string>
#include <vector>

#include "knit/fabric.h"

namespace knitmech::model {

/// What the contact sees of a yarn: the smooth curve through its nodes, or the straight chords of its elements.
enum class Centreline { smooth, chords };
enum class TestKind { wale_tension };
enum class Grips { clamped, sliding };

/// All input of one simulation, in internal units (mm, N, s, t, MPa, mJ). A member that is empty means "auto" or "not
/// given". The table in model/parameters.h tells key, dimension, default, range and meaning of each.
struct Case {
  std::string title;

  struct Loop {
    double height = 0, width = 0;           ///< [mm]
    double head_flat = 0, head_radius = 0;  ///< [mm]
    double foot_flat = 0, foot_radius = 0;  ///< [mm]
    std::optional<double> out_of_plane;     ///< p [1/mm]; empty: the least p without overlap
  } loop;

  struct Fabric {
    int wales = 0, courses = 0;
    double course_spacing = 0;  ///< [mm]
    knit::Structure structure = knit::Structure::basic;
    int elements_per_erc = 0;
  } fabric;

  struct Yarn {
    double diameter = 0;                        ///< [mm]
    double density = 0;                         ///< [t/mm^3]
    std::optional<double> youngs_modulus;       ///< E [MPa]
    std::optional<double> poissons_ratio;       ///< nu [-]
    std::optional<double> axial_stiffness;      ///< EA [N], instead of E and nu, together with the next two
    std::optional<double> bending_stiffness;    ///< EI [N mm^2]
    std::optional<double> torsional_stiffness;  ///< GJ [N mm^2]
  } yarn;

  struct Contact {
    double friction = 0;  ///< mu [-]
    Centreline centreline = Centreline::smooth;
    std::optional<double> stiffness;  ///< [N/mm], penalty of one crossing; empty: from the yarn's section
  } contact;

  struct Test {
    TestKind kind = TestKind::wale_tension;
    double strain = 0;             ///< [-], at the end of the test
    double speed = 0;              ///< [mm/s], of the grip
    double ramp = 0;               ///< [s], from rest to the speed
    Grips grips = Grips::clamped;  ///< sliding: the top grip is free to move across the pull
  } test;

  struct Solver {
    std::optional<double> mass_scaling;  ///< factor on the density; empty: chosen by the program
    double bulk_viscosity = 0;           ///< [-]
    double mass_damping = 0;             ///< [1/s]
    double step_factor = 0;              ///< [-], share of the stable step that is used
  } solver;

  struct Output {
    std::vector<double> frames_at;  ///< strains, ascending, each at most test.strain
    int history_points = 0;         ///< rows of history.csv over the test
  } output;
};

}  // namespace knitmech::model
