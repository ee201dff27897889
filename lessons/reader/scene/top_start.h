// SPDX-License-Identifier: MIT
// The key `start` of a scene: how a top is set going, in the words in which it is taught.
#pragma once

#include "base/result.h"
#include "lessons/reader/front_matter/keys.h"
#include "physics/body/problem.h"

#include <optional>
#include <string>
#include <variant>

namespace polhode {

enum class SteadyRoot { slow, fast };

/// Euler's angles z-x-z (physics/body/euler_angles.h) with θ̇ = 0.
struct TopStart {
  double theta_deg = 0;  ///< 0 to 180
  double phi_deg = 0, psi_deg = 0;
  double spin = 0;                                    ///< ω3, rad/s
  std::variant<double, SteadyRoot> precession = 0.0;  ///< φ̇, rad/s, or that of a steady precession
};

/// Nothing if something is wrong with it, which is reported.
std::optional<TopStart> read_top_start(const TomlEntry& entry, Report& report);

/// Why a scene cannot be as its keys say, and what to write instead.
struct SceneFault {
  std::string message, hint;
};

/// ω and the attitude that a start stands for, of a body with these moments (about the pivot) under this
/// torque. The attitude is one that a lesson can state. A steady precession is that of the HeavyTops in the
/// torque alone (physics/analysis/symmetric_top.h).
Result<RigidBodyState, SceneFault> state_of(const TopStart& start, const PrincipalMoments& I,
                                            const Torque& torque);

}  // namespace polhode
