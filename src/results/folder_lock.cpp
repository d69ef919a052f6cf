#include "results/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/errors.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;

int opened(const fs::path& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : folder_(opened(folder)) {
  if (folder_ < 0) {
    const std::error_code code(errno, std::generic_category());
    throw FileError(fmt::format("Cannot open the run folder \"{}\": {}.", folder.string(), code.message()));
  }
  if (flock(folder_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(folder_);
    throw InputError(
        fmt::format("\"{}\" is the folder of a run under way; give another one, or wait for it.", folder.string()));
  }
}

FolderLock::~FolderLock() {
  close(folder_);
}

bool may_be_written(const fs::path& folder) {
  const int descriptor = opened(folder);
  if (descriptor < 0) return true;
  const bool is_free = flock(descriptor, LOCK_SH | LOCK_NB) == 0;
  close(descriptor);
  return !is_free;
}

}  // namespace knitmech::results
