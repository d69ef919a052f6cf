#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "curves/nearest_yarns.h"
#include "knit/clearance.h"
#include "knit/erc.h"
#include "model/case.h"
#include "model/model.h"
#include "yarn/section.h"

namespace knitmech::model {

/// What there is to know besides about a fabric from a file of yarns.
struct FileFacts {
  std::size_t n_points = 0;                     ///< control points of the file
  double half_stitch = 0;                       ///< [mm], Model::half_stitch_length
  double element_length = 0;                    ///< [mm], mean
  double diameter_in_file = 0;                  ///< [mm], twice the radius of the first yarn; 0: the file does not say
  double grip_depth = 0;                        ///< [mm], along y
  std::size_t n_bottom = 0, n_top = 0;          ///< nodes in the two grips
  std::optional<curves::NearestYarns> closest;  ///< empty: none nearer than kGapReach diameters
};

/// What there is to know about a case before it is run.
struct FabricFacts {
  std::optional<FileFacts> file;        ///< of a fabric from a file; what is told of loops is then left at zero
  knit::Erc erc;                        ///< control points, theta1, theta2, length of the ERC
  bool automatic_out_of_plane = false;  ///< whether the program chose p
  double out_of_plane = 0;              ///< p in use [1/mm]
  double least_out_of_plane = 0;        ///< [1/mm], the least p without overlap, of the curve and of the elements
  double stitch_length = 0;             ///< [mm], yarn in one stitch: two ERCs, or two half stitches of a file
  double yarn_length = 0;               ///< [mm], yarn in the whole fabric, turning arcs included
  int n_elements = 0;
  int n_nodes = 0;
  int n_degrees_of_freedom = 0;                       ///< six per node
  std::optional<knit::Approach> closest_on_curve;     ///< least gap of the true centreline; empty if nothing faces
  std::optional<knit::Approach> closest_on_elements;  ///< the same of the straight elements
  double width = 0;      ///< [mm], W L: the wales side by side; of a file the centrelines along x
  double height = 0;     ///< [mm], (C - 1) T + H: lowest foot to highest head, of the centreline
  double thickness = 0;  ///< [mm], depth of the loops (centrelines along z) plus one yarn diameter
  double mass_per_area =
      0;                   ///< [g/m^2], yarn of one stitch over its area L T; of a file all yarn over width and height
  yarn::Section section;   ///< EA, EI, GJ and mass of the yarn
  int n_ties = 0;          ///< tied: crossings that are tied
  int n_turning_arcs = 0;  ///< adjusted: arcs that join two courses
  double turning_arc_length = 0;              ///< [mm], of one of them
  std::optional<yarn::Section> edge_section;  ///< adjusted: EA, EI, GJ and mass of the arcs
};

/// "9 wales x 15 courses", or "15 yarns from a file".
[[nodiscard]] std::string fabric_text(const Case& input);

/// The facts of a case and of the model that build_model() made of it. Throws InputError like build_model().
[[nodiscard]] FabricFacts describe(const Case& input, const Model& model);

}  // namespace knitmech::model
