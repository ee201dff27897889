// SPDX-License-Identifier: MIT
// The motion a trace follows: by the method asked for, or by the best one there is.
#pragma once

#include "physics/method.h"
#include "render/scene/description/scene.h"

#include <memory>
#include <optional>
#include <string>

namespace polhode {

/// --method, --step and --tolerance as typed; empty where not given.
struct TypedMethod {
  std::string method, step, tolerance;
};

struct TracedMotion {
  std::unique_ptr<const Motion> motion;
  std::string note;  ///< what the user did not ask for but should know; may be empty
};

/// @throws CommandError usage: unknown (with "did you mean"), or it cannot serve (naming those that can)
Method serving_method(const Problem& problem, const std::string& name);

/// The default_method unless one is named.
/// @throws CommandError as serving_method; usage: a step missing, a step or tolerance without use or not > 0;
/// invalid: not finite
MethodChoice method_choice(const Problem& problem, const TypedMethod& typed);

TracedMotion traced_motion(const Problem& problem, const TypedMethod& typed);

/// The same for a scene: as it says, unless something is typed.
TracedMotion traced_motion(const Problem& problem, const TypedMethod& typed, const MotionSpec& spec);

}  // namespace polhode
