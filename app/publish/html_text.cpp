// SPDX-License-Identifier: MIT
#include "app/publish/html_text.h"

#include "base/markup.h"
#include "base/sha256.h"

#include <vector>

namespace polhode {

std::string html_escaped(std::string_view utf8) { return escaped(utf8); }

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string policy_hash(std::string_view text) {
  const std::string hex = sha256_hex(text);
  std::vector<std::uint8_t> digest;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    digest.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return "'sha256-" + base64(digest) + "'";
}

std::string lang_of(Language language, Language of_page) {
  return language == of_page ? "" : " lang=\"" + std::string(tag_of(language)) + '"';
}

}  // namespace polhode
