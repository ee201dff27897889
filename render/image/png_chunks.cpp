// SPDX-License-Identifier: MIT
#include "render/image/png_chunks.h"

#include "render/image/png.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>

namespace polhode {

namespace {

constexpr std::array<std::uint8_t, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kLengthBytes = 4, kTypeBytes = 4, kCheckBytes = 4;
constexpr std::size_t kHeaderBytes = 13;

std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (const std::uint8_t byte : bytes.subspan(at, 4)) number = number << 8 | byte;
  return number;
}

// Takes the first chunk off `rest`; false if it is not whole.
bool take_chunk(std::span<const std::uint8_t>& rest, PngChunk& chunk) {
  constexpr std::size_t kAround = kLengthBytes + kTypeBytes + kCheckBytes;
  if (rest.size() < kAround) return false;
  const std::size_t length = number_at(rest, 0);
  if (length > rest.size() - kAround) return false;
  const auto checked = rest.subspan(kLengthBytes, kTypeBytes + length);
  const auto sum = crc32(0, checked.data(), static_cast<uInt>(checked.size()));
  if (sum != number_at(rest, kLengthBytes + checked.size())) return false;
  chunk.type = {reinterpret_cast<const char*>(checked.data()), kTypeBytes};
  chunk.data = checked.subspan(kTypeBytes);
  rest = rest.subspan(kAround + length);
  return true;
}

bool read_header(const PngChunk& chunk, PngHeader& header) {
  if (chunk.type != "IHDR" || chunk.data.size() != kHeaderBytes) return false;
  const std::uint32_t width = number_at(chunk.data, 0), height = number_at(chunk.data, 4);
  const std::uint32_t most = kMaxPngSide;
  if (width < 1 || height < 1 || width > most || height > most) return false;
  header.size = {static_cast<int>(width), static_cast<int>(height)};
  header.bit_depth = chunk.data[8];
  header.color_type = chunk.data[9];
  header.interlaced = chunk.data[12] != 0;
  return true;
}

}  // namespace

Result<PngChunks> read_png_chunks(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kSignature.size() || !std::equal(kSignature.begin(), kSignature.end(), bytes.begin()))
    return failure("it is not a PNG");
  auto rest = bytes.subspan(kSignature.size());
  PngChunks png;
  PngChunk chunk;
  while (chunk.type != "IEND") {
    if (!take_chunk(rest, chunk))
      return failure("it is truncated or damaged after " + std::to_string(bytes.size() - rest.size()) +
                     " bytes");
    png.chunks.push_back(chunk);
  }
  if (!rest.empty()) return failure("it goes on after its end");
  if (!read_header(png.chunks.front(), png.header)) return failure("its header is not that of a picture");
  return png;
}

}  // namespace polhode
