#include "model/parameters.h"

namespace knitmech::model {
namespace {

using base::Dimension;

// Upper ends of ranges are there to catch slips (a metre for a millimetre), not to limit physics.
constexpr double kLongestLength = 1000;  // [mm]
constexpr double kLargestUnit = 1e6;     // [mm]

Range above_zero_to(double greatest) {
  return {.least = 0, .greatest = greatest, .least_excluded = true};
}

}  // namespace

std::vector<Parameter> parameters_of_file() {
  return {
      {.key = "fabric.yarns",
       .need = Need::optional,
       .from = FabricFrom::file,
       .value = "swatch.bcc",
       .help =
           "a file of yarn centrelines, .csv, .bcc or .yarns, in place of [loop] and of what stands above; its path "
           "begins at the folder of the case file",
       .slot = [](Case& c) -> Slot { return &c.fabric.yarns; }},
      {.key = "fabric.yarns_checksum",
       .need = Need::optional,
       .from = FabricFrom::file,
       .value = "cbf29ce484222325",
       .help = "of the content of that file; written into run folders, so that no run goes on with another file",
       .slot = [](Case& c) -> Slot { return &c.fabric.yarns_checksum; }},
      {.key = "fabric.file_unit",
       .dimension = Dimension::length,
       .need = Need::automatic,
       .from = FabricFrom::file,
       .value = 1.0,
       .range = above_zero_to(kLargestUnit),
       .help =
           "how long a length of 1 in the file is; auto takes the unit in the head of a table, .bcc and .yarns have "
           "none",
       .slot = [](Case& c) -> Slot { return &c.fabric.file_unit; }},
      {.key = "fabric.file_axes",
       .need = Need::defaulted,
       .from = FabricFrom::file,
       .value = "xyz",
       .choices = {"xyz", "yzx", "zxy", "xzy", "yxz", "zyx"},
       .help =
           "which axes of the file run along the courses, along the wales and out of plane; for the last three words "
           "the third axis is reversed, so that the fabric is turned and not mirrored",
       .slot = [](Case& c) -> Slot { return &c.fabric.file_axes; }},
      {.key = "fabric.element_length",
       .dimension = Dimension::length,
       .need = Need::automatic,
       .from = FabricFrom::file,
       .value = 0.5,
       .range = above_zero_to(kLongestLength),
       .help =
           "length of the beam elements along the yarn, nearly; auto takes a tenth of the yarn between a head and the "
           "next foot",
       .slot = [](Case& c) -> Slot { return &c.fabric.element_length; }},
      {.key = "fabric.grip_depth",
       .dimension = Dimension::length,
       .need = Need::automatic,
       .from = FabricFrom::file,
       .value = 0.3,
       .range = above_zero_to(kLongestLength),
       .help =
           "how far the grips reach over the fabric from its lowest and its highest centreline on; auto takes the yarn "
           "diameter, or half an element if that is more",
       .slot = [](Case& c) -> Slot { return &c.fabric.grip_depth; }},
  };
}

}  // namespace knitmech::model
