#pragma once

#include <string>
#include <vector>

#include "model/frame.h"
#include "model/model.h"
#include "picture/yarn_field.h"

namespace knitmech::report {

/// A coloured picture of each of some frames, all with the same range of colours.
struct PictureRow {
  std::string name;              ///< of the colouring, as part of a file name: "contact-force"
  std::string title;             ///< "Contact force"
  std::vector<std::string> png;  ///< bytes of a PNG file for each frame; empty where no yarn can be drawn
};

/// What a report shows of each frame: contact force, curvature, axial force, position out of plane.
/// \param height of a picture [px] \param threads that draw; 0: as many as the processor has
[[nodiscard]] std::vector<PictureRow> draw_rows(const model::Model& model, const std::vector<model::Frame>& frames,
                                                int height, int threads);

/// The frame coloured by contact force alone, within its own range.
[[nodiscard]] std::string draw_contact(const model::Model& model, const model::Frame& frame, int height, int threads);

}  // namespace knitmech::report
