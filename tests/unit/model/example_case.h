#pragma once

#include "model/case.h"

namespace knitmech::model {

/// The case of examples/02-wale-tension with p = 0.02 /mm: 9 wales x 15 courses of a monofilament of 0.12 mm.
inline Case example_case(int elements_per_erc = 10) {
  Case input;
  input.title = "Example";
  input.loop = {.height = 7.0,
                .width = 3.9,
                .head_flat = 0.2,
                .head_radius = 1.1,
                .foot_flat = 0.2,
                .foot_radius = 1.0,
                .out_of_plane = 0.02};
  input.fabric.wales = 9;
  input.fabric.courses = 15;
  input.fabric.course_spacing = 5.0;
  input.fabric.elements_per_erc = elements_per_erc;
  input.yarn.diameter = 0.12;
  input.yarn.density = 1.14e-9;
  input.yarn.youngs_modulus = 1700;
  input.yarn.poissons_ratio = 0.39;
  input.contact.friction = 0.1;
  input.test.strain = 0.22;
  input.test.speed = 5;
  input.test.ramp = 0.5;
  return input;
}

}  // namespace knitmech::model
