// SPDX-License-Identifier: MIT
// What a PNG file says of itself, of a file that is whole; its pixels are not decoded.
#pragma once

#include "render/image/png.h"
#include "render/image/png_chunks.h"

namespace polhode {

struct PngSummary {
  Size size;
  PngMetadata metadata;
};

/// Refuses what is no PNG, truncated, or damaged in any chunk. Text that is compressed, which we never write,
/// is left out. Cost: reading the file and its check sums, about 1 ms for 1 MB.
Result<PngSummary> summarize_png(std::span<const std::uint8_t> bytes);
/// Of chunks that are known to be whole.
PngSummary summarize_png(const PngChunks& png);
/// Of a file. The error is the reason alone, without the file's name.
Result<PngSummary> summarize_png_file(const std::filesystem::path& path);

}  // namespace polhode
