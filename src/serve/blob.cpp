#include "serve/blob.h"

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

namespace knitmech::serve {
namespace {

static_assert(std::endian::native == std::endian::little, "a blob holds numbers as this processor does");

constexpr std::size_t kAlignment = 8;
constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kNumberBytes = 4;

}  // namespace

void Blob::add(std::string_view name, std::span<const float> values) {
  append(name, "f32", values.data(), values.size());
}

void Blob::add(std::string_view name, std::span<const std::int32_t> values) {
  append(name, "i32", values.data(), values.size());
}

void Blob::append(std::string_view name, const char* type, const void* values, std::size_t n_values) {
  places_.push_back({std::string(name), type, data_.size(), n_values});
  data_.append(static_cast<const char*>(values), n_values * kNumberBytes);
  data_.resize((data_.size() + kAlignment - 1) / kAlignment * kAlignment, '\0');
}

std::string Blob::bytes(std::string_view head) const {
  auto document = nlohmann::ordered_json::parse(head);
  auto& arrays = document["arrays"] = nlohmann::ordered_json::object();
  for (const Place& place : places_) {
    arrays[place.name] = {{"type", place.type}, {"offset", place.offset}, {"length", place.length}};
  }
  std::string text = document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  const std::size_t whole = (kLengthBytes + text.size() + kAlignment - 1) / kAlignment * kAlignment;
  text.resize(whole - kLengthBytes, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string bytes(kLengthBytes, '\0');
  std::memcpy(bytes.data(), &length, kLengthBytes);
  return bytes + text + data_;
}

}  // namespace knitmech::serve
