#pragma once

#include <string>

#include "exchange/tube_mesh.h"

namespace knitmech::exchange {

/// Yarns as tubes in the formats of other programs. x along the course, y up the wales, z towards the viewer:
/// right-handed, y up. Each throws InputError for files beyond kMostFileBytes, STEP for more than kMostSolidSections,
/// before or while it makes them.

/// Binary STL (3D Systems, "StereoLithography Interface Specification", 1988): 80 bytes of text, the number of
/// triangles, and of each its normal and corners as 32-bit numbers. Lengths are in mm, which the text says and readers
/// cannot see; yarns are not told apart.
[[nodiscard]] std::string stl_bytes(const YarnTubes& tubes);

/// Wavefront OBJ ("Object Files (.obj)", Wavefront Advanced Visualizer, appendix B1) in mm: an object "yarn_1",
/// "yarn_2", ... of each yarn with points (v), normals (vn) and triangles (f). The points of a tube are shared by wall
/// and ends, the normals are not.
[[nodiscard]] std::string obj_text(const YarnTubes& tubes);

/// Binary glTF 2.0 (Khronos, ISO/IEC 12113:2022): a node "fabric" that scales mm to the metres of the format, below it
/// a node and mesh "yarn 1", "yarn 2", ... of each yarn, one material. Indices have 16 bits where a tube has room in
/// them. The title is the scene's name and in its extras.
[[nodiscard]] std::string glb_bytes(const YarnTubes& tubes);

/// STEP AP214 (ISO 10303-21 and -214) in mm: a part of the name of the title with a closed solid "yarn 1", "yarn 2",
/// ... of each yarn (tube_solid()). Sections are circles, whatever `sides` says. The text has no date: the same yarns
/// give the same bytes.
[[nodiscard]] std::string step_text(const YarnTubes& tubes);

}  // namespace knitmech::exchange
