#include "picture/webp_film.h"

#include <fmt/core.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <new>
#include <stdexcept>

#include "base/errors.h"

namespace knitmech::picture {
namespace {

constexpr double kMostPicturesPerSecond = 100;

/// Of the pictures, 0 to 100 [-]; usual 85. More shows less noise about the edges of the yarns and makes larger files.
constexpr float kQuality = 85;

/// How long the encoder tries, 0 to 6 [-]; usual 4. More makes smaller files, slowly.
constexpr int kEffort = 4;

WebPConfig encoding() {
  WebPConfig config;
  if (WebPConfigPreset(&config, WEBP_PRESET_DRAWING, kQuality) == 0) {
    throw std::runtime_error("libwebp is of another version than its headers.");
  }
  config.method = kEffort;
  return config;
}

struct DeleteEncoder {
  void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};

/// A picture in the form of libwebp.
class WebpImage {
 public:
  explicit WebpImage(const Image& image) {
    if (WebPPictureInit(&picture_) == 0) throw std::runtime_error("libwebp is of another version than its headers.");
    picture_.use_argb = 1;
    picture_.width = image.width();
    picture_.height = image.height();
    const std::vector<std::uint8_t> rgb = rgb_bytes(image);
    if (WebPPictureImportRGB(&picture_, rgb.data(), 3 * image.width()) == 0) throw std::bad_alloc();
  }
  ~WebpImage() { WebPPictureFree(&picture_); }
  WebpImage(const WebpImage&) = delete;
  WebpImage& operator=(const WebpImage&) = delete;
  WebpImage(WebpImage&&) = delete;
  WebpImage& operator=(WebpImage&&) = delete;

  WebPPicture* get() { return &picture_; }

 private:
  WebPPicture picture_{};
};

}  // namespace

struct WebpFilm::Encoder {
  double pictures_per_second = 0;
  int n_pictures = 0;
  int width = 0, height = 0;
  WebPConfig config = encoding();
  std::unique_ptr<WebPAnimEncoder, DeleteEncoder> webp;

  [[nodiscard]] int milliseconds(double pictures) const {
    return static_cast<int>(std::lround(1000 * pictures / pictures_per_second));
  }

  void open(const Image& image) {
    width = image.width();
    height = image.height();
    if (width > kLargestWebpSide || height > kLargestWebpSide) {
      throw InputError(fmt::format("A film of {} x {} px cannot be written; WebP has at most {} px a side.", width,
                                   height, kLargestWebpSide));
    }
    WebPAnimEncoderOptions options;
    if (WebPAnimEncoderOptionsInit(&options) == 0) {
      throw std::runtime_error("libwebp is of another version than its headers.");
    }
    options.anim_params.loop_count = 0;  // for ever
    webp.reset(WebPAnimEncoderNew(width, height, &options));
    if (!webp) throw std::bad_alloc();
  }

  /// Picture or, at the end, none.
  void add(WebPPicture* picture, int timestamp) const {
    if (WebPAnimEncoderAdd(webp.get(), picture, timestamp, &config) == 0) {
      throw std::runtime_error(fmt::format("The film cannot be written: {}.", WebPAnimEncoderGetError(webp.get())));
    }
  }
};

WebpFilm::WebpFilm(double pictures_per_second) : encoder_(std::make_unique<Encoder>()) {
  if (!(pictures_per_second > 0 && pictures_per_second <= kMostPicturesPerSecond)) {
    throw InputError(fmt::format("A film of {} pictures per second cannot be made; take up to {}.", pictures_per_second,
                                 kMostPicturesPerSecond));
  }
  encoder_->pictures_per_second = pictures_per_second;
}

WebpFilm::~WebpFilm() = default;

void WebpFilm::add(const Image& image) {
  if (!encoder_->webp) encoder_->open(image);
  if (image.width() != encoder_->width || image.height() != encoder_->height) {
    throw std::invalid_argument(fmt::format("A picture of {} x {} px does not fit into a film of {} x {} px.",
                                            image.width(), image.height(), encoder_->width, encoder_->height));
  }
  WebpImage picture(image);
  encoder_->add(picture.get(), encoder_->milliseconds(encoder_->n_pictures));
  ++encoder_->n_pictures;
}

std::string WebpFilm::finish(double hold) {
  if (!encoder_->webp) throw std::invalid_argument("A film needs a picture.");
  encoder_->add(nullptr, encoder_->milliseconds(encoder_->n_pictures + hold * encoder_->pictures_per_second));
  WebPData data;
  WebPDataInit(&data);
  if (WebPAnimEncoderAssemble(encoder_->webp.get(), &data) == 0) {
    throw std::runtime_error(
        fmt::format("The film cannot be written: {}.", WebPAnimEncoderGetError(encoder_->webp.get())));
  }
  std::string bytes(reinterpret_cast<const char*>(data.bytes), data.size);
  WebPDataClear(&data);
  return bytes;
}

}  // namespace knitmech::picture
