// SPDX-License-Identifier: MIT
#include "tests/render/image/crafted_png.h"

#include <gtest/gtest.h>
#include <zlib.h>

namespace polhode::test {

using Bytes = std::vector<std::uint8_t>;

void put32(Bytes& bytes, std::size_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

Bytes chunk(const char* type, const Bytes& data) {
  Bytes bytes;
  put32(bytes, data.size());
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(type[i]));
  bytes.insert(bytes.end(), data.begin(), data.end());
  put32(bytes, crc32(0, &bytes[4], static_cast<uInt>(bytes.size() - 4)));
  return bytes;
}

Bytes header(std::size_t width, std::size_t height, std::uint8_t depth, std::uint8_t color,
             std::uint8_t interlace) {
  Bytes data;
  put32(data, width);
  put32(data, height);
  for (const std::uint8_t byte : {depth, color, std::uint8_t{0}, std::uint8_t{0}, interlace})
    data.push_back(byte);
  return chunk("IHDR", data);
}

Bytes deflated(const Bytes& data) {
  uLongf size = compressBound(data.size());
  Bytes bytes(size);
  EXPECT_EQ(compress2(bytes.data(), &size, data.data(), data.size(), 9), Z_OK);
  bytes.resize(size);
  return bytes;
}

Bytes png_of(const std::vector<Bytes>& chunks) {
  Bytes bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  for (const Bytes& c : chunks) bytes.insert(bytes.end(), c.begin(), c.end());
  return bytes;
}

}  // namespace polhode::test
