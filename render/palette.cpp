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

namespace {

/// Relative luminance and contrast: Web Content Accessibility Guidelines 2.1.
double luminance(const Color& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}
double contrast(const Color& a, const Color& b) {
  const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

bool is_grey(const Color& c) {
  constexpr float kLeastHue = 0.1F;
  return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) < kLeastHue;
}

}  // namespace

Color paint_on_dark(const Color& paint) {
  constexpr double kLeast = 6.4;
  constexpr int kShares = 64;
  constexpr float kBrightest = 0.94F;
  const float scale = std::max(1.0F, kBrightest / std::max({paint.r, paint.g, paint.b, 0.1F}));
  const double wanted = std::max(kLeast, is_grey(paint) ? contrast(paint, kPaper) : 0.0);
  // Brighter first, which keeps the hue full; white then.
  const auto with_white = [&](int share) {
    const float bright = std::min(1.0F, 2.0F * static_cast<float>(share) / kShares),
                white = std::max(0.0F, 2.0F * static_cast<float>(share) / kShares - 1.0F);
    const auto mixed = [&](float c) { return std::lerp(c * std::lerp(1.0F, scale, bright), 1.0F, white); };
    return Color{mixed(paint.r), mixed(paint.g), mixed(paint.b), paint.a};
  };
  int share = 0;
  while (share < kShares && (luminance(with_white(share)) < luminance(kDarkGround) ||
                             contrast(with_white(share), kDarkGround) < wanted))
    ++share;
  return with_white(share);
}

Color family_color(double s) {
  constexpr std::array<Color, 5> kStops = {kBodyAxisRoles[0].ink, color_from_hex(0x7F7CC4),
                                           color_from_hex(0x8592A0), color_from_hex(0x4B9BAC),
                                           color_from_hex(0x0A7486)};
  const double place = std::clamp(s, 0.0, 1.0) * static_cast<double>(kStops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const auto f = static_cast<float>(place - static_cast<double>(first));
  const Color& a = kStops[first];
  const Color& b = kStops[first + 1];
  return {std::lerp(a.r, b.r, f), std::lerp(a.g, b.g, f), std::lerp(a.b, b.b, f), 1.0F};
}

}  // namespace polhode
