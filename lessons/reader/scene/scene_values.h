// SPDX-License-Identifier: MIT
// The values of a scene's keys as TOML that reads back as the same bits.
#pragma once

#include "render/scene/description/scene.h"

#include <string>
#include <vector>

namespace polhode {

/// w, x, y, z relative to the largest of them, with 12 decimals.
std::vector<double> wxyz_in_short(const Quat& q_SB);

std::string text_of(const AttitudeSpec& attitude);
std::string text_of(const Torque& torque);
std::string text_of(ArrowHeld arrow);
std::string text_of(const MotionSpec& motion);
std::string text_of(const std::vector<View>& views);
std::string text_of(const OverlaySet& shown);
std::string text_of(const CameraSpec& camera);
std::string text_of(const ComparedMethods& compared);

}  // namespace polhode
