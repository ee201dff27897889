// SPDX-License-Identifier: MIT
// Curves on a glass ellipsoid, near side and far side told apart. No GL calls; internal to render/gl.
#pragma once

#include "render/figure/draw_list.h"

#include <vector>

namespace polhode {

/// The tubes of a list, those that lie on one of its ellipsoids cut where they pass its outline as the eye
/// sees it: what lies beyond, on the far side, is fainter and thinner. Others are as they were.
std::vector<Tube> with_faint_far_sides(const DrawList& list, const Vec3& eye);

}  // namespace polhode
