// SPDX-License-Identifier: MIT
// Texts and bytes as HTML takes them.
#pragma once

#include "base/words/language.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// What base/markup.h calls escaped: for text and for attributes in double quotes.
std::string html_escaped(std::string_view utf8);

/// ` lang="en"` of what is in another language than its page; else nothing.
std::string lang_of(Language language, Language of_page);

/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

/// `'sha256-…'`: what a Content-Security-Policy knows an inline script or style by.
std::string policy_hash(std::string_view text);

}  // namespace polhode
