#include <fmt/format.h>

#include <ostream>
#include <string>

#include "exchange/abaqus_number.h"
#include "exchange/abaqus_parts.h"

namespace knitmech::exchange::deck {

namespace {

constexpr const char* kAmplitude = "GRIP_VELOCITY";
constexpr int kFieldFrames = 50;
constexpr int kHistoryPoints = 1000;

double test_duration(const model::TensileTest& test) {
  return test.time_at(test.strain);
}

/// Velocity of the driven grip as a share of the speed: a point at the start, at the end of the ramp, at the end.
void write_amplitude(std::ostream& out, const model::TensileTest& test) {
  line(out, "*AMPLITUDE, NAME={}, DEFINITION=TABULAR, TIME=STEP TIME", kAmplitude);
  std::string points = test.ramp > 0 ? fmt::format("0., 0., {}, 1.", abaqus_number(test.ramp)) : "0., 1.";
  const double duration = test_duration(test);
  if (duration > test.ramp) points += fmt::format(", {}, 1.", abaqus_number(duration));
  line(out, "{}", points);
}

void write_held_grip(std::ostream& out, const model::TensileTest& test) {
  out << "*BOUNDARY\n";
  line(out, "{}, 1, 6", test.held_set);
  if (test.grips == model::Grips::clamped) {
    line(out, "{}, 1, 1", test.driven_set);
    line(out, "{}, 3, 6", test.driven_set);
  } else {
    line(out, "{}, 4, 6", test.driven_set);
  }
}

void write_output(std::ostream& out, const model::TensileTest& test) {
  line(out, "*OUTPUT, FIELD, NUMBER INTERVAL={}", kFieldFrames);
  out << "*NODE OUTPUT\nU, RF\n";
  line(out, "*ELEMENT OUTPUT, ELSET={}", kAllElements);
  out << "SF, SE\n*CONTACT OUTPUT, GENERAL CONTACT\nCFORCE\n";
  line(out, "*OUTPUT, HISTORY, TIME INTERVAL={}", abaqus_number(test_duration(test) / kHistoryPoints));
  line(out, "*NODE OUTPUT, NSET={}", test.driven_set);
  out << "U2, RF2\n";
  line(out, "*NODE OUTPUT, NSET={}", test.held_set);
  out << "RF2\n*ENERGY OUTPUT\nALLWK, ALLIE, ALLKE, ALLFD, ALLVD, ETOTAL\n";
}

}  // namespace

void write_grips(std::ostream& out, const model::TensileTest& test) {
  caption(out, "GRIPS: the share of the speed over time, and what is held from the start");
  write_amplitude(out, test);
  write_held_grip(out, test);
}

void write_step(std::ostream& out, const model::TensileTest& test, const AbaqusOptions& options) {
  caption(out, "THE TEST");
  out << "*STEP, NAME=TENSION, NLGEOM=YES\n*DYNAMIC, EXPLICIT\n";
  line(out, ", {}", abaqus_number(test_duration(test)));
  out << "*BULK VISCOSITY\n";
  line(out, "{}, 0.", abaqus_number(options.bulk_viscosity));
  if (options.mass_scaling != 1) {
    line(out, "*FIXED MASS SCALING, FACTOR={}", abaqus_number(options.mass_scaling));
  }
  line(out, "*BOUNDARY, TYPE=VELOCITY, AMPLITUDE={}", kAmplitude);
  line(out, "{}, 2, 2, {}", test.driven_set, abaqus_number(test.speed));
  write_output(out, test);
  out << "*END STEP\n";
}

}  // namespace knitmech::exchange::deck
