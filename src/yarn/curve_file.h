#pragma once

#include <string>

namespace knitmech::yarn {

/// The content of a file of curves, which may be anything, also a file without an end.
///
/// Throws FileError if it cannot be read or is a folder, and InputError if it is larger than 100 MB, which is some
/// hundred hours of a testing machine.
[[nodiscard]] std::string curve_file_bytes(const std::string& path);

}  // namespace knitmech::yarn
