#include "serve/request_words.h"

#include <fmt/format.h>

#include <charconv>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::serve {

std::optional<std::string> word(const RequestWords& words, const char* name) {
  const auto found = words.find(name);
  return found == words.end() || found->second.empty() ? std::nullopt : std::optional(found->second);
}

std::optional<int> whole_number(const RequestWords& words, const char* name, int largest) {
  const std::optional<std::string> text = word(words, name);
  if (!text) return std::nullopt;
  int value = 0;
  const char* const end = text->data() + text->size();
  const auto [stop, error] = std::from_chars(text->data(), end, value);
  if (error != std::errc{} || stop != end || value < 0 || value > largest) {
    throw InputError(
        fmt::format("{} should be a whole number from 0 to {}, not {}", name, largest, base::in_quotes(*text)));
  }
  return value;
}

}  // namespace knitmech::serve
