#pragma once

#include <charconv>
#include <filesystem>
#include <string_view>
#include <vector>

namespace knitmech::results {

/// Where a reader of one of our tables is, for its messages.
struct CsvPlace {
  const std::filesystem::path& path;
  int line = 0;  ///< counted from 1
};

/// The lines of a table, without line ends (LF or CRLF) and without empty lines at the end. They are parts of content.
[[nodiscard]] std::vector<std::string_view> csv_lines(std::string_view content);

/// The cells of a line, which commas separate.
[[nodiscard]] std::vector<std::string_view> csv_cells(std::string_view line);

/// Throws InputError: a cell does not hold what is expected there, for instance "a number".
[[noreturn]] void throw_wrong_cell(std::string_view cell, std::string_view column, const CsvPlace& place,
                                   std::string_view expected);

/// A number that is the whole of a cell. Throws InputError with file, line and column otherwise.
template <typename Number>
[[nodiscard]] Number parse_number(std::string_view text, std::string_view column, const CsvPlace& place) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) {
    throw_wrong_cell(text, column, place, "a number");
  }
  return value;
}

}  // namespace knitmech::results
