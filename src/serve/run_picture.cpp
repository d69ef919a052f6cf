#include "serve/run_picture.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "base/errors.h"
#include "base/text.h"
#include "picture/fabric_picture.h"
#include "picture/picture_words.h"
#include "results/read_frame.h"
#include "run/run_pictures.h"

namespace knitmech::serve {
namespace {

using Words = std::map<std::string, std::string>;

constexpr int kLargestSide = 8000;  // [px]

std::optional<std::string> word(const Words& words, const char* name) {
  const auto found = words.find(name);
  return found == words.end() || found->second.empty() ? std::nullopt : std::optional(found->second);
}

std::optional<int> whole_number(const Words& words, const char* name, int largest) {
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

}  // namespace

std::string run_picture_png(const results::StoredRun& run, const Words& words) {
  constexpr int kMostFrames = 1'000'000'000;
  picture::PictureOptions options;
  options.colour_by = picture::colour_by_word(word(words, "colour").value_or("plain"));
  options.view = picture::view_by_word(word(words, "view").value_or("front"));
  options.width = whole_number(words, "width", kLargestSide).value_or(options.width);
  options.height = whole_number(words, "height", kLargestSide).value_or(options.height);
  const int index = whole_number(words, "frame", kMostFrames).value_or(run.frames.back().index);
  const model::Frame frame = results::read_frame(run, index);
  options.caption = run::caption_of(frame.history);
  return picture::png_bytes(picture::draw_fabric(run.model, frame, options));
}

}  // namespace knitmech::serve
