#include "results/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/errors.h"
#include "sample_run.h"

namespace knitmech::results {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(AtomicFile, KeepsEveryByteAndLeavesNoPartialFile) {
  // Given content with all byte values.
  const test::TemporaryFolder folder;
  std::string content;
  for (int i = 0; i < 100000; ++i) {
    content += static_cast<char>(i % 256);
  }
  // When it is written over an older file.
  test::write_text(folder.path() / "file", "older");
  write_file_atomically(folder.path() / "file", content);
  // Then it reads back, and nothing else is in the folder.
  EXPECT_EQ(read_file(folder.path() / "file"), content);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "file.partial"));
}

TEST(AtomicFile, FullDiskIsAFileErrorAndTheOldFileStays) {
  // Given that what is written ends on a full device: Linux's /dev/full refuses every byte with "no space left".
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "file", "older");
  std::filesystem::create_symlink("/dev/full", folder.path() / "file.partial");
  // When, then
  EXPECT_THAT(
      [&] { write_file_atomically(folder.path() / "file", "newer"); },
      ThrowsMessage<FileError>(AllOf(HasSubstr((folder.path() / "file").string()), HasSubstr("No space left"))));
  EXPECT_EQ(read_file(folder.path() / "file"), "older");
}

TEST(AtomicFile, MissingFolderIsAFileErrorThatNamesThePath) {
  EXPECT_THAT([] { write_file_atomically("/no/such/folder/file", "x"); },
              ThrowsMessage<FileError>(AllOf(HasSubstr("/no/such/folder/file"), HasSubstr("No such file"))));
  EXPECT_THAT([] { static_cast<void>(read_file("/no/such/folder/file")); },
              ThrowsMessage<FileError>(AllOf(HasSubstr("/no/such/folder/file"), HasSubstr("No such file"))));
}

}  // namespace
}  // namespace knitmech::results
