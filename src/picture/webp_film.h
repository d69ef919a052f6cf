#pragma once

#include <memory>
#include <string>

#include "picture/image.h"

namespace knitmech::picture {

/// An animated WebP that goes round for ever, picture by picture: the one kind of film that every browser and most
/// slides show like a picture. By libwebp, lossy.
///
/// Equal pictures give equal bytes.
class WebpFilm {
 public:
  /// \param pictures_per_second above 0 and at most 100: some players show no shorter pictures
  /// Throws InputError for another number of pictures per second.
  explicit WebpFilm(double pictures_per_second);
  ~WebpFilm();
  WebpFilm(const WebpFilm&) = delete;
  WebpFilm& operator=(const WebpFilm&) = delete;
  WebpFilm(WebpFilm&&) = delete;
  WebpFilm& operator=(WebpFilm&&) = delete;

  /// Adds a picture, shown for 1 / pictures_per_second. All must be of one size, at most 16383 px wide and high. Throws
  /// InputError if it is larger, std::invalid_argument if the size differs from that of the first.
  void add(const Image& image);

  /// The bytes of the file, the last picture shown for longer by a time [s]. At least one picture must have been added;
  /// none can be added after.
  [[nodiscard]] std::string finish(double hold = 0);

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

/// Largest side that the format allows [px].
inline constexpr int kLargestWebpSide = 16383;

}  // namespace knitmech::picture
