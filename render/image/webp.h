// SPDX-License-Identifier: MIT
// WebP without loss: about 0.6 of the size of our PNG files, for pages that browsers show.
#pragma once

#include "base/result.h"
#include "render/image/image.h"

#include <cstdint>
#include <vector>

namespace polhode {

inline constexpr int kMaxWebpSide = 16383;  ///< px, of the format

/// Every visible pixel as it is. The same image gives the same bytes. 1080p page: about 0.3 CPU s.
Result<std::vector<std::uint8_t>> encode_webp(const Image& image);

}  // namespace polhode
