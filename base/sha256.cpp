// SPDX-License-Identifier: MIT
#include "base/sha256.h"

#include <sha256.h>
#include <sys/types.h>

#include <array>

namespace polhode {

std::string sha256_hex(std::string_view text) {
  return sha256_hex(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string sha256_hex(std::span<const std::uint8_t> bytes) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digest{};
  SHA256Data(bytes.data(), bytes.size(), digest.data());
  return digest.data();
}

}  // namespace polhode
