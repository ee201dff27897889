// SPDX-License-Identifier: MIT
// PNG files put together by hand, with every check sum right and anything else wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace polhode::test {

/// Appends four bytes, the highest first.
void put32(std::vector<std::uint8_t>& bytes, std::size_t value);
/// Length, type, data, CRC.
std::vector<std::uint8_t> chunk(const char* type, const std::vector<std::uint8_t>& data);
/// IHDR.
std::vector<std::uint8_t> header(std::size_t width, std::size_t height, std::uint8_t depth,
                                 std::uint8_t color, std::uint8_t interlace);
/// A whole zlib stream.
std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& data);
/// The signature and these.
std::vector<std::uint8_t> png_of(const std::vector<std::vector<std::uint8_t>>& chunks);

}  // namespace polhode::test
