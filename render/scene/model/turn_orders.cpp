// SPDX-License-Identifier: MIT
#include "render/scene/model/turn_orders.h"

#include "base/words/figure_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

/// 0 to 1 with no velocity at the ends, and a rest between one turn and the next.
double eased(double part) {
  constexpr double kRest = 0.12;
  const double x = std::clamp((part - kRest) / (1.0 - 2.0 * kRest), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

Quat rotation(const Turn& turn) { return Quat(Eigen::AngleAxisd(turn.angle_rad, turn.axis_S)); }

}  // namespace

TurnedBody turned(TurnOrder order, const Quat& q0_SB, double progress) {
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  const bool x_first = order == TurnOrder::x_then_y;
  const Turn first{x_first ? Vec3::UnitX() : Vec3::UnitY(), kQuarter * eased(2.0 * progress)};
  const Turn second{x_first ? Vec3::UnitY() : Vec3::UnitX(), kQuarter * eased(2.0 * progress - 1.0)};
  return {rotation(second) * rotation(first) * q0_SB, progress < 0.5 ? first : second};
}

Phrase title_of(TurnOrder order) {
  return order == TurnOrder::x_then_y ? words::kFirstXThenY : words::kFirstYThenX;
}

}  // namespace polhode
