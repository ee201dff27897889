// SPDX-License-Identifier: MIT
// The chunks of a PNG as they are stored, for those who pass a file on without decoding it.
#pragma once

#include "base/result.h"
#include "render/image/image.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace polhode {

struct PngChunk {
  std::string_view type;  ///< four letters
  std::span<const std::uint8_t> data;
};

/// What IHDR says.
struct PngHeader {
  Size size;
  int bit_depth = 0;
  int color_type = 0;  ///< 0 grey, 2 RGB, 3 palette, 4 grey with alpha, 6 RGBA
  bool interlaced = false;
};

struct PngChunks {
  PngHeader header;
  std::vector<PngChunk> chunks;  ///< from IHDR to IEND; they point into the bytes given
};

/// Refuses what is no PNG, truncated, or damaged in any chunk (each has a check sum); the pixels are not
/// decoded. 1 MB: about 1 ms.
Result<PngChunks> read_png_chunks(std::span<const std::uint8_t> bytes);

}  // namespace polhode
