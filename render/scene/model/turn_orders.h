// SPDX-License-Identifier: MIT
// Two quarter turns about axes fixed in space, in both orders: finite rotations do not commute.
#pragma once

#include "base/words/phrase.h"
#include "physics/body/types.h"

#include <array>

namespace polhode {

enum class TurnOrder { x_then_y, y_then_x };
inline constexpr std::array kTurnOrders = {TurnOrder::x_then_y, TurnOrder::y_then_x};

/// One of the two turns on its way.
struct Turn {
  Vec3 axis_S;  ///< e_x or e_y
  double angle_rad;
};

struct TurnedBody {
  Quat q_SB;     ///< attitude now
  Turn present;  ///< the turn that goes on, or went last
};

/// At `progress` of both turns together: before 0 the attitude at the start, in the first half the first
/// turn, then the second, from 1 on both. Each starts and ends gently.
TurnedBody turned(TurnOrder order, const Quat& q0_SB, double progress);

/// "first $x$, then $y$"
Phrase title_of(TurnOrder order);

}  // namespace polhode
