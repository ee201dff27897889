// SPDX-License-Identifier: MIT
// TeX as far as a reader needs it: do its braces close, which tags and terms does it name. Typesetting is
// render/type.
#pragma once

#include "lessons/keys.h"
#include "lessons/report.h"

#include <string_view>
#include <vector>

namespace polhode {

/// Braces, \left and \begin nest at most so deep.
inline constexpr std::size_t kMaxMathNesting = 64;

struct MathNames {
  std::vector<PlacedText> tags;   ///< of \tag{…}
  std::vector<PlacedText> terms;  ///< ids of \term{id}{…}
};

/// Reports braces, \left \right and \begin \end without their partner or too deep, and bad ids of terms.
/// `start` is the place of the first byte of `tex`. Linear.
MathNames read_math(std::string_view tex, SourcePlace start, Report& report);

/// Reports what is wrong with the $…$ in Markdown: display mathematics, a $ without its partner, dollars that
/// were not meant as mathematics, and what read_math reports. Linear.
void check_inline_math(std::string_view markdown, SourcePlace start, Report& report);

}  // namespace polhode
