#include "base/text.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace knitmech::base {
namespace {

/// Words longer than this are no misspelt keys; comparing them would only take time.
constexpr std::size_t kLongestWord = 100;

bool is_control(char letter) {
  constexpr unsigned char kFirstPrintable = 0x20;
  constexpr unsigned char kDelete = 0x7f;
  const auto code = static_cast<unsigned char>(letter);
  return code < kFirstPrintable || code == kDelete;
}

/// The beginning of a text in UTF-8, not cut within a letter.
std::string_view beginning(std::string_view text, std::size_t length) {
  constexpr unsigned char kContinuationMask = 0xc0;
  constexpr unsigned char kContinuation = 0x80;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & kContinuationMask) == kContinuation) --length;
  return text.substr(0, length);
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  const bool cut = text.size() > kLongest;
  std::string shown(cut ? beginning(text, kLongest) : text);
  std::ranges::replace_if(shown, is_control, '?');
  return '"' + shown + (cut ? "...\"" : "\"");
}

std::string in_markup(std::string_view text) {
  std::string result;
  for (const char each : text) {
    switch (each) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(each) < 0x20 ? ' ' : each;
    }
  }
  return result;
}

char32_t take_letter(std::string_view& text) {
  constexpr char32_t kReplacement = 0xFFFD;
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (first < 0x80U) return first;
  const int more = first >= 0xF0U ? 3 : first >= 0xE0U ? 2 : first >= 0xC0U ? 1 : 0;
  if (more == 0 || text.size() < static_cast<std::size_t>(more)) return kReplacement;
  char32_t letter = first & (0x3FU >> static_cast<unsigned>(more));
  for (int i = 0; i < more; ++i) {
    const auto next = static_cast<unsigned char>(text.front());
    if ((next & 0xC0U) != 0x80U) return kReplacement;
    letter = (letter << 6U) | (next & 0x3FU);
    text.remove_prefix(1);
  }
  return letter;
}

int edit_distance(std::string_view word_a, std::string_view word_b) {
  // One row of the usual table: row[j] = distance of the letters of a seen so far from the first j letters of b.
  std::vector<int> row(word_b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < word_a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i) + 1;
    for (std::size_t j = 0; j < word_b.size(); ++j) {
      const int replaced = diagonal + (word_a[i] == word_b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string_view nearest_word(std::string_view unknown, const std::vector<std::string_view>& known) {
  if (unknown.size() > kLongestWord) return {};
  constexpr int kShareThatMayChange = 3;
  int least = std::max(1, static_cast<int>(unknown.size()) / kShareThatMayChange) + 1;
  std::string_view nearest;
  for (const std::string_view word : known) {
    const int distance = edit_distance(unknown, word);
    if (distance < least) {
      least = distance;
      nearest = word;
    }
  }
  return nearest;
}

std::string alternatives(const std::vector<std::string_view>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace knitmech::base
