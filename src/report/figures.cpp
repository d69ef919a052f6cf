#include "report/figures.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "base/errors.h"
#include "report/page.h"
#include "results/atomic_file.h"

namespace knitmech::report {

Figures::Figures(std::filesystem::path folder) : folder_(std::move(folder)) {
  try {
    std::filesystem::create_directories(folder_);
  } catch (const std::filesystem::filesystem_error& error) {
    throw FileError(fmt::format("cannot write the folder {}: {}", folder_.string(), error.code().message()));
  }
}

std::string Figures::svg(const std::string& name, const std::string& svg, const std::string& caption) const {
  results::write_file_atomically(folder_ / (name + ".svg"), svg);
  const auto begin = svg.find("<svg");  // after what only a file of its own begins with
  return figure(svg.substr(begin == std::string::npos ? 0 : begin), caption);
}

std::string Figures::chart(const std::string& name, const picture::Chart& chart, const std::string& caption) const {
  return svg(name, picture::chart_svg(chart), caption);
}

std::string Figures::png(const std::string& name, const std::string& bytes, const std::string& caption) const {
  if (bytes.empty()) return figure("", caption + ": nothing can be drawn");
  results::write_file_atomically(folder_ / (name + ".png"), bytes);
  return figure(inline_png(bytes, caption), caption);
}

}  // namespace knitmech::report
