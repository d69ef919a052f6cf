#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace knitmech::results {

/// A reader of exactly the files that vtk_xml.h writes: PolyData of one piece, numbers as inline blocks of zlib in
/// base64. Nothing in a file is trusted: whatever does not fit, down to the size of each block, is an error, and no
/// more memory is taken than the numbers that the caller expects need.
///
/// All members throw InputError with the name of the file if it is not such a file, was cut off or is damaged.
class VtkReader {
 public:
  /// \param text of the whole file
  VtkReader(std::filesystem::path path, std::string text);

  [[nodiscard]] std::size_t n_points() const { return n_points_; }
  [[nodiscard]] std::size_t n_lines() const { return n_lines_; }

  /// The numbers of an array, which must be `count`, components of all tuples together.
  /// \param section element that holds the array: "FieldData", "Points", "Lines", "PointData", "CellData"
  [[nodiscard]] std::vector<double> numbers(std::string_view section, std::string_view name, std::size_t count) const;
  [[nodiscard]] std::vector<std::int64_t> integers(std::string_view section, std::string_view name,
                                                   std::size_t count) const;

  /// Throws InputError: "<file> <complaint>."
  [[noreturn]] void fail(std::string_view complaint) const;

 private:
  [[nodiscard]] std::string_view section_text(std::string_view section) const;
  template <typename Number>
  [[nodiscard]] std::vector<Number> values(std::string_view section, std::string_view name, std::size_t count) const;

  std::filesystem::path path_;
  std::string text_;
  std::size_t n_points_ = 0, n_lines_ = 0;
};

/// The value of an attribute in the text of a tag, name="value"; empty if it has none of that name.
[[nodiscard]] std::string_view xml_attribute(std::string_view tag, std::string_view name);

}  // namespace knitmech::results
