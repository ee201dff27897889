// SPDX-License-Identifier: MIT
// Characters of texts in UTF-8 (RFC 3629: no overlong forms, no surrogates).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

inline constexpr char32_t kMalformed = 0xFFFFFFFF;

/// The character at `at` < text.size(); `at` moves behind it. kMalformed for a byte that begins none; one
/// byte is passed then.
char32_t next_character(std::string_view text, std::size_t& at);

void append_utf8(std::string& text, char32_t character);

/// False for the bytes that go on with a character.
constexpr bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

/// Characters of a well-formed text.
int count_characters(std::string_view utf8);

/// All of them; U+FFFD for each byte that is none's.
std::u32string code_points(std::string_view utf8);

}  // namespace polhode
