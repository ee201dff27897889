// SPDX-License-Identifier: MIT
// Whether the pixels of a PNG are all there, of a file whose chunks are whole: they are unpacked and
// forgotten.
#pragma once

#include "base/result.h"
#include "render/image/png_chunks.h"

namespace polhode {

/// Unpacks the data of all IDAT chunks, which make one zlib stream (PNG 1.2, section 10), and refuses a
/// stream that is absent, cut off, damaged (its Adler-32), followed by more data, or of another length than
/// rows and their filter bytes (0 to 4) need. The length and filters of an interlaced picture, which we never
/// write, are not looked at. The error is the reason alone: "its pixels are cut off".
///
/// Needs 64 KiB, however large the picture. 1920x1080 in RGB: about 15 ms.
Status check_png_pixels(const PngChunks& png);

}  // namespace polhode
