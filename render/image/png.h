// SPDX-License-Identifier: MIT
// PNG: pixels packed by libdeflate, chunks and reading by libpng; metadata, resolution, limits on
// what is read.
#pragma once

#include "base/files/atomic_file.h"
#include "base/result.h"
#include "render/image/image.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

inline constexpr int kMaxPngSide = 16384;             ///< px, written and read
inline constexpr int kMaxPngTextBytes = 1024 * 1024;  ///< of one text chunk, read

struct PngMetadata {
  /// Keyword (1 to 79 printable ASCII characters) and UTF-8 text, in order; tEXt if Latin-1, else iTXt.
  std::vector<std::pair<std::string, std::string>> text;
  int dpi = 0;  ///< pHYs; 0: none
};

/// How hard pixels are packed; CPU time and size of a 1080p frame, against libpng's default settings.
enum class PngPacking {
  fast,   ///< some 25 ms
  small,  ///< 0.9 s, 13 % smaller
};

/// Encodes one image after the other; keeps its buffers: 3 or 4 bytes a pixel of the largest so far, and
/// twice its file (with a scene of 16384 x 16384: 1 GiB, with noise 2.5). One thread at a time.
class PngEncoder {
 public:
  explicit PngEncoder(PngPacking packing = PngPacking::fast);
  ~PngEncoder();
  PngEncoder(PngEncoder&&) noexcept;
  PngEncoder& operator=(PngEncoder&&) noexcept;

  /// RGB if the image is opaque everywhere, else RGBA. The same image, metadata and packing give the same
  /// bytes; no time stamp. The bytes stay valid until the next call.
  Result<std::span<const std::uint8_t>> encode(const Image& image, const PngMetadata& metadata);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One image, by an encoder of its own.
Result<std::vector<std::uint8_t>> encode_png(const Image& image, const PngMetadata& metadata,
                                             PngPacking packing = PngPacking::fast);

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

/// Encodes, then write_file_atomically.
Status write_png(const std::filesystem::path& path, const Image& image, const PngMetadata& metadata,
                 Durability durability = Durability::rename_only);
Status write_png(PngEncoder& encoder, const std::filesystem::path& path, const Image& image,
                 const PngMetadata& metadata, Durability durability);

}  // namespace polhode
