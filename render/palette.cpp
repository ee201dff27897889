// SPDX-License-Identifier: MIT
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {

std::optional<Role> role_from(std::string_view name) {
  if (name == "omega") return kOmegaRole;
  if (name == "L") return kLRole;
  if (name == "N") return kNRole;
  if (name == "polhode") return kPolhodeRole;
  if (name == "herpolhode") return kHerpolhodeRole;
  if (name == "axes") return kAxesRole;
  if (name == "axis-1" || name == "axis-2" || name == "axis-3")
    return kBodyAxisRoles[static_cast<std::size_t>(name.back() - '1')];
  constexpr std::array<std::string_view, kMarkRoles.size()> kOfMarks = {"violet", "brown", "crimson",
                                                                        "black"};
  for (std::size_t i = 0; i < kMarkRoles.size(); ++i)
    if (name == kOfMarks[i]) return kMarkRoles[i];
  return std::nullopt;
}

bool is_dark(const Color& paper) { return 0.3F * paper.r + 0.6F * paper.g + 0.1F * paper.b <= 0.5F; }

Color on_dark(const Color& color) {
  constexpr float kBrightest = 0.94F, kTowardsWhite = 0.30F;
  const float scale = kBrightest / std::max({color.r, color.g, color.b, 0.1F});
  const auto lighter = [&](float c) { return std::lerp(c * scale, 1.0F, kTowardsWhite); };
  return {lighter(color.r), lighter(color.g), lighter(color.b), color.a};
}

Color family_color(double s) {
  constexpr std::array<Color, 5> kStops = {kBodyAxisRoles[0].ink, color_from_hex(0x7F7CC4),
                                           color_from_hex(0x8E9BAA), color_from_hex(0x4FA3B5),
                                           color_from_hex(0x0A7486)};
  const double place = std::clamp(s, 0.0, 1.0) * static_cast<double>(kStops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const auto f = static_cast<float>(place - static_cast<double>(first));
  const Color& a = kStops[first];
  const Color& b = kStops[first + 1];
  return {std::lerp(a.r, b.r, f), std::lerp(a.g, b.g, f), std::lerp(a.b, b.b, f), 1.0F};
}

}  // namespace polhode
