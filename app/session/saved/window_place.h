// SPDX-License-Identifier: MIT
// How large the window was when it was closed last: window.json in the state folder
// (app/session/saved/state_file.h).
#pragma once

#include "app/session/saved/state_file.h"
#include "render/image/image.h"

#include <filesystem>

namespace polhode {

/// Empty where nothing is known. Fails as read_state_file.
StateFileResult<Size> read_window_size(const std::filesystem::path& folder);
/// As write_state_file.
StateFileResult<std::monostate> write_window_size(const std::filesystem::path& folder, Size size);

}  // namespace polhode
