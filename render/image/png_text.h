// SPDX-License-Identifier: MIT
// Internal to render/image/: what PNG text may be, its two encodings, and its unit of resolution.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace polhode {

inline constexpr double kMetresPerInch = 0.0254;  ///< pHYs counts pixels per metre

/// Why `keyword` cannot be a PNG keyword (1–79 printable ASCII characters, no space at either end, no two
/// together); nothing if it can. (PNG allows Latin-1; no keyword in use needs it.)
std::optional<std::string> keyword_error(std::string_view keyword);

/// UTF-8 in Latin-1; nothing if a character has no place there, or is a control character other than a new
/// line.
std::optional<std::string> latin1_from_utf8(std::string_view text);
std::string utf8_from_latin1(std::string_view text);

/// Well-formed UTF-8 without U+0000.
bool is_png_utf8(std::string_view text);

}  // namespace polhode
