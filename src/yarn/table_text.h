#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knitmech::yarn {

/// The text of an exported table as UTF-8: without byte order mark, and turned from Latin-1 where it is no valid UTF-8.
///
/// Throws InputError, without the file, for a text that is empty, binary (it has a zero byte) or UTF-16.
[[nodiscard]] std::string table_text(std::string_view bytes);

/// The lines of a text; they end in LF, CR LF or CR.
[[nodiscard]] std::vector<std::string_view> lines_of(std::string_view text);

/// The cells of a line, without surrounding spaces and double quotes. A separator between double quotes separates
/// nothing.
///
/// @param cells is overwritten; the cells are views into the line
void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Without spaces (also the no-break space) and tabs at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Reads the numbers of one table, whose decimal mark is a point or a comma, the same everywhere.
class NumberReader {
 public:
  /// The number of a cell. Throws InputError, without the place, for a text that is not one finite number, for
  /// thousands separators, and for a comma in a table with decimal points or the other way round.
  [[nodiscard]] double number(std::string_view cell);

 private:
  std::optional<char> decimal_mark_;  ///< once one was seen
};

/// Whether a text begins as a number does; it may be a wrong one.
[[nodiscard]] bool looks_like_number(std::string_view cell);

}  // namespace knitmech::yarn
