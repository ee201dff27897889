// SPDX-License-Identifier: MIT
// The keys of a scene that choose methods: how its motion is computed, and which methods are compared.
#pragma once

#include "lessons/reader/front_matter/keys.h"
#include "render/scene/description/scene.h"

#include <optional>

namespace polhode {

/// `motion`: the name of a method, or a table of method, step, tolerance and ghost. What does not go together
/// is reported; the rest is as it is written.
MotionSpec read_motion(const TomlEntry& entry, Report& report);

/// `compare`: a table of methods and what their errors are drawn against. Nothing, and a report: it is none.
std::optional<ComparedMethods> read_compared(const TomlEntry& entry, Report& report);

}  // namespace polhode
