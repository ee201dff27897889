// SPDX-License-Identifier: MIT
#include "app/live_numbers.h"

#include "render/type/paragraph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

/// Three digits; a power of ten is set apart where there are too many zeros.
std::string number_text(double value) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  const bool is_plain = exponent >= -2 && exponent <= 3;
  const int decimals = is_plain ? std::clamp(2 - exponent, 0, 3) : 0;
  std::string text = fmt::format("{:.{}f}", is_plain ? size : size / std::pow(10.0, exponent), decimals);
  if (!is_plain) text += fmt::format("${{\\cdot}}10^{{{}}}$", exponent);
  return (value < 0 ? "−" : "") + text;
}

std::optional<std::size_t> live_index(const std::string& name, const std::vector<std::string>& live_names) {
  const auto found = std::find(live_names.begin(), live_names.end(), name);
  if (found == live_names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - live_names.begin());
}

}  // namespace

std::vector<LiveRoom> take_live_rooms(DisplayList& list) {
  std::vector<std::string> live_names;
  for (std::size_t i = 0; i < list.names.size(); ++i) live_names.push_back(live_name(i));
  std::vector<LiveRoom> rooms;
  const auto take = [&](const Glyph& glyph) {
    if (glyph.naming.term < 0) return false;
    const auto index = live_index(list.names[static_cast<std::size_t>(glyph.naming.term)], live_names);
    if (!index) return false;
    if (rooms.empty() || rooms.back().index != *index)
      rooms.push_back({*index, Vec2(glyph.x, glyph.y), glyph.size, glyph.color});
    return true;
  };
  list.glyphs.erase(std::remove_if(list.glyphs.begin(), list.glyphs.end(), take), list.glyphs.end());
  return rooms;
}

PlacedType live_number_in(const LiveRoom& room, const Expression& number, const LiveState* live,
                          const Fonts& fonts) {
  const auto value = live ? live_number(number, *live) : std::nullopt;
  TextStyle style;
  style.size = room.size;
  style.color = room.color;
  DisplayList list = set_line(value ? number_text(*value) : "…", style, fonts);
  return {.list = std::move(list), .at = room.at};
}

}  // namespace polhode
