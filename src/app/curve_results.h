#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace knitmech::app {

/// Makes the folder for results that come from files of curves, and sees to it that none of these is overwritten.
///
/// Throws InputError if a result of one of these names would take the place of a file that is read, and FileError if
/// the folder cannot be made.
void make_curve_folder(const std::filesystem::path& folder, const std::vector<const char*>& names,
                       const std::vector<std::string>& files_read);

}  // namespace knitmech::app
