#pragma once

#include <filesystem>

namespace knitmech::results {

/// Held by a run as long as it writes its folder, so that no other run takes the folder and that a run whose program
/// was killed can be told from one under way. It is a lock on the folder itself [flock(2)], which leaves no file and
/// goes with the process.
///
/// A file system that knows no such locks gives none: then nothing is held, and nothing is refused.
class FolderLock {
 public:
  /// @throws InputError if another run holds it, in this program or another; FileError if the folder cannot be opened
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_;  ///< file descriptor
};

/// Whether a run writes a folder, or may do so where that cannot be told.
[[nodiscard]] bool may_be_written(const std::filesystem::path& folder);

}  // namespace knitmech::results
