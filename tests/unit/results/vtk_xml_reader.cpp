#include "vtk_xml_reader.h"

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <regex>
#include <stdexcept>

namespace knitmech::test {
namespace {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
};

Element parse_tag(const std::string& tag) {
  Element element;
  element.name = tag.substr(0, tag.find_first_of(" /\n"));
  static const std::regex kAttribute{R"re(([\w:.-]+)="([^"<&]*)")re"};
  for (auto it = std::sregex_iterator(tag.begin(), tag.end(), kAttribute); it != std::sregex_iterator(); ++it) {
    element.attributes[(*it)[1]] = (*it)[2];
  }
  return element;
}

std::vector<unsigned char> from_base64(const std::string& text) {
  std::vector<unsigned char> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    std::uint32_t value = 0;
    if (c >= 'A' && c <= 'Z') {
      value = static_cast<std::uint32_t>(c - 'A');
    } else if (c >= 'a' && c <= 'z') {
      value = static_cast<std::uint32_t>(c - 'a' + 26);
    } else if (c >= '0' && c <= '9') {
      value = static_cast<std::uint32_t>(c - '0' + 52);
    } else if (c == '+' || c == '/') {
      value = c == '+' ? 62 : 63;
    } else {
      break;
    }
    bits = (bits << 6U) | value;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<unsigned char>((bits >> static_cast<unsigned>(count)) & 255U));
    }
  }
  return bytes;
}

std::size_t base64_length(std::size_t n_bytes) {
  return (n_bytes + 2) / 3 * 4;
}

/// Number k of the header: number of blocks, their size, size of the last if it is smaller, compressed sizes.
std::uint64_t header_number(const std::vector<unsigned char>& header, std::size_t k) {
  std::uint64_t number = 0;
  std::memcpy(&number, header.data() + k * sizeof number, sizeof number);
  return number;
}

/// The bytes of inline compressed data: a base64 header, then the base64 of all compressed blocks one after the other.
std::vector<unsigned char> decompressed(const std::string& content, const std::string& name) {
  const auto n_blocks = header_number(from_base64(content.substr(0, base64_length(3 * sizeof(std::uint64_t)))), 0);
  const std::size_t header_length = base64_length((3 + n_blocks) * sizeof(std::uint64_t));
  const std::vector<unsigned char> header = from_base64(content.substr(0, header_length));
  const std::vector<unsigned char> blocks = from_base64(content.substr(header_length));
  std::vector<unsigned char> bytes;
  std::size_t at = 0;
  for (std::size_t k = 0; k < n_blocks; ++k) {
    const bool is_partial = k + 1 == n_blocks && header_number(header, 2) != 0;
    const std::uint64_t expected = header_number(header, is_partial ? 2 : 1);
    const std::uint64_t compressed = header_number(header, 3 + k);
    std::vector<unsigned char> block(expected);
    uLongf size = expected;
    if (at + compressed > blocks.size() || uncompress(block.data(), &size, blocks.data() + at, compressed) != Z_OK ||
        size != expected) {
      throw std::runtime_error("a block of " + name + " is wrong");
    }
    bytes.insert(bytes.end(), block.begin(), block.end());
    at += compressed;
  }
  if (at != blocks.size()) throw std::runtime_error("the byte count of " + name + " is wrong");
  return bytes;
}

template <typename Number>
std::vector<double> numbers(const std::vector<unsigned char>& bytes) {
  std::vector<double> values(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < values.size(); ++i) {
    Number value;
    std::memcpy(&value, bytes.data() + i * sizeof(Number), sizeof value);
    values[i] = static_cast<double>(value);
  }
  return values;
}

VtkArray decode(const Element& element, const std::string& content) {
  VtkArray array;
  array.type = element.attributes.at("type");
  const auto components = element.attributes.find("NumberOfComponents");
  array.components = components == element.attributes.end() ? 1 : std::stoi(components->second);
  const std::vector<unsigned char> bytes = decompressed(content, element.attributes.at("Name"));
  if (array.type == "Float64") {
    array.values = numbers<double>(bytes);
  } else if (array.type == "Int64") {
    array.values = numbers<std::int64_t>(bytes);
  } else if (array.type == "Int32") {
    array.values = numbers<std::int32_t>(bytes);
  }
  return array;
}

/// Calls on_tag(element, parent, text after the tag) for each opening tag; returns whether the text is well formed.
template <typename OnTag>
bool walk(const std::string& text, OnTag&& on_tag) {
  std::vector<std::string> open;
  int roots = 0;
  std::size_t at = text.find('<');
  while (at != std::string::npos) {
    const std::size_t close = text.find('>', at);
    if (close == std::string::npos) {
      return false;
    }
    const std::string tag = text.substr(at + 1, close - at - 1);
    at = text.find('<', close);
    const std::string content = text.substr(close + 1, at == std::string::npos ? at : at - close - 1);
    static const std::regex kBareAmpersand{"&(?!amp;|lt;|gt;|quot;|apos;|#)"};
    if (std::regex_search(tag + content, kBareAmpersand) || tag.find('<') != std::string::npos) {
      return false;
    }
    if (tag.front() == '?') {
      continue;
    }
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) {
        return false;
      }
      open.pop_back();
      continue;
    }
    const Element element = parse_tag(tag);
    roots += open.empty() ? 1 : 0;
    on_tag(element, open.empty() ? std::string{} : open.back(), content);
    if (tag.back() != '/') {
      open.push_back(element.name);
    }
  }
  return open.empty() && roots == 1;
}

}  // namespace

VtkFile read_vtk_xml(const std::string& text) {
  VtkFile file;
  file.well_formed = walk(text, [&file](const Element& element, const std::string& parent, const std::string& content) {
    if (element.name == "Piece") {
      file.piece = element.attributes;
    } else if (element.name == "DataArray") {
      file.arrays[parent + "/" + element.attributes.at("Name")] = decode(element, content);
    }
  });
  return file;
}

bool is_well_formed(const std::string& text) {
  return walk(text, [](const Element&, const std::string&, const std::string&) {});
}

}  // namespace knitmech::test
