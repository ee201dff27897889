// SPDX-License-Identifier: MIT
// The keys `camera` and `attitude` of a scene.
#pragma once

#include "lessons/reader/front_matter/keys.h"
#include "render/scene/description/scene.h"

#include <optional>

namespace polhode {

/// Angles in degrees. Nothing, and a report: it is no table.
std::optional<CameraSpec> read_camera(const TomlEntry& entry, Report& report);

/// "L-down", "L-up" or a quaternion. Nothing, and a report: it is none of them.
std::optional<AttitudeSpec> read_attitude(const TomlEntry& entry, Report& report);

}  // namespace polhode
