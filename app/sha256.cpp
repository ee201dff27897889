// SPDX-License-Identifier: MIT
#include "app/sha256.h"

#include <sha256.h>
#include <sys/types.h>

#include <array>
#include <cstdint>

namespace polhode {

std::string sha256_hex(std::string_view text) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digest{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), digest.data());
  return digest.data();
}

}  // namespace polhode
