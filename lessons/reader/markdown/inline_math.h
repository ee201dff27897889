// SPDX-License-Identifier: MIT
// Where formulas stand in Markdown.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/markdown/located_text.h"

#include <vector>

namespace polhode {

/// The TeX between single `$`, which are not counted in. A formula does not leave its paragraph; code spans
/// and `\$` hold none. Reports display mathematics, and warns of a `$` without partner and of dollars that
/// were not meant as mathematics: they stay text. Linear but for code spans that never close.
std::vector<SourceSpan> find_inline_math(const LocatedText& markdown, Report& report);

}  // namespace polhode
