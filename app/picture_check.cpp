// SPDX-License-Identifier: MIT
#include "app/picture_check.h"

#include "render/image/png_summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

PictureCheck check_picture(const std::filesystem::path& file, Size size, const PngMetadata& metadata) {
  using State = PictureCheck::State;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) return {State::missing, "it is not there"};
  if (!std::filesystem::is_regular_file(status)) return {State::another, "it is not a file"};
  const Result<PngSummary> png = summarize_png_file(file);
  if (!png) return {State::damaged, png.error()};
  if (png->size != size)
    return {State::another, fmt::format("it has {}x{} pixels, not {}x{}", png->size.width, png->size.height,
                                        size.width, size.height)};
  if (png->metadata.dpi != metadata.dpi)
    return {State::another, fmt::format("it has {} dpi, not {}", png->metadata.dpi, metadata.dpi)};
  const auto& found = png->metadata.text;
  for (const auto& text : metadata.text)
    if (std::find(found.begin(), found.end(), text) == found.end())
      return {State::another, fmt::format("its {} is not that of this picture", text.first)};
  return {};
}

}  // namespace polhode
