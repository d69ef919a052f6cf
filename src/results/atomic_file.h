#pragma once

#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

namespace knitmech::results {

/// Ending of the name under which a file is written before it is renamed to its own name.
inline constexpr std::string_view kPartialSuffix = ".partial";

/// A file that is written piece by piece so that a reader finds either the old content or the whole new one.
///
/// The pieces go to `<path>.partial` in the same folder, which finish() renames to `path`; the partial file is removed
/// when anything fails, and when the object goes without finish(). The folder must exist. Safe against a killed
/// program, not against a power cut.
///
/// All members throw FileError with the path and the reason of the system (disk full, folder not writable, ...).
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;

  void write(std::string_view piece);
  void finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const;
  };
  [[noreturn]] void fail(int code);

  std::filesystem::path path_, partial_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// Writes a whole file at once, as AtomicFile does. Throws FileError.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for a content in several parts, which follow each other.
void write_file_atomically(const std::filesystem::path& path, std::initializer_list<std::string_view> parts);

/// The whole content of a file. Throws FileError with the path and the reason.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace knitmech::results
