#pragma once

#include <string>

#include "model/frame.h"
#include "model/model.h"
#include "results/vtk_xml.h"

namespace knitmech::results {

/// First line of contacts_0000.csv, ...; every name carries its unit.
inline constexpr const char* kContactHeader =
    "first_yarn,first_course,first_place_mm,second_yarn,second_course,second_place_mm,x_mm,y_mm,z_mm,"
    "normal_x,normal_y,normal_z,gap_mm,normal_force_N,friction_force_x_N,friction_force_y_N,friction_force_z_N,"
    "friction_force_magnitude_N,slip_mm,elastic_slip_mm,state,crossing_angle_deg";

/// Names of the files of a frame's contacts inside the folder frames/: contacts_0000.csv, and for ParaView
/// contacts_0000.vtp.
[[nodiscard]] std::string contact_table_file_name(int index);
[[nodiscard]] std::string contact_points_file_name(int index);

/// The contacts of a frame as a table: kContactHeader and a line per contact, in the order of Frame::contacts. Numbers
/// are as short as they can be and still read back to the same bits; the state is "stick" or "slip". docs/results.md
/// says what the columns mean.
///
/// Throws std::invalid_argument if a contact names a yarn that the model does not have; so does contact_points_text().
[[nodiscard]] std::string contact_table_text(const model::Model& model, const model::Frame& frame);

/// The same, line by line to a sink.
void write_contact_table(const model::Model& model, const model::Frame& frame, const TextSink& add);

/// The same as a ParaView .vtp file (vtk_xml.h): a point at the position of each contact, the columns of the table as
/// its fields. Vectors are one field each, and the state is the number `slips`: 1 slip, 0 stick.
[[nodiscard]] std::string contact_points_text(const model::Model& model, const model::Frame& frame);

/// The same, in pieces to a sink.
void write_contact_points(const model::Model& model, const model::Frame& frame, const TextSink& add);

}  // namespace knitmech::results
