// SPDX-License-Identifier: MIT
// What ./web has built, for tests that need it: in build/web/, or in $POLHODE_WEB.
#pragma once

#include "tests/support/paths.h"

#include <cstdlib>
#include <filesystem>

namespace polhode {

inline std::filesystem::path web_folder() {
  const char* chosen = std::getenv("POLHODE_WEB");
  return chosen && *chosen ? std::filesystem::path(chosen) : test::source_dir() / "build" / "web";
}

inline bool has_web_program() { return std::filesystem::exists(web_folder() / "polhode.wasm"); }

}  // namespace polhode
