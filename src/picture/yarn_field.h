#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::picture {

/// What the colour of the yarns tells.
enum class ColourBy {
  plain,           ///< nothing; the edge yarn is told from the yarn
  course,          ///< neighbouring courses in different colours
  contact_force,   ///< magnitude of the contact force at the node [N]
  curvature,       ///< change of curvature since the stress-free shape [1/mm]
  axial_force,     ///< [N]
  axial_strain,    ///< [%]
  shear_force,     ///< magnitude [N]
  bending_moment,  ///< magnitude [N mm]
  torque,          ///< [N mm]
  out_of_plane     ///< position along z [mm]
};

/// What the quantity of a colouring is called, and its unit: "Axial force" and "N". Both empty for plain and course.
struct FieldName {
  const char* name;
  const char* unit;
};
[[nodiscard]] FieldName field_name(ColourBy colour_by);

/// A quantity at the nodes, ready to be shown in colours.
struct YarnField {
  std::string label;           ///< with unit, as in "Axial force [N]"
  std::vector<double> values;  ///< one per node; element quantities are averaged to the nodes
  double lowest = 0;           ///< ends of the colour bar
  double highest = 1;
};

/// Lowest and highest of the values of one or several fields; not a range as long as there is no finite value.
struct ValueRange {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(const YarnField& field);
};

/// The ends of a colour bar for values: magnitudes from zero, widened to round numbers.
[[nodiscard]] std::pair<double, double> round_range(ColourBy colour_by, const ValueRange& values);

/// The field behind a colouring; empty for plain and course. Without a given range the colours span the finite values
/// (magnitudes from zero), widened to round numbers.
[[nodiscard]] std::optional<YarnField> yarn_field(ColourBy colour_by, const model::Model& model,
                                                  const model::Frame& frame,
                                                  const std::optional<std::pair<double, double>>& range);

}  // namespace knitmech::picture
