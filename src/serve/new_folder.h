#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace knitmech::serve {

/// A name as a folder may have it on any system: letters, digits, "-", "_" and "."; spaces become "-", all else is left
/// out, and so are points at its begin. At most kLongestName bytes; "run" if nothing is left.
[[nodiscard]] std::string folder_name(std::string_view name);

/// Makes a folder for a run under a root, which is made as well: called name, or name-2, name-3, ... if that is taken.
/// No two calls, of any programs, give the same folder. Throws FileError.
[[nodiscard]] std::filesystem::path make_new_folder(const std::filesystem::path& root, const std::string& name);

}  // namespace knitmech::serve
