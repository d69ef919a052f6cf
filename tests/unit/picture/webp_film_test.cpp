#include "picture/webp_film.h"

#include <gtest/gtest.h>
#include <webp/demux.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/errors.h"

namespace knitmech::picture {
namespace {

/// What libwebp's own decoder finds in a film.
struct Decoded {
  int width = 0, height = 0, loops = -1;
  std::vector<int> ends;                           ///< of each picture [ms]
  std::vector<std::array<int, 3>> middle_colours;  ///< red, green and blue in the middle of each
};

Decoded decoded(const std::string& bytes) {
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  const std::unique_ptr<WebPAnimDecoder, void (*)(WebPAnimDecoder*)> decoder(WebPAnimDecoderNew(&data, nullptr),
                                                                             WebPAnimDecoderDelete);
  Decoded film;
  WebPAnimInfo info;
  if (!decoder || WebPAnimDecoderGetInfo(decoder.get(), &info) == 0) return film;
  film.width = static_cast<int>(info.canvas_width);
  film.height = static_cast<int>(info.canvas_height);
  film.loops = static_cast<int>(info.loop_count);
  while (WebPAnimDecoderHasMoreFrames(decoder.get()) != 0) {
    std::uint8_t* rgba = nullptr;
    int end = 0;
    if (WebPAnimDecoderGetNext(decoder.get(), &rgba, &end) == 0) break;
    film.ends.push_back(end);
    const std::uint8_t* middle = rgba + 4 * (film.height / 2 * film.width + film.width / 2);
    film.middle_colours.push_back({middle[0], middle[1], middle[2]});
  }
  return film;
}

const std::vector<std::uint32_t> kColours{0xff0000, 0x00ff00, 0x0000ff, 0x404040, 0xf0f0f0};

std::string film_of_colours(double hold) {
  WebpFilm film(20);
  for (const std::uint32_t rgb : kColours) film.add(Image(120, 80, from_srgb(rgb)));
  return film.finish(hold);
}

TEST(WebpFilm, HasThePicturesInTheirOrderForEver) {
  const Decoded film = decoded(film_of_colours(0));
  EXPECT_EQ(film.width, 120);
  EXPECT_EQ(film.height, 80);
  EXPECT_EQ(film.loops, 0) << "0: for ever";
  EXPECT_EQ(film.ends, (std::vector<int>{50, 100, 150, 200, 250}));
  ASSERT_EQ(film.middle_colours.size(), kColours.size());
  for (std::size_t i = 0; i < kColours.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int wanted = static_cast<int>(kColours[i] >> (16 - 8 * channel) & 0xffU);
      EXPECT_NEAR(film.middle_colours[i][channel], wanted, 6) << "picture " << i;
    }
  }
}

TEST(WebpFilm, HoldsItsLastPicture) {
  EXPECT_EQ(decoded(film_of_colours(1.5)).ends.back(), 250 + 1500);
}

TEST(WebpFilm, IsTheSameForTheSamePictures) {
  EXPECT_EQ(film_of_colours(0), film_of_colours(0));
}

TEST(WebpFilm, RefusesWhatMakesNoFilm) {
  EXPECT_THROW(WebpFilm(0), InputError);
  EXPECT_THROW(WebpFilm(101), InputError);
  WebpFilm empty(10);
  EXPECT_THROW(static_cast<void>(empty.finish()), std::invalid_argument);
  WebpFilm film(10);
  film.add(Image(30, 20, from_srgb(0)));
  EXPECT_THROW(film.add(Image(31, 20, from_srgb(0))), std::invalid_argument);
  EXPECT_THROW(WebpFilm(10).add(Image(kLargestWebpSide + 1, 1, from_srgb(0))), InputError);
}

}  // namespace
}  // namespace knitmech::picture
