#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "curves/yarn_file.h"
#include "knit/fabric.h"

namespace knitmech::model {

/// What the contact sees of a yarn: the smooth curve through its nodes, or the straight chords of its elements.
enum class Centreline { smooth, chords };
enum class TestKind { wale_tension };
enum class Grips { clamped, sliding };
/// What a yarn that breaks does to the test.
enum class OnBreak { stop, go_on };

/// Which axes of a file of yarns become x (along the course), y (along the wale) and z (out of plane), in this order.
/// The last three would mirror the fabric, so that knit became purl; there z runs against the axis of the file.
enum class FileAxes { xyz, yzx, zxy, xzy, yxz, zyx };

/// The stiffness of a yarn in one of three ways: the material of a monofilament (E with nu or G); the filaments of a
/// twisted multifilament, with the material of one; or EA, EI and GJ outright.
struct YarnStiffness {
  std::optional<double> youngs_modulus;       ///< E [MPa]
  std::optional<double> poissons_ratio;       ///< nu [-]
  std::optional<double> shear_modulus;        ///< G [MPa], in place of nu
  std::optional<int> filaments;               ///< n
  std::optional<double> filament_diameter;    ///< [mm]
  std::optional<double> twist;                ///< turns per length [1/mm]
  std::optional<double> axial_stiffness;      ///< EA [N]
  std::optional<double> bending_stiffness;    ///< EI [N mm^2]
  std::optional<double> torsional_stiffness;  ///< GJ [N mm^2]
};

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

    // A fabric from a file of yarns, in place of the loop and of what stands above.
    std::string yarns;           ///< the file's name beside the case, curves::plain_name(); empty: a fabric of loops
    std::string yarns_checksum;  ///< curves::checksum_of() the file; empty: a fabric of loops
    std::optional<double> file_unit;  ///< what 1 in the file is [mm]; empty: the file says it itself
    FileAxes file_axes = FileAxes::xyz;
    std::optional<double> element_length;               ///< wanted [mm]; empty: a tenth of a half stitch
    std::optional<double> grip_depth;                   ///< [mm], along y; empty: chosen, see build_from_file()
    std::shared_ptr<const curves::YarnFile> yarn_file;  ///< never changes; null: a fabric of loops
  } fabric;

  struct Yarn : YarnStiffness {
    double diameter = 0;  ///< [mm]
    double density = 0;   ///< [t/mm^3]; of the filaments, if the yarn is given by them
    std::vector<double>
        curve_strains;                 ///< [-], of a measured tensile curve in place of E or EA; empty if there is none
    std::vector<double> curve_forces;  ///< [N], as many
    std::optional<double> strength;    ///< tensile force at which the yarn breaks [N]; empty: it never does
  } yarn;

  /// The yarn of the turning arcs. What is empty follows from `yarn`, see edge_section_of().
  struct EdgeYarn : YarnStiffness {
    std::optional<double> diameter;  ///< [mm]
    std::optional<double> density;   ///< [t/mm^3]
  } edge_yarn;

  struct Contact {
    double friction = 0;                  ///< mu [-]
    std::optional<double> edge_friction;  ///< mu of the edge yarn on any yarn [-]; empty: friction
    Centreline centreline = Centreline::smooth;
    std::optional<double> stiffness;  ///< [N/mm], penalty of one crossing; empty: from the yarn's section
  } contact;

  struct Test {
    TestKind kind = TestKind::wale_tension;
    double strain = 0;             ///< [-], at the end of the test
    double speed = 0;              ///< [mm/s], of the grip
    double ramp = 0;               ///< [s], from rest to the speed
    Grips grips = Grips::clamped;  ///< sliding: the top grip is free to move across the pull
    OnBreak on_break = OnBreak::stop;
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
    double checkpoint_every = 0;    ///< [s], of real time between two checkpoints; 0: none but where interrupted
  } output;
};

}  // namespace knitmech::model
