// SPDX-License-Identifier: MIT
// PNG through libpng: metadata, resolution, limits on what is read.
#pragma once

#include "render/image/atomic_file.h"
#include "render/image/image.h"
#include "render/result.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

inline constexpr int kMaxPngSide = 16384;             ///< px, written and read
inline constexpr int kMaxPngTextBytes = 1024 * 1024;  ///< of one text chunk, read

/// How hard pixels are packed.
enum class PngPacking { fast, small };

struct PngMetadata {
  /// Keyword (1 to 79 printable ASCII characters) and UTF-8 text, in order; tEXt if Latin-1, else iTXt.
  std::vector<std::pair<std::string, std::string>> text;
  int dpi = 0;  ///< pHYs; 0: none
};

/// RGB if the image is opaque everywhere, else RGBA. The same image and metadata give the same bytes; no time
/// stamp. 1080p frame: about 46 CPU ms (Sub filter, run-length deflate at level 1).
Result<std::vector<std::uint8_t>> encode_png(const Image& image, const PngMetadata& metadata);

struct PngFile {
  Image image;
  PngMetadata metadata;
};
/// Any PNG, expanded to 8-bit RGBA, values as stored; text is UTF-8 again. Optional chunks that are damaged,
/// or expand to over 1 MiB, are left out. Refused are damaged and truncated files, more than 16384 px a side,
/// chunks over 1 MiB (other than pixels), and more pixels than a file of that length can hold (decompression
/// bombs).
Result<PngFile> decode_png(std::span<const std::uint8_t> bytes);
Result<PngFile> read_png(const std::filesystem::path& path);

/// encode_png, then write_file_atomically.
Status write_png(const std::filesystem::path& path, const Image& image, const PngMetadata& metadata,
                 Durability durability = Durability::rename_only);

}  // namespace polhode
