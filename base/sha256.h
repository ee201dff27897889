// SPDX-License-Identifier: MIT
// SHA-256 of a lesson's text and of files, for manifests.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// 64 lower-case hexadecimal digits (FIPS 180-4), as sha256sum prints them.
std::string sha256_hex(std::string_view text);
std::string sha256_hex(std::span<const std::uint8_t> bytes);

}  // namespace polhode
