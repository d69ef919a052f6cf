#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knitmech::serve {

/// An answer with many numbers: a head in JSON and named arrays, as web/src/api/blob.ts reads it. Four bytes with the
/// length of the head, the head padded with spaces so that the arrays begin on a multiple of 8, the arrays, each on a
/// multiple of 8. The head's "arrays" tells by name type ("f32" or "i32"), offset from the end of the head [bytes] and
/// length [numbers]. All little-endian.
class Blob {
 public:
  void add(std::string_view name, std::span<const float> values);
  void add(std::string_view name, std::span<const std::int32_t> values);

  /// The bytes. \param head a JSON object without "arrays"
  [[nodiscard]] std::string bytes(std::string_view head) const;

 private:
  struct Place {
    std::string name;
    const char* type;
    std::size_t offset, length;
  };
  void append(std::string_view name, const char* type, const void* values, std::size_t n_values);

  std::vector<Place> places_;
  std::string data_;
};

}  // namespace knitmech::serve
