#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.h"
#include "model/case.h"

namespace knitmech::model {

/// A mistake in a case file; the message says all of it, the members say where it is once more for programs.
class CaseFileError : public InputError {
 public:
  CaseFileError(std::string file, int line, std::string key, const std::string& complaint);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& complaint() const { return complaint_; }  ///< without file, line and key
  [[nodiscard]] int line() const { return line_; }               ///< counted from 1; 0: the mistake is in no line
  [[nodiscard]] const std::string& key() const { return key_; }  ///< "loop.height"; empty: it belongs to no key

 private:
  std::string file_;
  int line_;
  std::string key_;
  std::string complaint_;
};

/// A case file [TOML], with all defaults filled in and every value checked by itself and against the others.
///
/// The geometry is not built here: circles that admit no leg and the like are for build_model() to find.
/// @throws CaseFileError for the first mistake in the order of the lines, then for what is missing
/// @throws FileError if there is no such file or it cannot be read
[[nodiscard]] Case read_case_file(const std::filesystem::path& path);

/// The text of a case file. @throws FileError like read_case_file()
/// @throws CaseFileError if it is too large, or no text at all
[[nodiscard]] std::string case_file_text(const std::filesystem::path& path);

/// The same from the text of a case file. @param file its name, for messages @param folder where a file of yarns is
/// looked for; none: a case that names one is refused
/// @throws FileError if that file cannot be read
[[nodiscard]] Case parse_case(std::string_view text, const std::string& file,
                              const std::optional<std::filesystem::path>& folder = std::nullopt);

/// All mistakes in the text of a case file that can be told side by side: those of single lines in their order, then
/// what is missing; only without these the first rule between parameters that is broken. Empty: parse_case() reads it,
/// without a folder.
[[nodiscard]] std::vector<CaseFileError> mistakes_in(std::string_view text, const std::string& file);

/// The text of a complete case file: every parameter that has a value, with its meaning. parse_case() of it gives a
/// case with the same bits; where the fabric comes from a file of yarns, that must stand beside it under the name
/// curves::plain_name().
[[nodiscard]] std::string write_case(const Case& input);

/// The line in which a case file gives a key or, failing that, opens its section; 0 if it does neither.
[[nodiscard]] int line_of_key(std::string_view text, std::string_view key);

}  // namespace knitmech::model
