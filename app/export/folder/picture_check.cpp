// SPDX-License-Identifier: MIT
#include "app/export/folder/picture_check.h"

#include "base/files/file_bytes.h"
#include "base/sha256.h"
#include "render/image/png_pixels.h"
#include "render/image/png_summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace {

using State = PictureCheck::State;

PictureCheck is_not_whole(State state, std::string reason) { return {state, std::move(reason), {}}; }

/// Why a picture that is whole is not this one; empty: it is.
std::string difference(const PngSummary& png, Size size, const PngMetadata& metadata) {
  if (png.size != size)
    return fmt::format("it has {}x{} pixels, not {}x{}", png.size.width, png.size.height, size.width,
                       size.height);
  if (png.metadata.dpi != metadata.dpi)
    return fmt::format("it has {} dpi, not {}", png.metadata.dpi, metadata.dpi);
  const auto& found = png.metadata.text;
  for (const auto& text : metadata.text)
    if (std::find(found.begin(), found.end(), text) == found.end())
      return fmt::format("its {} is not that of this picture", text.first);
  return {};
}

/// So long a file of a picture can be, with room: pixels that do not get smaller when they are packed, and
/// texts.
std::uintmax_t most_bytes(Size size) {
  constexpr std::uintmax_t kEachPixel = 5, kTexts = std::uintmax_t{4} * kMaxPngTextBytes;
  return std::min(kMaxPictureBytes, kTexts + kEachPixel *
                                                 static_cast<std::uintmax_t>(std::max(size.width, 0)) *
                                                 static_cast<std::uintmax_t>(std::max(size.height, 0)));
}

}  // namespace

PictureCheck check_picture(const std::filesystem::path& file, Size size, const PngMetadata& metadata,
                           const std::string& sha256) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    return is_not_whole(State::missing, "it is not there");
  if (!std::filesystem::is_regular_file(status)) return is_not_whole(State::another, "it is not a file");
  const auto bytes = read_file_bytes(file, most_bytes(size));
  if (!bytes) return is_not_whole(State::damaged, bytes.error());
  const Result<PngChunks> png = read_png_chunks(*bytes);
  if (!png) return is_not_whole(State::damaged, png.error());
  if (const Status pixels = check_png_pixels(*png); !pixels)
    return is_not_whole(State::damaged, pixels.error());
  if (std::string reason = difference(summarize_png(*png), size, metadata); !reason.empty())
    return is_not_whole(State::another, std::move(reason));
  std::string found_sha256 = sha256_hex(*bytes);
  if (!sha256.empty() && found_sha256 != sha256) return is_not_whole(State::damaged, kOtherBytes);
  return {State::whole, {}, std::move(found_sha256)};
}

}  // namespace polhode
