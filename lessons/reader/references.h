// SPDX-License-Identifier: MIT
// Links of a lesson's texts and \eqref of its formulas: whether there is what they lead to, and what they
// show.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/lesson.h"

#include <vector>

namespace polhode {

/// What all links without a text of their own show, together: a title may be long, and shown often.
inline constexpr std::size_t kMaxShownReferenceBytes = std::size_t{1} << 16;

/// Every link leads to an address of the web, "#stage", "#equation" of the stage it stands in,
/// "#stage/equation", "lesson#stage" or "lesson#stage/equation"; what it leads to within the lesson is
/// written as "#stage" or
/// "#stage/equation" afterwards. A link without text shows the number of the equation, or the title of the
/// stage; \eqref{equation}, or {stage/equation}, the number. Where a stage and an equation have one id, a
/// link means the stage. What is unknown is reported where it stands.
/// @return where the lesson refers to other lessons, of which nothing is known here
std::vector<OutsideReference> resolve_references(std::vector<Stage>& stages, Report& report);

}  // namespace polhode
