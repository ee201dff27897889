// SPDX-License-Identifier: MIT
#include "render/image/webp.h"

#include <webp/encode.h>

#include <string>

namespace polhode {

namespace {

// Measured on pages of a lecture: method 0 is four times as fast and a fifth larger, method 6 three times as
// slow and a tenth smaller.
constexpr int kMethod = 1;
constexpr float kEffort = 0;

// Measured on figures of a lecture: the smallest quality at which coloured type on paper has no fringes.
constexpr float kSmallQuality = 80;
constexpr int kSmallMethod = 2;

struct Picture {
  WebPPicture webp{};
  WebPMemoryWriter bytes{};
  Picture() { WebPMemoryWriterInit(&bytes); }
  ~Picture() {
    WebPPictureFree(&webp);
    WebPMemoryWriterClear(&bytes);
  }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
};

/// `choose` says how, of what libwebp proposes.
template <class Choose>
Result<std::vector<std::uint8_t>> encoded(const Image& image, const Choose& choose) {
  const auto [width, height] = image.size;
  if (width < 1 || height < 1 || width > kMaxWebpSide || height > kMaxWebpSide)
    return failure("A WebP of " + std::to_string(width) + " x " + std::to_string(height) +
                   " px is not possible: 1 to " + std::to_string(kMaxWebpSide) + " px a side.");
  WebPConfig config;
  Picture picture;
  if (!WebPConfigInit(&config) || !WebPPictureInit(&picture.webp))
    return failure("libwebp is older than the one we were built with.");
  choose(config);
  picture.webp.use_argb = 1;
  picture.webp.width = width;
  picture.webp.height = height;
  picture.webp.writer = WebPMemoryWrite;
  picture.webp.custom_ptr = &picture.bytes;
  if (!WebPPictureImportRGBA(&picture.webp, image.rgba.data(), 4 * width) ||
      !WebPEncode(&config, &picture.webp))
    return failure("libwebp cannot encode the image (error " + std::to_string(picture.webp.error_code) +
                   ").");
  return std::vector<std::uint8_t>(picture.bytes.mem, picture.bytes.mem + picture.bytes.size);
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_webp(const Image& image) {
  return encoded(image, [](WebPConfig& config) {
    config.lossless = 1;
    config.method = kMethod;
    config.quality = kEffort;
  });
}

Result<std::vector<std::uint8_t>> encode_small_webp(const Image& image) {
  return encoded(image, [](WebPConfig& config) {
    config.quality = kSmallQuality;
    config.method = kSmallMethod;
    config.use_sharp_yuv = 1;  // coloured type keeps its edges though colour is stored at half the size
  });
}

}  // namespace polhode
