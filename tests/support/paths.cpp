// SPDX-License-Identifier: MIT
#include "tests/support/paths.h"

namespace polhode::test {

std::filesystem::path source_dir() { return POLHODE_SOURCE_DIR; }

std::filesystem::path program() { return POLHODE_PROGRAM; }

}  // namespace polhode::test
