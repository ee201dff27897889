// SPDX-License-Identifier: MIT
// What the goldens share: one renderer for the process, and the comparison with what was approved.
#pragma once

#include "render/gl/renderer.h"
#include "tests/support/paths.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polhode::golden {

inline const std::filesystem::path kFolder = test::source_dir() / "tests/golden";

/// One for all tests of this process: shaders compile once. Unless the environment has another, it sets
/// GALLIUM_OVERRIDE_CPU_CAPS=sse4.1, which puts every x86 machine into one class of pixels.
Renderer& renderer();
/// What it draws in.
const GlContext& context();

/// A transparent picture as it shows on a violet slide. Straight colours of nearly transparent pixels say
/// little: a rounding of one level at alpha 2 changes them by 127.
void lay_over_violet(Image& image);

/// "Mesa 22.3.6" of "llvmpipe (LLVM 15.0.6, 128 bits); 4.5 (Core Profile) Mesa 22.3.6".
std::string mesa_of(const std::string& driver);

enum class Remake { no, yes, refused };
/// What POLHODE_REMAKE="name name ..." (or "all") says of a golden. By another Mesa than that of DRIVER all
/// goldens are remade or none, so that DRIVER names what drew every one of them.
Remake remake_of(const std::string& name, const std::string& asked, bool by_other_mesa);

/// Compares by the golden rule, whatever Mesa drew, or remakes if POLHODE_REMAKE says so. Measured on all
/// goldens, drawn by Mesa 25.0.7 (Debian 13) and by 26.2.6 (sid) against those of 22.3.6: at most 10 of
/// 129,600 pixels are off by more than 3 levels, none by more than 41 of the 48 allowed. With registers of
/// 256 bits it would be 78, by every Mesa alike.
void expect_as_approved(const std::string& name, const Image& got,
                        const std::filesystem::path& folder = kFolder);

/// Names of the goldens of page_golden_test.cpp.
std::vector<std::string> page_names();
/// And of diagram_golden_test.cpp.
std::vector<std::string> diagram_names();
/// And of window_golden_test.cpp.
std::vector<std::string> window_names();

}  // namespace polhode::golden
