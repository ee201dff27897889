// SPDX-License-Identifier: MIT
// How large the window was when it was closed last, and where: window.json in the state folder
// (app/session/saved/state_file.h).
#pragma once

#include "app/session/saved/state_file.h"
#include "render/image/image.h"

#include <array>
#include <filesystem>
#include <optional>

namespace polhode {

struct WindowPlace {
  Size size{};                                ///< empty: not known
  std::optional<std::array<int, 2>> at = {};  ///< its upper left corner on the desktop; nothing: not known
  bool operator==(const WindowPlace&) const = default;
};

/// Fails as read_state_file.
StateFileResult<WindowPlace> read_window_place(const std::filesystem::path& folder);
/// As write_state_file.
StateFileResult<std::monostate> write_window_place(const std::filesystem::path& folder,
                                                   const WindowPlace& place);

/// Where a window is put back that stood at `at` without its frame, on a screen whose bars leave it from
/// `corner` on: its title bar, `frame` to the left and above, is on the screen, so that it can be moved.
std::array<int, 2> with_frame_seen(std::array<int, 2> at, std::array<int, 2> corner,
                                   std::array<int, 2> frame);

}  // namespace polhode
