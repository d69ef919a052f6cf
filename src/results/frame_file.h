#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/frame.h"
#include "model/model.h"
#include "results/vtk_xml.h"

namespace knitmech::results {

/// Name of the file of a frame inside the folder frames/: frame_0000.vtp, frame_0001.vtp, ...
[[nodiscard]] std::string frame_file_name(int index);

/// A quantity of the elements: its name in the file, where frames have it.
struct ElementField {
  const char* name;
  std::vector<double> model::Frame::*values;
};
inline constexpr std::array<ElementField, 9> kElementFields = {{{"axial_force_N", &model::Frame::axial_force},
                                                                {"shear_force_N", &model::Frame::shear_force},
                                                                {"bending_moment_Nmm", &model::Frame::bending_moment},
                                                                {"torque_Nmm", &model::Frame::torque},
                                                                {"axial_strain", &model::Frame::axial_strain},
                                                                {"curvature_per_mm", &model::Frame::curvature},
                                                                {"stretch_energy_mJ", &model::Frame::stretch_energy},
                                                                {"bending_energy_mJ", &model::Frame::bending_energy},
                                                                {"twist_energy_mJ", &model::Frame::twist_energy}}};

/// Before the name of a field of kElementFields where its values are given per element, not at the nodes.
inline constexpr const char* kElementPrefix = "element_";

/// Gives a frame as a ParaView .vtp file to a sink, in pieces (vtk_xml.h): one polyline per yarn, fields at its nodes.
/// A yarn that has broken is as many polylines as it has pieces; the nodes of a piece of one node belong to none.
///
/// A polyline per yarn is what ParaView's Tube filter turns into smooth yarns coloured by point data, so element
/// quantities are given at the nodes (average_to_nodes()); their exact values, one per element, are in the field data
/// under the same name with the prefix "element_". docs/results.md lists the arrays.
///
/// A gap of +infinity (no other yarn near) is written as NaN, which ParaView leaves out of the colour range.
///
/// frame must have an entry per node of the model in every vector; throws std::invalid_argument otherwise. Its contacts
/// are in files of their own (contact_file.h).
void write_frame(const model::Model& model, const model::Frame& frame, const TextSink& add);

/// The same as one text.
[[nodiscard]] std::string frame_text(const model::Model& model, const model::Frame& frame);

}  // namespace knitmech::results
