// SPDX-License-Identifier: MIT
// What the goldens share: one renderer for the process, and the comparison with what was approved.
#pragma once

#include "render/gl/renderer.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polhode::golden {

inline const std::filesystem::path kFolder = std::filesystem::path(POLHODE_SOURCE_DIR) / "tests/golden";

/// One for all tests of this process: shaders compile once. CMake sets GALLIUM_OVERRIDE_CPU_CAPS=sse4.1,
/// which puts every x86 machine into one class of pixels.
Renderer& renderer();
/// What it draws in.
const GlContext& context();

/// A transparent picture as it shows on a violet slide. Straight colours of nearly transparent pixels say
/// little: a rounding of one level at alpha 2 changes them by 127.
void lay_over_violet(Image& image);

/// By the golden rule. POLHODE_REMAKE="name name ..." (or "all") rewrites goldens instead of comparing them.
void expect_as_approved(const std::string& name, const Image& got);

/// Names of the goldens of page_golden_test.cpp.
std::vector<std::string> page_names();
/// And of board_golden_test.cpp.
std::vector<std::string> board_names();
/// And of window_golden_test.cpp.
std::vector<std::string> window_names();

}  // namespace polhode::golden
