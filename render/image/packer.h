// SPDX-License-Identifier: MIT
// The zlib stream of a PNG's pixels. Internal to render/image/.
#pragma once

#include "render/image/png.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace polhode {

/// Memory that is not cleared: what is not written to takes none.
class Buffer {
 public:
  /// What it held is lost if it grows.
  std::uint8_t* at_least(std::size_t bytes) {
    if (bytes > bytes_) {
      data_.reset();  // first, or both would be there at once
      data_ = std::make_unique_for_overwrite<std::uint8_t[]>(bytes);
      bytes_ = bytes;
    }
    return data_.get();
  }

 private:
  std::unique_ptr<std::uint8_t[]> data_;
  std::size_t bytes_ = 0;
};

/// So many bytes behind those that are packed are readable, and 0. ISA-L compares 32 bytes at once and may
/// look beyond the end; nothing it meets there, and nothing an earlier stream left in its work memory, is to
/// decide which of two equally good matches it takes.
inline constexpr std::size_t kPackerPadding = 64;

/// Packs one stream after the other. One thread at a time.
class Packer {
 public:
  virtual ~Packer() = default;
  /// At most 2 GiB at once. Precondition: kPackerPadding zeros lie behind `bytes`. Valid until the next call.
  /// Throws std::length_error, std::bad_alloc.
  virtual std::span<const std::uint8_t> pack(std::span<const std::uint8_t> bytes) = 0;
};

/// Fast: ISA-L's level 1. Its bytes are the same on all x86-64 processors that have SSE 4.2 (since 2008; seen
/// on one and by emulating four); one without gives other bytes of the same picture. Small: libdeflate's
/// level 10; 12 is 3 % smaller in 2.4 times the time. 1080p frame: 9 of the 10 CPU ms that its PNG takes, and
/// 0.9 s.
std::unique_ptr<Packer> make_packer(PngPacking packing);

}  // namespace polhode
