#include "serve/run_picture.h"

#include "picture/fabric_picture.h"
#include "picture/picture_words.h"
#include "results/read_frame.h"
#include "run/run_pictures.h"
#include "serve/constants.h"

namespace knitmech::serve {
namespace {

constexpr int kLargestSide = 8000;  // [px]

}  // namespace

std::string run_picture_png(const results::StoredRun& run, const RequestWords& words) {
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
