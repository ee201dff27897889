// SPDX-License-Identifier: MIT
// What a picture's PNG file says of itself.
#pragma once

#include "lessons/reader/lesson.h"
#include "render/image/png.h"

#include <optional>
#include <string>

namespace polhode {

/// "polhode 0.1.0"
std::string program_name_and_version();

/// Title, Description (the alt text), Software, polhode:lesson, polhode:stage, polhode:t if it has one; each
/// Author of the lesson, and its licence as Copyright; no time stamp.
PngMetadata picture_metadata(const Lesson& lesson, const Stage& stage, const std::string& alt,
                             const std::optional<double>& t_s, int dpi);

}  // namespace polhode
