#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace knitmech::results {

/// Ending of the name under which a file is written before it is renamed to its own name.
inline constexpr std::string_view kPartialSuffix = ".partial";

/// Writes a whole file so that a reader finds either the old content or the new one, never a part of it.
///
/// The content goes to `<path>.partial` in the same folder, which is then renamed to `path`; the partial file is
/// removed when anything fails. The folder must exist. Safe against a killed program, not against a power cut.
///
/// Throws FileError with the path and the reason of the system (disk full, folder not writable, ...).
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for a content in several parts, which follow each other.
void write_file_atomically(const std::filesystem::path& path, std::initializer_list<std::string_view> parts);

/// The whole content of a file. Throws FileError with the path and the reason.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace knitmech::results
