#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace knitmech::exchange {

/// One data line of a deck, cut at its commas; blanks around an entry are gone, an empty entry is empty.
struct DataLine {
  int line = 0;
  std::vector<std::string> entries;

  [[nodiscard]] bool is_blank() const;
  /// Entry i, empty if the line ends before it.
  [[nodiscard]] std::string entry(std::size_t i) const;
};

/// A keyword of a deck with its options and data lines.
///
/// Keyword and option names are in capitals without blanks (BEAMSECTION), for Abaqus ignores case and blanks there.
/// Values are in capitals with blanks around them removed, unless in quotes. An option without a value has an empty
/// one.
struct KeywordBlock {
  std::string keyword;
  std::string as_written;  ///< keyword as it stands in the deck, for messages
  int line = 0;
  std::map<std::string, std::string> options;
  std::vector<DataLine> data;
  std::vector<std::string> text;  ///< the data lines as they stand

  [[nodiscard]] bool has(std::string_view option) const;
  /// Value of an option, or the fallback if it is absent.
  [[nodiscard]] std::string option(std::string_view name, std::string_view fallback = "") const;
};

/// Cuts a deck into keywords. Comment lines (**) are passed over wherever they are; a keyword line that ends with a
/// comma goes on in the next line. Throws InputError, with `source` and line, for data before the first keyword, a line
/// of more than 256 characters, a keyword without a name or a file without any keyword.
[[nodiscard]] std::vector<KeywordBlock> read_keyword_blocks(std::istream& in, const std::string& source);

/// Throws InputError "source, line n: message".
[[noreturn]] void fail_at(const std::string& source, int line, const std::string& message);

/// The entry as a real number; Abaqus' D exponent counts as E, an empty entry is 0. Throws InputError if it is none, is
/// not finite or is longer than 20 characters.
[[nodiscard]] double real_number(const std::string& source, int line, const std::string& entry);

/// The entry as an integer. Throws InputError if it is none.
[[nodiscard]] int integer(const std::string& source, int line, const std::string& entry);

/// True if the entry begins like a number and so is none of a set or material.
[[nodiscard]] bool looks_like_number(const std::string& entry);

}  // namespace knitmech::exchange
