// SPDX-License-Identifier: MIT
#include "base/vectors.h"

namespace polhode {

Quat shortest_rotation(const Vec3& from, const Vec3& to) { return Quat::FromTwoVectors(from, to); }

}  // namespace polhode
