// SPDX-License-Identifier: MIT
// One formula turns into another: what both have travels, the rest fades.
#pragma once

#include "render/typeset/display_list.h"

namespace polhode {

/// The list on its way from `from` (u = 0) to `to` (u = 1), which it is exactly at both ends. Glyphs are
/// matched by a longest common subsequence in reading order, in which those of the same term or symbol count
/// more; rules likewise by their direction. What is matched moves, and changes size and colour, in proportion
/// to u; what goes fades in the first half, what comes appears in the second. Pure. Quadratic in the number
/// of glyphs that differ; beyond 2000 of them nothing between common beginning and end is matched.
/// @param u is clamped to [0, 1]
DisplayList morph(const DisplayList& from, const DisplayList& to, double u);

}  // namespace polhode
