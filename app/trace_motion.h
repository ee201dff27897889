// SPDX-License-Identifier: MIT
// The motion a trace follows: by the method asked for, or by the best one there is.
#pragma once

#include "physics/motion.h"
#include "physics/principal_moments.h"
#include "physics/torque.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

struct TracedBody {
  PrincipalMoments I;
  RigidBodyState start;
  Torque torque;
};

struct TracedMotion {
  std::unique_ptr<const Motion> motion;
  std::string note;                  ///< what the user did not ask for but should know; may be empty
  std::optional<double> max_time_s;  ///< beyond it nothing is computed
};

/// Names of the methods that can serve this body and torque.
std::vector<std::string> serving_methods(const TracedBody& body);

/// Period of the polhode; nothing with torque, in steady rotation and on a separatrix.
std::optional<double> period_s(const TracedBody& body);
/// What --periods counts: the polhode period, or 2π/|ω₀|; 0 for a body at rest.
double counted_period_s(const TracedBody& body);

/// @param method empty: the closed form if there is one, else rk4 with 2000 steps to the polhode period or to
/// a turn, whichever is shorter.
/// @throws CommandError usage: unknown method, one that cannot serve (naming those that can), a step missing
/// or without use; invalid: a step or state that cannot be
TracedMotion traced_motion(const TracedBody& body, const std::string& method, std::optional<double> step_s);

}  // namespace polhode
