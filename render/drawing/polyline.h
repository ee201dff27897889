// SPDX-License-Identifier: MIT
// Lines through many points, with fewer of them.
#pragma once

#include "render/drawing/sheet.h"

#include <vector>

namespace polhode {

/// Some of the points, the first and the last among them, such that no point left out lies further than
/// `tolerance` from the line through the others near it (U. Ramer 1972; D. H. Douglas & T. K. Peucker,
/// "Algorithms for the reduction of the number of points required to represent a digitized line", The
/// Canadian Cartographer 10 (1973) 112-122). Quadratic in the number of points at worst, for noise; else n
/// log n.
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance);

}  // namespace polhode
