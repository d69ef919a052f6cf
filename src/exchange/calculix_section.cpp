#include "exchange/calculix_section.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "exchange/abaqus_section.h"

namespace knitmech::exchange {

CalculixSquare calculix_square(const yarn::Section& section) {
  CalculixSquare square;
  square.side = std::sqrt(12 * section.bending_stiffness / section.axial_stiffness);
  const double area = square.side * square.side;
  square.youngs_modulus = section.axial_stiffness / area;
  square.shear_modulus = 6 * section.torsional_stiffness / (area * area);
  return square;
}

CalculixMaterial calculix_material(const yarn::Section& section) {
  const AbaqusSection circle = abaqus_section(section);
  if (circle.circle) return {circle.youngs_modulus, circle.poissons_ratio};
  throw InputError(
      fmt::format("calculix-solids: EA = {:.4g} N, EI = {:.4g} N mm^2 and GJ = {:.4g} N mm^2 of the yarn "
                  "are not those of a solid circle of {:.4g} mm, which is all that a solid can have. "
                  "Export a monofilament, or take -f abaqus",
                  section.axial_stiffness, section.bending_stiffness, section.torsional_stiffness, section.diameter));
}

}  // namespace knitmech::exchange
