#include "results/vtk_reader.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "base/errors.h"
#include "results/base64.h"

namespace knitmech::results {
namespace {

/// Numbers in front of the compressed sizes: number of blocks, size of all but the last, size of the last or 0.
constexpr std::size_t kHeadNumbers = 3;

/// Characters of base64 for a number of bytes.
std::size_t base64_size(std::size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

std::optional<std::vector<std::uint64_t>> decoded_head(std::string_view text) {
  const std::optional<std::vector<std::byte>> bytes = from_base64(text);
  if (!bytes || bytes->size() % sizeof(std::uint64_t) != 0) return std::nullopt;
  std::vector<std::uint64_t> head(bytes->size() / sizeof(std::uint64_t));
  if (!head.empty()) std::memcpy(head.data(), bytes->data(), bytes->size());
  return head;
}

/// Splits the head from the blocks: the number of blocks, which says how long the head is, comes first in it.
struct Blocks {
  std::vector<std::uint64_t> head;
  std::vector<std::byte> compressed;
};
std::optional<Blocks> decoded(std::string_view text) {
  const std::size_t shortest = base64_size(kHeadNumbers * sizeof(std::uint64_t));
  const std::optional<std::vector<std::uint64_t>> start = decoded_head(text.substr(0, shortest));
  // Every block takes eight bytes of the head at least, so that a larger number of them is not true.
  if (!start || start->size() != kHeadNumbers || start->front() > text.size() / sizeof(std::uint64_t)) {
    return std::nullopt;
  }
  const std::size_t head_size = base64_size((kHeadNumbers + start->front()) * sizeof(std::uint64_t));
  if (head_size > text.size()) return std::nullopt;
  std::optional<std::vector<std::uint64_t>> head = decoded_head(text.substr(0, head_size));
  std::optional<std::vector<std::byte>> compressed = from_base64(text.substr(head_size));
  if (!head || head->size() != kHeadNumbers + start->front() || !compressed) return std::nullopt;
  return Blocks{std::move(*head), std::move(*compressed)};
}

/// Fills all bytes from the blocks. \return whether they are exactly what the blocks hold
bool decompress(const Blocks& blocks, std::span<std::byte> bytes) {
  const std::uint64_t block_size = blocks.head[1];
  const std::size_t n_blocks = blocks.head.size() - kHeadNumbers;
  if (n_blocks == 0) return bytes.empty();
  if (block_size == 0 || (bytes.size() - 1) / block_size + 1 != n_blocks || bytes.empty() ||
      bytes.size() % block_size != blocks.head[2]) {
    return false;
  }
  std::size_t from = 0;
  for (std::size_t i = 0; i < n_blocks; ++i) {
    const std::uint64_t size = blocks.head[kHeadNumbers + i];
    if (size > blocks.compressed.size() - from) return false;
    const std::span<std::byte> block =
        bytes.subspan(i * block_size, std::min(block_size, bytes.size() - i * block_size));
    uLongf filled = block.size();
    const int code = uncompress(reinterpret_cast<Bytef*>(block.data()), &filled,
                                reinterpret_cast<const Bytef*>(blocks.compressed.data() + from), size);
    if (code != Z_OK || filled != block.size()) return false;
    from += size;
  }
  return from == blocks.compressed.size();
}

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size() ? std::optional{value} : std::nullopt;
}

/// The tag that starts with a text, up to its ">"; empty if there is none.
std::string_view tag_at(std::string_view text, std::string_view start) {
  const std::size_t first = text.find(start);
  if (first == std::string_view::npos) return {};
  const std::size_t last = text.find('>', first);
  return last == std::string_view::npos ? std::string_view{} : text.substr(first, last - first);
}

}  // namespace

std::string_view xml_attribute(std::string_view tag, std::string_view name) {
  const std::string start = fmt::format(" {}=\"", name);
  const std::size_t first = tag.find(start);
  if (first == std::string_view::npos) return {};
  tag.remove_prefix(first + start.size());
  const std::size_t last = tag.find('"');
  return last == std::string_view::npos ? std::string_view{} : tag.substr(0, last);
}

VtkReader::VtkReader(std::filesystem::path path, std::string text) : path_(std::move(path)), text_(std::move(text)) {
  const std::string_view head = tag_at(std::string_view{text_}.substr(0, 1000), "<VTKFile");
  if (xml_attribute(head, "type") != "PolyData" || xml_attribute(head, "byte_order") != "LittleEndian" ||
      xml_attribute(head, "header_type") != "UInt64" || xml_attribute(head, "compressor") != "vtkZLibDataCompressor") {
    fail("is not a frame that KnitMech wrote");
  }
  if (!text_.ends_with("</VTKFile>\n")) fail("was cut off: it has no end");
  const std::string_view piece = tag_at(text_, "<Piece");
  const std::optional<std::size_t> points = whole_number(xml_attribute(piece, "NumberOfPoints"));
  const std::optional<std::size_t> lines = whole_number(xml_attribute(piece, "NumberOfLines"));
  if (!points || !lines) fail("is damaged: it does not say how many points and lines it has");
  n_points_ = *points;
  n_lines_ = *lines;
}

void VtkReader::fail(std::string_view complaint) const {
  throw InputError(fmt::format("{} {}.", path_.string(), complaint));
}

std::string_view VtkReader::section_text(std::string_view section) const {
  const std::string open = fmt::format("<{}>", section);
  const std::string close = fmt::format("</{}>", section);
  const std::string_view text = text_;
  const std::size_t first = text.find(open);
  const std::size_t last = text.find(close, first == std::string_view::npos ? first : first + open.size());
  if (last == std::string_view::npos) fail(fmt::format("is damaged: it has no part {}", section));
  return text.substr(first + open.size(), last - first - open.size());
}

template <typename Number>
std::vector<Number> VtkReader::values(std::string_view section, std::string_view name, std::size_t count) const {
  constexpr std::string_view kType = std::is_same_v<Number, double> ? "Float64" : "Int64";
  const std::string_view all = section_text(section);
  const std::string what = fmt::format("array {} of {}", name, section);
  const std::size_t named = all.find(fmt::format(" Name=\"{}\" ", name));
  if (named == std::string_view::npos) fail(fmt::format("has no {}", what));
  const std::size_t start = all.rfind('<', named);
  const std::size_t data = all.find('>', named);
  if (start == std::string_view::npos || data == std::string_view::npos)
    fail(fmt::format("is damaged in its {}", what));
  const std::string_view tag = all.substr(start, data - start);
  const std::size_t end = all.find('<', data);
  if (!tag.starts_with("<DataArray ") || xml_attribute(tag, "type") != kType ||
      xml_attribute(tag, "format") != "binary" || end == std::string_view::npos) {
    fail(fmt::format("is damaged in its {}", what));
  }
  const std::optional<Blocks> blocks = decoded(all.substr(data + 1, end - data - 1));
  // zlib makes things 1032 times smaller at best: more numbers than that are not in there.
  constexpr std::size_t kMostCompression = 1032;
  if (!blocks || count > (blocks->compressed.size() + 1) * kMostCompression) {
    fail(fmt::format("is damaged in its {}", what));
  }
  std::vector<Number> numbers(count);
  if (!decompress(*blocks, std::as_writable_bytes(std::span{numbers}))) {
    fail(fmt::format("is damaged in its {}, or belongs to another model", what));
  }
  return numbers;
}

std::vector<double> VtkReader::numbers(std::string_view section, std::string_view name, std::size_t count) const {
  return values<double>(section, name, count);
}

std::vector<std::int64_t> VtkReader::integers(std::string_view section, std::string_view name,
                                              std::size_t count) const {
  return values<std::int64_t>(section, name, count);
}

}  // namespace knitmech::results
