// SPDX-License-Identifier: MIT
#include "app/session/saved/window_size.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace polhode {

namespace {

constexpr int kMost = 16384;  // px: no screen is wider

std::filesystem::path path_in(const std::filesystem::path& folder) { return folder / "window.json"; }

}  // namespace

StateFileResult<Size> read_window_size(const std::filesystem::path& folder) {
  Size size;
  const auto warning =
      read_state_file(path_in(folder), "the size of the window", [&](const nlohmann::ordered_json& json) {
        size = {std::clamp(json.at("width").get<int>(), 0, kMost),
                std::clamp(json.at("height").get<int>(), 0, kMost)};
      });
  if (!warning) return Failure{warning.error()};
  return warning->empty() ? size : Size{};
}

StateFileResult<std::monostate> write_window_size(const std::filesystem::path& folder, Size size) {
  return write_state_file(path_in(folder), {{"width", size.width}, {"height", size.height}});
}

}  // namespace polhode
