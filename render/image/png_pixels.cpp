// SPDX-License-Identifier: MIT
#include "render/image/png_pixels.h"

#include <isa-l/igzip_lib.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace polhode {
namespace {

constexpr std::uint8_t kLastFilter = 4;  // Paeth

int samples_per_pixel(int color_type) {
  switch (color_type) {
    case 2:
      return 3;
    case 4:
      return 2;
    case 6:
      return 4;
    default:
      return 1;
  }
}

// A row with its filter byte.
std::size_t bytes_per_row(const PngHeader& header) {
  const auto bits = static_cast<std::size_t>(header.size.width) *
                    static_cast<std::size_t>(header.bit_depth * samples_per_pixel(header.color_type));
  return 1 + (bits + 7) / 8;
}

// Sees unpacked bytes go by and knows which of them name a filter.
class Rows {
 public:
  explicit Rows(const PngHeader& header)
      : row_bytes_(bytes_per_row(header)),
        all_bytes_(row_bytes_ * static_cast<std::size_t>(header.size.height)),
        counted_(!header.interlaced) {}

  Status take(std::span<const std::uint8_t> bytes) {
    if (!counted_) return success();
    if (bytes.size() > all_bytes_ - seen_) return failure("it has more pixels than its size tells");
    const std::size_t into_row = seen_ % row_bytes_;
    for (std::size_t at = into_row == 0 ? 0 : row_bytes_ - into_row; at < bytes.size(); at += row_bytes_)
      if (bytes[at] > kLastFilter) return failure("a row of its pixels has a filter that does not exist");
    seen_ += bytes.size();
    return success();
  }
  bool complete() const { return !counted_ || seen_ == all_bytes_; }

 private:
  std::size_t row_bytes_, all_bytes_, seen_ = 0;
  bool counted_;
};

// The state alone takes some 90 kB: too much for the stack of a thread.
class Unpacker {
 public:
  explicit Unpacker(Rows& rows) : rows_(rows), state_(std::make_unique<inflate_state>()) {
    isal_inflate_init(state_.get());
    state_->crc_flag = ISAL_ZLIB;  // header and Adler-32 of the stream are read and checked
  }

  Status take(std::span<const std::uint8_t> packed) {
    state_->next_in = const_cast<std::uint8_t*>(packed.data());  // only read, in spite of its type
    state_->avail_in = static_cast<std::uint32_t>(packed.size());
    for (;;) {
      if (finished()) return has_more() ? failure("its pixels go on after their end") : success();
      state_->next_out = unpacked_.data();
      state_->avail_out = static_cast<std::uint32_t>(unpacked_.size());
      if (isal_inflate(state_.get()) != ISAL_DECOMP_OK) return failure("its pixels are damaged");
      const std::size_t count = unpacked_.size() - state_->avail_out;
      const bool stands_still = count == 0 && state_->avail_in > 0 && !finished();
      if (stands_still)
        return failure("its pixels are damaged");  // not seen so far; a loop without end otherwise
      if (Status taken = rows_.take(std::span(unpacked_).first(count)); !taken) return taken;
      const bool wants_more = state_->avail_in == 0 && state_->avail_out > 0;
      if (wants_more && !finished()) return success();
    }
  }
  bool finished() const { return state_->block_state == ISAL_BLOCK_FINISH; }

 private:
  // Of the stream's last chunk: what was given, and what was taken of it for bits that were not needed.
  bool has_more() const { return state_->avail_in > 0 || state_->read_in_length >= 8; }

  Rows& rows_;
  std::unique_ptr<inflate_state> state_;
  std::vector<std::uint8_t> unpacked_ = std::vector<std::uint8_t>(std::size_t{1} << 16);
};

}  // namespace

Status check_png_pixels(const PngChunks& png) {
  Rows rows(png.header);
  Unpacker unpacker(rows);
  for (const PngChunk& chunk : png.chunks)
    if (chunk.type == "IDAT")
      if (Status taken = unpacker.take(chunk.data); !taken) return taken;
  if (!unpacker.finished() || !rows.complete()) return failure("its pixels are cut off");
  return success();
}

}  // namespace polhode
