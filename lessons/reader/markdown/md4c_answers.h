// SPDX-License-Identifier: MIT
// What a callback of md4c answers. Internal to lessons/reader/markdown/.
#pragma once

namespace polhode {

/// Ends the reading. A positive answer is lost on its way out of md4c.
inline constexpr int kStop = -1;

}  // namespace polhode
