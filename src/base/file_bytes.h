#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace knitmech::base {

/// The content of a file of a user, which may be anything, also a file without an end.
///
/// @param largest [bytes] @param advice what to do about a larger file, for the message
/// @throws FileError if it cannot be read or is a folder
/// @throws InputError if it is larger
[[nodiscard]] std::string file_bytes(const std::string& path, std::size_t largest, std::string_view advice);

}  // namespace knitmech::base
