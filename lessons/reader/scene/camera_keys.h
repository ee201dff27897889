// SPDX-License-Identifier: MIT
// The key `camera` of a scene.
#pragma once

#include "lessons/reader/front_matter/keys.h"
#include "render/scene/description/scene.h"

#include <optional>

namespace polhode {

/// Angles in degrees. Nothing, and a report: it is no table.
std::optional<CameraSpec> read_camera(const TomlEntry& entry, Report& report);

}  // namespace polhode
