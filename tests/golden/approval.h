// SPDX-License-Identifier: MIT
// What the goldens share: one renderer for the process, and the comparison with what was approved.
#pragma once

#include "render/gl/renderer.h"
#include "render/image/compare.h"

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

/// "Mesa 22.3.6" of "llvmpipe (LLVM 15.0.6, 128 bits); 4.5 (Core Profile) Mesa 22.3.6".
std::string mesa_of(const std::string& driver);

/// Another Mesa than that of DRIVER rounds a few pixels otherwise: a golden may then be off by so much in its
/// worst pixel, while no more pixels may be off. Measured on all goldens, drawn by Mesa 25.0.7 (Debian 13)
/// against those of 22.3.6: 10 of 129,600 pixels of two-orders-of-turning are off by up to 78 levels, where
/// an arrow's edge comes and goes; of the others none is off by more than 48.
inline constexpr int kOtherMesaMax = 2 * kGoldenMax;

/// By the golden rule, or by that with kOtherMesaMax.
bool is_as_approved(const Comparison& comparison, bool by_other_mesa);

/// By the wider of the two rules: what a mutation must do to a picture, so that no machine takes it for the
/// approved one.
bool is_refused(const Image& approved, const Image& mutated);

enum class Remake { no, yes, refused };
/// What POLHODE_REMAKE="name name ..." (or "all") says of a golden. By another Mesa all goldens are remade or
/// none: a few among those of the Mesa that DRIVER names would be compared by the wrong rule.
Remake remake_of(const std::string& name, const std::string& asked, bool by_other_mesa);

/// Compares, or remakes if POLHODE_REMAKE says so.
void expect_as_approved(const std::string& name, const Image& got);

/// Names of the goldens of page_golden_test.cpp.
std::vector<std::string> page_names();
/// And of board_golden_test.cpp.
std::vector<std::string> board_names();
/// And of window_golden_test.cpp.
std::vector<std::string> window_names();

}  // namespace polhode::golden
