#include "results/atomic_file.h"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

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

}  // namespace

void AtomicFile::Close::operator()(std::FILE* file) const {
  static_cast<void>(std::fclose(file));
}

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), partial_(path_) {
  partial_ += kPartialSuffix;
  file_.reset(std::fopen(partial_.c_str(), "wb"));
  if (file_ == nullptr) throw file_error("Cannot write", path_, errno);
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void AtomicFile::fail(int code) {
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
  throw file_error("Cannot write", path_, code);
}

void AtomicFile::write(std::string_view piece) {
  errno = 0;
  if (std::fwrite(piece.data(), 1, piece.size(), file_.get()) != piece.size()) fail(errno != 0 ? errno : EIO);
}

/// A full disk often shows only when the buffer is flushed, so flushing and closing count as well.
void AtomicFile::finish() {
  if (std::fflush(file_.get()) != 0) fail(errno);
  if (std::fclose(file_.release()) != 0) fail(errno);
  std::error_code failed;
  std::filesystem::rename(partial_, path_, failed);
  if (failed) fail(failed.value());
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  write_file_atomically(path, {content});
}

void write_file_atomically(const std::filesystem::path& path, std::initializer_list<std::string_view> parts) {
  AtomicFile file(path);
  for (const std::string_view part : parts) file.write(part);
  file.finish();
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
