// SPDX-License-Identifier: MIT
#include "app/page/live_numbers.h"

#include "render/typeset/paragraph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

std::optional<std::size_t> live_index(const std::string& name, const std::vector<std::string>& live_names) {
  const auto found = std::find(live_names.begin(), live_names.end(), name);
  if (found == live_names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - live_names.begin());
}

}  // namespace

std::string live_number_text(double value) {
  if (value == 0) return "0";
  const std::string rounded = fmt::format("{:.2e}", std::abs(value));  // "2.25e+04"
  const std::size_t e = rounded.find('e');
  const int exponent = std::stoi(rounded.substr(e + 1));
  const bool is_plain = exponent >= -2 && exponent <= 4;
  const std::string text = is_plain ? fmt::format("{:.{}f}", std::abs(value), std::max(2 - exponent, 0))
                                    : fmt::format("{}${{\\cdot}}10^{{{}}}$", rounded.substr(0, e), exponent);
  return (value < 0 ? "−" : "") + text;
}

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

PlacedType live_number_in(const LiveRoom& room, std::optional<double> value, const Fonts& fonts) {
  TextStyle style;
  style.size = room.size;
  style.color = room.color;
  const std::string text = value ? live_number_text(*value) : "…";
  DisplayList list = set_line(text, style, fonts);
  const double width = set_line(std::string(kLiveRoom), style, fonts).width;
  if (list.width > width) {
    style.size *= width / list.width;
    list = set_line(text, style, fonts);
  }
  return {.list = std::move(list), .at = room.at};
}

}  // namespace polhode
