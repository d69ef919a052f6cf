#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/errors.h"

namespace knitmech::model {

/// A TOML value that no parameter can have; type says in words what it is, "a date".
struct TomlOther {
  std::string type;
};

/// An item of a list.
using TomlItem = std::variant<TomlOther, std::string, std::int64_t, double>;

/// The head of a section, [loop].
struct TomlSection {};

using TomlValue = std::variant<TomlOther, std::string, std::int64_t, double, std::vector<TomlItem>, TomlSection>;

/// One line of meaning in a TOML file.
struct TomlEntry {
  std::string key;  ///< "loop.height", of a section "loop"
  int line = 0;     ///< counted from 1
  TomlValue value;
  std::size_t begin = 0, end = 0;  ///< place of the value in the text [bytes], the end excluded; of a section 0
};

/// A text that is not TOML: what is wrong and in which line (0: not known).
class TomlSyntaxError : public InputError {
 public:
  TomlSyntaxError(int line, const std::string& what) : InputError(what), line_(line) {}
  [[nodiscard]] int line() const { return line_; }

 private:
  int line_;
};

/// The sections and values of a TOML text in the order of its lines.
///
/// Sections are as deep as is asked for; a section deeper than that is a TomlOther. A part of a key that itself holds a
/// dot is in quotes.
/// @throws TomlSyntaxError also for lines longer than 10000 letters, which could nest deeper than the stack reaches
[[nodiscard]] std::vector<TomlEntry> toml_entries(std::string_view text, int depth = 1);

}  // namespace knitmech::model
