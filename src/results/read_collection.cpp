#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/collection_file.h"
#include "results/frame_file.h"
#include "results/vtk_reader.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;

template <typename Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size() ? std::optional{value} : std::nullopt;
}

/// A frame from its line <DataSet timestep="0.022" ... file="frame_0001.vtp"/>.
std::optional<FrameEntry> frame_entry(std::string_view tag) {
  const std::optional<double> strain = number<double>(xml_attribute(tag, "timestep"));
  std::string_view digits = xml_attribute(tag, "file");
  const std::string_view name = digits;
  digits.remove_prefix(std::min(digits.find('_') + 1, digits.size()));
  digits = digits.substr(0, digits.find('.'));
  const std::optional<int> index = number<int>(digits);
  if (!strain || !std::isfinite(*strain) || !index || *index < 0 || frame_file_name(*index) != name) {
    return std::nullopt;
  }
  return FrameEntry{*index, *strain};
}

}  // namespace

std::vector<FrameEntry> read_frames_collection(const fs::path& path) {
  const std::string content = read_file(path);
  std::string_view text = content;
  const auto fail = [&path] {
    return InputError(fmt::format("{} is damaged, or not the list of frames that KnitMech wrote.", path.string()));
  };
  if (text.find("<VTKFile type=\"Collection\"") == std::string_view::npos || !text.ends_with("</VTKFile>\n")) {
    throw fail();
  }
  std::vector<FrameEntry> entries;
  constexpr std::string_view kStart = "<DataSet ";
  for (std::size_t at = text.find(kStart); at != std::string_view::npos; at = text.find(kStart)) {
    text.remove_prefix(at);
    const std::optional<FrameEntry> entry = frame_entry(text.substr(0, text.find('>')));
    if (!entry || (!entries.empty() && entry->index <= entries.back().index)) throw fail();
    entries.push_back(*entry);
    text.remove_prefix(kStart.size());
  }
  return entries;
}

}  // namespace knitmech::results
