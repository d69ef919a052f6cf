#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace knitmech::serve {

/// The folder in which the page opens and saves cases. No path of a request leads out of it, neither by ".." nor by a
/// link; all paths are relative to it. JSON is as web/src/api/types.ts tells.
class Workspace {
 public:
  /// \param folder must be there. @throws FileError if it is not
  explicit Workspace(const std::filesystem::path& folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// The path of a file from the folder on; empty if it is not in it.
  [[nodiscard]] std::optional<std::string> relative(const std::filesystem::path& file) const;

  /// The cases in the folder and below, and the examples that the program brings along: `Cases`.
  [[nodiscard]] std::string cases_json() const;

  /// `CaseText`. @throws Refusal with 404 for a path that is no case file in the folder
  [[nodiscard]] std::string case_json(const std::string& path) const;
  [[nodiscard]] static std::string example_json(const std::string& name);
  [[nodiscard]] static std::string template_json();

  /// Writes a case file as a whole and returns its new stamp. \param stamp of the file that it takes the place of;
  /// empty: there is none
  /// @throws Refusal with 409, and changes nothing, if there is another file than the stamp is of
  /// @throws InputError for a name that cannot be
  [[nodiscard]] std::string save(const std::string& path, const std::string& text,
                                 const std::optional<std::string>& stamp) const;

 private:
  [[nodiscard]] std::filesystem::path inside(const std::string& path) const;

  std::filesystem::path folder_;
};

}  // namespace knitmech::serve
