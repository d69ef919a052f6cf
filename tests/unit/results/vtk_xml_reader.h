#pragma once

#include <map>
#include <string>
#include <vector>

namespace knitmech::test {

/// One DataArray of a VTK XML file, decoded. Integers are given as doubles.
struct VtkArray {
  std::string type;
  int components = 1;
  std::vector<double> values;
};

/// What a reader of VTK XML files finds in a .vtp file.
struct VtkFile {
  bool well_formed = false;                  ///< every tag closed in order, attributes quoted
  std::map<std::string, std::string> piece;  ///< attributes of <Piece>
  /// By "Parent/Name", for instance "PointData/gap_mm".
  std::map<std::string, VtkArray> arrays;
};

/// A small reader, written from the description of the format, independent of the writer.
VtkFile read_vtk_xml(const std::string& text);

/// Whether every tag of an XML text is closed in the right order and no attribute or text holds a bare < or &.
bool is_well_formed(const std::string& text);

}  // namespace knitmech::test
