#pragma once

#include <filesystem>
#include <string>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::test {

/// A folder under the system's temporary folder that is removed at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void write_text(const std::filesystem::path& path, const std::string& text);

/// Two yarns of 3 and 4 nodes with diameters 0.12 mm and 0.2 mm.
model::Model two_yarn_model();

/// A frame of that model in which every number is different and most have no short decimal form. It has three contacts:
/// of yarns 0 and 1, of yarn 0 with itself, which slips, and of yarn 1 with itself.
model::Frame awkward_frame(const model::Model& model, int index);

}  // namespace knitmech::test
