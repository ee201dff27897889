// SPDX-License-Identifier: MIT
// WebP, for pages that browsers show: without loss about 0.6 of the size of our PNG files, with a loss that
// nobody sees on a screen about 0.1 of it.
#pragma once

#include "base/result.h"
#include "render/image/image.h"

#include <cstdint>
#include <vector>

namespace polhode {

inline constexpr int kMaxWebpSide = 16383;  ///< px, of the format

/// Every visible pixel as it is. The same image gives the same bytes. 1080p page: about 0.3 CPU s.
Result<std::vector<std::uint8_t>> encode_webp(const Image& image);

/// Almost as it is, of what is opaque: edges of type and lines keep their place and nearly their colour
/// (tests hold what is lost). The same image gives the same bytes. 960 x 600 px: about 0.04 CPU s, 10 to
/// 30 kB.
Result<std::vector<std::uint8_t>> encode_small_webp(const Image& image);

}  // namespace polhode
