// SPDX-License-Identifier: MIT
// The rows of an image as PNG stores them before they are packed: a byte that names a filter, then
// differences to pixels beside or above, which pack better than the pixels.
#pragma once

#include "render/image/image.h"

#include <cstddef>
#include <cstdint>

namespace polhode {

enum class PngChannels { rgb = 3, rgba = 4 };

/// Of all filtered rows.
std::size_t filtered_bytes(Size size, PngChannels channels);

/// Each row less the pixel on the left ("Sub"), into filtered_bytes(size, rgba) bytes; RGB if the image is
/// opaque everywhere, which it finds on the way. 1080p: about 2 CPU ms.
PngChannels filter_rows_fast(const Image& image, std::uint8_t* to);

/// The same with the filter (none, left, above) that promises the fewest bits of each row. 1080p: 50 CPU ms.
PngChannels filter_rows_well(const Image& image, std::uint8_t* to);

}  // namespace polhode
