// SPDX-License-Identifier: MIT
// Disks that fail, for programs that are started (failing_files.cpp).
#pragma once

#include <string>

namespace polhode {

/// The library to preload.
std::string failing_files();

}  // namespace polhode
