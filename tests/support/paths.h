// SPDX-License-Identifier: MIT
// Where this checkout and its program are, for tests that read files or start it. Functions, so that one file
// alone is compiled with these paths: ccache(1) finds all others in what another clone has compiled.
#pragma once

#include <filesystem>

namespace polhode::test {

/// The checkout.
std::filesystem::path source_dir();

/// The program that was built, `polhode`; empty where only the physics is.
std::filesystem::path program();

}  // namespace polhode::test
