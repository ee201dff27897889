// SPDX-License-Identifier: MIT
#include "app/session/saved/window_place.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace polhode {

namespace {

constexpr int kMost = 16384;  // px: no screen is wider

std::filesystem::path path_in(const std::filesystem::path& folder) { return folder / "window.json"; }

}  // namespace

StateFileResult<WindowPlace> read_window_place(const std::filesystem::path& folder) {
  WindowPlace place;
  const auto warning =
      read_state_file(path_in(folder), "the place of the window", [&](const nlohmann::ordered_json& json) {
        place.size = {std::clamp(json.at("width").get<int>(), 0, kMost),
                      std::clamp(json.at("height").get<int>(), 0, kMost)};
        if (json.contains("at")) place.at = json.at("at").get<std::array<int, 2>>();
      });
  if (!warning) return Failure{warning.error()};
  return warning->empty() ? place : WindowPlace{};
}

std::array<int, 2> with_frame_seen(std::array<int, 2> at, std::array<int, 2> corner,
                                   std::array<int, 2> frame) {
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = std::max(at[i], corner[i] + frame[i]);
  return at;
}

StateFileResult<std::monostate> write_window_place(const std::filesystem::path& folder,
                                                   const WindowPlace& place) {
  nlohmann::ordered_json json = {{"width", place.size.width}, {"height", place.size.height}};
  if (place.at) json["at"] = *place.at;
  return write_state_file(path_in(folder), json);
}

}  // namespace polhode
