#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace knitmech::curves {

static_assert(std::endian::native == std::endian::little,
              "both binary formats are little-endian, as this processor is");

/// Adds the bytes of a number to a file in memory.
template <typename Number>
void put(std::string& bytes, Number value) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &value, sizeof(Number));
  bytes.append(raw.data(), sizeof(Number));
}

/// Adds x, y and z as 32-bit numbers. Throws InputError if one is too large for them, or not finite.
void put_point(std::string& bytes, const Eigen::Vector3d& point);

/// The number whose bytes begin at a place, which must have enough of them behind it.
template <typename Number>
[[nodiscard]] Number number_at(std::string_view bytes, std::size_t place) {
  Number value;
  std::memcpy(&value, bytes.data() + place, sizeof(Number));
  return value;
}

/// The point of three 32-bit numbers that begin at a place.
[[nodiscard]] Eigen::Vector3d point_at(std::string_view bytes, std::size_t place);

}  // namespace knitmech::curves
