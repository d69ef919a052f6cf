#pragma once

#include <filesystem>
#include <string>

#include "picture/chart.h"

namespace knitmech::report {

/// Takes figures for a page [HTML], and leaves each as a file of its own in a folder. All throw FileError if the file
/// cannot be written.
class Figures {
 public:
  /// Makes the folder.
  explicit Figures(std::filesystem::path folder);

  /// A drawing, as name.svg.
  [[nodiscard]] std::string svg(const std::string& name, const std::string& svg, const std::string& caption) const;

  [[nodiscard]] std::string chart(const std::string& name, const picture::Chart& chart,
                                  const std::string& caption) const;

  /// The bytes of a PNG file, as name.png; empty bytes give a line that says so.
  [[nodiscard]] std::string png(const std::string& name, const std::string& bytes, const std::string& caption) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace knitmech::report
