// SPDX-License-Identifier: MIT
// What stands in a line of Markdown that Markdown does not know: formulas, marks of footnotes, citations.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/markdown/located_text.h"

#include <string_view>
#include <vector>

namespace polhode {

/// How the mark of a footnote opens, and a citation; both end with `]`.
inline constexpr std::string_view kNoteOpening = "[^";
inline constexpr std::string_view kCitationOpening = "[cite:";

struct InlineMark {
  enum class Kind { formula, note, citation } kind = Kind::formula;
  SourceSpan whole;   ///< with `$`, `[^`, `[cite:` and what closes it
  SourceSpan inside;  ///< without them
};

/// `$TeX$`, `[^id]` and `[cite: KEY, where]`, in their order. None leaves its paragraph; code spans hold
/// none, nor is one what follows a backslash. Reports display mathematics, and warns of a `$` without partner
/// and of dollars that were not meant as mathematics: they stay text. Linear but for code spans that never
/// close.
std::vector<InlineMark> find_inline_marks(const LocatedText& markdown, Report& report);

}  // namespace polhode
