// SPDX-License-Identifier: MIT
#include "render/image/packer.h"

#include <isa-l/igzip_lib.h>
#include <libdeflate.h>

#include <cstring>
#include <new>
#include <stdexcept>

namespace polhode {
namespace {

class FastPacker final : public Packer {
 public:
  std::span<const std::uint8_t> pack(std::span<const std::uint8_t> bytes) override {
    if (bytes.size() > kMost) throw std::length_error("more bytes than ISA-L can count");
    const std::size_t room = bound(bytes.size());
    std::uint8_t* packed = packed_.at_least(room);
    std::memset(&stream_, 0, sizeof stream_);  // 0.2 MiB with its tables and window: some 10 µs
    isal_deflate_init(&stream_);
    stream_.level = kLevel;
    stream_.level_buf = work_.at_least(kWork);
    std::memset(stream_.level_buf, 0, kWork);
    stream_.level_buf_size = kWork;
    stream_.gzip_flag = IGZIP_ZLIB;
    stream_.end_of_stream = 1;
    stream_.next_in = const_cast<std::uint8_t*>(bytes.data());  // only read, in spite of its type
    stream_.avail_in = static_cast<std::uint32_t>(bytes.size());
    stream_.next_out = packed;
    stream_.avail_out = static_cast<std::uint32_t>(room);
    if (isal_deflate(&stream_) != COMP_OK || stream_.internal_state.state != ZSTATE_END)
      throw std::logic_error("ISA-L needs more room than its blocks can take");
    return {packed, room - stream_.avail_out};
  }

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 31;
  static constexpr std::uint32_t kLevel = 1, kWork = ISAL_DEF_LVL1_DEFAULT;

  // Blocks that do not get smaller are stored: 5 bytes for each 64 KiB, of which a block of tokens may begin
  // anew; then header and check of the stream, a code table.
  static std::size_t bound(std::size_t bytes) { return bytes + bytes / 64 + 1024; }

  isal_zstream stream_{};
  Buffer work_, packed_;
};

class SmallPacker final : public Packer {
 public:
  SmallPacker() : compressor_(libdeflate_alloc_compressor(kLevel)) {
    if (!compressor_) throw std::bad_alloc();
  }

  std::span<const std::uint8_t> pack(std::span<const std::uint8_t> bytes) override {
    const std::size_t room = libdeflate_zlib_compress_bound(compressor_.get(), bytes.size());
    std::uint8_t* packed = packed_.at_least(room);
    return {packed, libdeflate_zlib_compress(compressor_.get(), bytes.data(), bytes.size(), packed, room)};
  }

 private:
  static constexpr int kLevel = 10;

  struct Free {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  Buffer packed_;
};

}  // namespace

std::unique_ptr<Packer> make_packer(PngPacking packing) {
  if (packing == PngPacking::fast) return std::make_unique<FastPacker>();
  return std::make_unique<SmallPacker>();
}

}  // namespace polhode
