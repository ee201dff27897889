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

/// Packs one stream after the other, by libdeflate: fast is its level 1, small its level 10; 12 is 3 %
/// smaller in 2.4 times the time. Of a 1080p frame fast takes some 25 CPU ms, small 0.9 s. The same bytes
/// give the same stream, in every process and on every processor. ISA-L takes 10 ms, and does not: as of 2.32
/// its first hash is of the address of its own state (write_first_byte in igzip_icf_body_h1_gr_bt.asm), which
/// decides in one process of some seventy which of two equally good matches it takes.
class Packer {
 public:
  /// Throws std::bad_alloc.
  explicit Packer(PngPacking packing);
  ~Packer();
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  /// A zlib stream, valid until the next call. One thread at a time. Throws std::bad_alloc.
  std::span<const std::uint8_t> pack(std::span<const std::uint8_t> bytes);

 private:
  struct Free;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace polhode
