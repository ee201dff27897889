// SPDX-License-Identifier: MIT
// The arrow A of the transport theorem, dA/dt = d*A/dt + ω×A: a vector that is fixed in space, fixed in the
// body, or moves in both, as Scene::arrow says. It has the length 1 (free: 0.8 to 1.2) and no unit.
#pragma once

#include "render/scene/model/model.h"

namespace polhode {

/// A in space. At t = 0 all three are the same; free: it turns about an axis fixed in space at 0.7|ω₀| while
/// its length swings by a fifth.
Vec3 arrow_A_S(const SceneModel& model, double t_s);
/// The same for an attitude that is known: that of the motion at t.
Vec3 arrow_A_S(const SceneModel& model, double t_s, const Quat& q_SB);

/// Both derivatives of A, 1/s, space components. Each is a difference quotient in its own frame
/// (derivative_at): the first of the components of A in S, the second of those in S*. That the third term
/// joins them is for the picture to show; it closes to some 1e-12 |ω|.
struct ArrowRates {
  Vec3 A_S;
  Vec3 rate_S;       ///< dA/dt
  Vec3 star_rate_S;  ///< d*A/dt
  Vec3 turning_S;    ///< ω×A
};
ArrowRates arrow_rates(const SceneModel& model, double t_s);

}  // namespace polhode
