#include "model/parameters.h"

namespace knitmech::model {
namespace {

using base::Dimension;

// Upper ends of ranges are there to catch slips (a metre for a millimetre, per cent for a ratio), not to limit physics.
constexpr double kLongestLength = 1000;     // [mm]
constexpr double kGreatestStiffness = 1e9;  // [N/mm]
constexpr double kMostStitches = 100000;    // along one side of the fabric
constexpr double kGreatestStrain = 2;       // 200 %

Range above_zero_to(double greatest) {
  return {.least = 0, .greatest = greatest, .least_excluded = true};
}
Range from(double least, double greatest) {
  return {.least = least, .greatest = greatest};
}

std::vector<Parameter> top_of_file() {
  return {{.key = "title",
           .value = "Monofilament jersey, wale-wise tension",
           .help = "what the case is, in a few words",
           .slot = [](Case& c) -> Slot { return &c.title; }}};
}

std::vector<Parameter> loop_parameters() {
  return {
      {.key = "loop.height",
       .symbol = "H",
       .dimension = Dimension::length,
       .value = 7.0,
       .range = above_zero_to(kLongestLength),
       .help = "height of one loop, from the middle of the head to the middle of the foot",
       .slot = [](Case& c) -> Slot { return &c.loop.height; }},
      {.key = "loop.width",
       .symbol = "L",
       .dimension = Dimension::length,
       .value = 3.9,
       .range = above_zero_to(kLongestLength),
       .help = "width of one stitch, the spacing of the wales",
       .slot = [](Case& c) -> Slot { return &c.loop.width; }},
      {.key = "loop.head_flat",
       .symbol = "l1",
       .dimension = Dimension::length,
       .value = 0.2,
       .range = from(0, kLongestLength),
       .help = "half the length of the flat top of the head",
       .slot = [](Case& c) -> Slot { return &c.loop.head_flat; }},
      {.key = "loop.head_radius",
       .symbol = "R1",
       .dimension = Dimension::length,
       .value = 1.1,
       .range = above_zero_to(kLongestLength),
       .help = "radius of the head arc, of the yarn's centreline",
       .slot = [](Case& c) -> Slot { return &c.loop.head_radius; }},
      {.key = "loop.foot_flat",
       .symbol = "l2",
       .dimension = Dimension::length,
       .value = 0.2,
       .range = from(0, kLongestLength),
       .help = "half the length of the flat bottom of the foot",
       .slot = [](Case& c) -> Slot { return &c.loop.foot_flat; }},
      {.key = "loop.foot_radius",
       .symbol = "R2",
       .dimension = Dimension::length,
       .value = 1.0,
       .range = above_zero_to(kLongestLength),
       .help = "radius of the foot arc, of the yarn's centreline",
       .slot = [](Case& c) -> Slot { return &c.loop.foot_radius; }},
      {.key = "loop.out_of_plane",
       .symbol = "p",
       .dimension = Dimension::inverse_length,
       .need = Need::automatic,
       .value = 0.02,
       .range = above_zero_to(100),
       .help = "depth of the loop, z = -p y^2; auto takes the least p at which no yarns overlap",
       .slot = [](Case& c) -> Slot { return &c.loop.out_of_plane; }},
  };
}

std::vector<Parameter> fabric_parameters() {
  return {
      {.key = "fabric.wales",
       .symbol = "W",
       .value = 9,
       .range = from(1, kMostStitches),
       .help = "stitches in a course",
       .slot = [](Case& c) -> Slot { return &c.fabric.wales; }},
      {.key = "fabric.courses",
       .symbol = "C",
       .value = 15,
       .range = from(1, kMostStitches),
       .help = "courses of the fabric",
       .slot = [](Case& c) -> Slot { return &c.fabric.courses; }},
      {.key = "fabric.course_spacing",
       .symbol = "T",
       .dimension = Dimension::length,
       .value = 5.0,
       .range = above_zero_to(kLongestLength),
       .help = "distance between neighbouring courses",
       .slot = [](Case& c) -> Slot { return &c.fabric.course_spacing; }},
      {.key = "fabric.structure",
       .need = Need::defaulted,
       .value = "basic",
       .choices = {"basic", "tied", "adjusted"},
       .help = "how courses are joined at the side edges; basic: every course is a yarn of its own, tied: as basic "
               "and the crossings of the edge stitches are tied, adjusted: turning arcs join the courses to one yarn",
       .slot = [](Case& c) -> Slot { return &c.fabric.structure; }},
      {.key = "fabric.elements_per_erc",
       .symbol = "N",
       .need = Need::defaulted,
       .value = 10,
       .range = from(4, 1000),
       .help = "beam elements of equal length on each half stitch (ERC); usual are 10, 20 and 30",
       .slot = [](Case& c) -> Slot { return &c.fabric.elements_per_erc; }},
  };
}

std::vector<Parameter> contact_parameters() {
  return {
      {.key = "contact.friction",
       .symbol = "mu",
       .value = 0.1,
       .range = from(0, 5),
       .help = "coefficient of friction of yarn on yarn (Coulomb)",
       .slot = [](Case& c) -> Slot { return &c.contact.friction; }},
      {.key = "contact.edge_friction",
       .need = Need::automatic,
       .from = FabricFrom::loops,
       .value = 0.2,
       .range = from(0, 5),
       .help = "the same of the edge yarn on any yarn; auto takes friction",
       .slot = [](Case& c) -> Slot { return &c.contact.edge_friction; }},
      {.key = "contact.centreline",
       .need = Need::defaulted,
       .value = "smooth",
       .choices = {"smooth", "chords"},
       .help = "where the contact sees the yarn; smooth: on the curve through the nodes, chords: on the straight "
               "beam elements, as other programs do",
       .slot = [](Case& c) -> Slot { return &c.contact.centreline; }},
      {.key = "contact.stiffness",
       .dimension = Dimension::stiffness,
       .need = Need::automatic,
       .value = 16.0,
       .range = above_zero_to(kGreatestStiffness),
       .help = "force per penetration of one crossing; auto takes 0.1 EA / D",
       .slot = [](Case& c) -> Slot { return &c.contact.stiffness; }},
  };
}

std::vector<Parameter> test_parameters() {
  return {
      {.key = "test.kind",
       .need = Need::defaulted,
       .value = "wale-tension",
       .choices = {"wale-tension"},
       .help = "wale-tension: the lowest feet are held, the top heads are pulled along the wales",
       .slot = [](Case& c) -> Slot { return &c.test.kind; }},
      {.key = "test.strain",
       .need = Need::defaulted,
       .value = 0.22,
       .range = above_zero_to(kGreatestStrain),
       .help = "strain at the end of the test, of the distance between the grips (0.22 is 22 %)",
       .slot = [](Case& c) -> Slot { return &c.test.strain; }},
      {.key = "test.speed",
       .dimension = Dimension::speed,
       .need = Need::defaulted,
       .value = 5.0,
       .range = above_zero_to(1e5),
       .help = "speed of the moving grip; with solver.mass_scaling = auto only a measure, since the program adapts it",
       .slot = [](Case& c) -> Slot { return &c.test.speed; }},
      {.key = "test.ramp",
       .dimension = Dimension::time,
       .need = Need::defaulted,
       .value = 0.5,
       .range = from(0, 1e4),
       .help = "time over which the grip gains its speed from rest, where the speed is not adapted",
       .slot = [](Case& c) -> Slot { return &c.test.ramp; }},
      {.key = "test.grips",
       .need = Need::defaulted,
       .value = "clamped",
       .choices = {"clamped", "sliding"},
       .help = "clamped: the pulled heads cannot move across the pull; sliding: they can",
       .slot = [](Case& c) -> Slot { return &c.test.grips; }},
      {.key = "test.on_break",
       .need = Need::defaulted,
       .value = "stop",
       .choices = {"stop", "go on"},
       .help = "what a yarn that breaks does; stop: it ends the test, go on: the test continues with the broken yarn",
       .slot = [](Case& c) -> Slot { return &c.test.on_break; }},
  };
}

std::vector<Parameter> solver_parameters() {
  return {
      {.key = "solver.mass_scaling",
       .need = Need::automatic,
       .value = 1e4,
       .range = from(1, 1e12),
       .help =
           "factor on every mass, for longer time steps; a number keeps test.speed as it is given, auto chooses the "
           "mass for test.speed and adapts the speed while the test runs, so that it stays quasi-static",
       .slot = [](Case& c) -> Slot { return &c.solver.mass_scaling; }},
      {.key = "solver.bulk_viscosity",
       .need = Need::defaulted,
       .value = 0.06,
       .range = from(0, 1),
       .help = "linear bulk viscosity, damps the shortest axial waves",
       .slot = [](Case& c) -> Slot { return &c.solver.bulk_viscosity; }},
      {.key = "solver.mass_damping",
       .dimension = Dimension::inverse_time,
       .need = Need::defaulted,
       .value = 0.0,
       .range = from(0, 1e6),
       .help = "damping force per mass and velocity",
       .slot = [](Case& c) -> Slot { return &c.solver.mass_damping; }},
      {.key = "solver.step_factor",
       .need = Need::defaulted,
       .value = 0.9,
       .range = above_zero_to(1),
       .help = "share of the stable time step that is used",
       .slot = [](Case& c) -> Slot { return &c.solver.step_factor; }},
  };
}

std::vector<Parameter> output_parameters() {
  return {
      {.key = "output.frames_at",
       .need = Need::defaulted,
       .value = std::vector<double>{0.022, 0.08, 0.16, 0.22, 0.42},
       .range = from(0, kGreatestStrain),
       .help = "strains of stored frames, besides start and end; the default is cut to test.strain",
       .slot = [](Case& c) -> Slot { return &c.output.frames_at; }},
      {.key = "output.history_points",
       .need = Need::defaulted,
       .value = 1000,
       .range = from(1, 1e6),
       .help = "rows of the history (forces, energies) over the test",
       .slot = [](Case& c) -> Slot { return &c.output.history_points; }},
      {.key = "output.checkpoint_every",
       .dimension = Dimension::time,
       .need = Need::defaulted,
       .value = 60.0,
       .range = from(0, 1e6),
       .help = "real time between two checkpoints, from which knitmech run --resume goes on; 0 s: only where a run is "
               "interrupted; without effect on the results",
       .slot = [](Case& c) -> Slot { return &c.output.checkpoint_every; }},
  };
}

std::vector<Parameter> of_loops(std::vector<Parameter> parameters) {
  for (Parameter& parameter : parameters) parameter.from = FabricFrom::loops;
  return parameters;
}

std::vector<Parameter> all_parameters() {
  std::vector<Parameter> all;
  for (const auto& part :
       {top_of_file(), of_loops(loop_parameters()), of_loops(fabric_parameters()), parameters_of_file(),
        parameters_of_yarns(), contact_parameters(), test_parameters(), solver_parameters(), output_parameters()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> table = all_parameters();
  return table;
}

const std::vector<CaseSection>& sections() {
  static const std::vector<CaseSection> table{
      {.name = "", .help = "The whole case"},
      {.name = "loop", .help = "The loop, measured on the yarn's centreline"},
      {.name = "fabric", .help = "The piece of fabric and its mesh"},
      {.name = "yarn",
       .help = "The yarn: a monofilament by E and nu, a multifilament by its filaments, or EA, EI and GJ outright"},
      {.name = "edge_yarn",
       .help = "The yarn of the turning arcs of fabric.structure \"adjusted\"; without effect in the others. By its "
               "stiffnesses, or by a material and filaments, like the yarn"},
      {.name = "contact", .help = "Yarn against yarn"},
      {.name = "test", .help = "The tensile test"},
      {.name = "solver", .help = "Explicit dynamics"},
      {.name = "output", .help = "What is stored"},
  };
  return table;
}

}  // namespace knitmech::model
