// SPDX-License-Identifier: MIT
#include "render/image/packer.h"

#include <libdeflate.h>

#include <new>

namespace polhode {
namespace {

constexpr int level_of(PngPacking packing) { return packing == PngPacking::fast ? 1 : 10; }

}  // namespace

struct Packer::Free {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

struct Packer::State {
  std::unique_ptr<libdeflate_compressor, Free> compressor;
  Buffer packed;
};

Packer::Packer(PngPacking packing) : state_(std::make_unique<State>()) {
  state_->compressor.reset(libdeflate_alloc_compressor(level_of(packing)));
  if (!state_->compressor) throw std::bad_alloc();
}
Packer::~Packer() = default;

std::span<const std::uint8_t> Packer::pack(std::span<const std::uint8_t> bytes) {
  libdeflate_compressor* compressor = state_->compressor.get();
  const std::size_t room = libdeflate_zlib_compress_bound(compressor, bytes.size());
  std::uint8_t* packed = state_->packed.at_least(room);
  return {packed, libdeflate_zlib_compress(compressor, bytes.data(), bytes.size(), packed, room)};
}

}  // namespace polhode
