#pragma once

#include <string>
#include <vector>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::results {

/// Name of the file of a frame inside the folder frames/: frame_0000.vtp, frame_0001.vtp, ...
[[nodiscard]] std::string frame_file_name(int index);

/// A frame as a ParaView .vtp file (VTK XML PolyData): one polyline per yarn, fields at its nodes.
///
/// A polyline per yarn is what ParaView's Tube filter turns into smooth yarns coloured by point data, so element
/// quantities are given at the nodes (average_to_nodes()); their exact values, one per element, are in the field data
/// under the same name with the prefix "element_". All numbers are stored bit by bit (64 bit, base64), and the file is
/// plain well-formed XML. docs/results.md lists the arrays.
///
/// A gap of +infinity (no other yarn near) is written as NaN, which ParaView leaves out of the colour range.
///
/// frame must have an entry per node of the model in every vector; throws std::invalid_argument otherwise.
[[nodiscard]] std::string frame_text(const model::Model& model, const model::Frame& frame);

/// A frame of the collection file.
struct FrameEntry {
  int index = 0;
  double strain = 0;  ///< [-]
};

/// ParaView's collection file frames.pvd, which lists the frames with their strain [-] in the place of the time.
[[nodiscard]] std::string collection_text(const std::vector<FrameEntry>& entries);

}  // namespace knitmech::results
