#include "results/atomic_file.h"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

#include "base/errors.h"

namespace knitmech::results {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[nodiscard]] FileError file_error(const char* what, const std::filesystem::path& path, int code) {
  return FileError{fmt::format("{} \"{}\": {}.", what, path.string(), std::generic_category().message(code))};
}

/// Writes and closes; returns 0 or the error number of the first call that failed. A full disk often shows only when
/// the buffer is flushed, so flushing and closing count as well.
int write_and_close(File file, std::initializer_list<std::string_view> parts) {
  errno = 0;
  for (const std::string_view part : parts) {
    if (std::fwrite(part.data(), 1, part.size(), file.get()) != part.size()) {
      return errno != 0 ? errno : EIO;
    }
  }
  if (std::fflush(file.get()) != 0) {
    return errno;
  }
  return std::fclose(file.release()) == 0 ? 0 : errno;
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  write_file_atomically(path, {content});
}

void write_file_atomically(const std::filesystem::path& path, std::initializer_list<std::string_view> parts) {
  std::filesystem::path partial = path;
  partial += kPartialSuffix;
  File file{std::fopen(partial.c_str(), "wb")};
  if (file == nullptr) {
    throw file_error("Cannot write", path, errno);
  }
  const int code = write_and_close(std::move(file), parts);
  std::error_code ignored;
  if (code != 0) {
    std::filesystem::remove(partial, ignored);
    throw file_error("Cannot write", path, code);
  }
  std::error_code failed;
  std::filesystem::rename(partial, path, failed);
  if (failed) {
    std::filesystem::remove(partial, ignored);
    throw file_error("Cannot write", path, failed.value());
  }
}

std::string read_file(const std::filesystem::path& path) {
  const File file{std::fopen(path.c_str(), "rb")};
  if (file == nullptr) {
    throw file_error("Cannot read", path, errno);
  }
  std::string content;
  std::array<char, 65536> buffer{};
  std::size_t count = 0;
  while ((count = std::fread(buffer.data(), 1, buffer.size(), file.get())) > 0) {
    content.append(buffer.data(), count);
  }
  if (std::ferror(file.get()) != 0) {
    throw file_error("Cannot read", path, errno);
  }
  return content;
}

}  // namespace knitmech::results
