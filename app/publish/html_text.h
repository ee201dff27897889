// SPDX-License-Identifier: MIT
// Texts and bytes as HTML takes them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// For text and for attributes in double quotes: & < > " ' become references, so no text can end either.
/// Control characters, which HTML does not have, become blanks.
std::string html_escaped(std::string_view utf8);

/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

/// `'sha256-…'`: what a Content-Security-Policy knows an inline script or style by.
std::string policy_hash(std::string_view text);

}  // namespace polhode
