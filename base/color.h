// SPDX-License-Identifier: MIT
// sRGB, straight alpha, each 0…1.
#pragma once

namespace polhode {

struct Color {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const Color&) const = default;
};

constexpr Color color_from_hex(unsigned rgb, float alpha = 1.0F) {
  return {static_cast<float>((rgb >> 16) & 0xFF) / 255.0F, static_cast<float>((rgb >> 8) & 0xFF) / 255.0F,
          static_cast<float>(rgb & 0xFF) / 255.0F, alpha};
}

/// `part` of the way from one colour to another.
constexpr Color between(const Color& from, const Color& to, float part) {
  const auto mixed = [part](float a, float b) { return a + part * (b - a); };
  return {mixed(from.r, to.r), mixed(from.g, to.g), mixed(from.b, to.b), mixed(from.a, to.a)};
}

}  // namespace polhode
