// SPDX-License-Identifier: MIT
#include "app/live_numbers.h"

#include "render/type/paragraph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

std::string number_text(double value) {
  const double size = std::abs(value);
  if (size >= 9999.5 || (size > 0 && size < 0.005)) return fmt::format("{:.0e}", value);
  std::string text = fmt::format("{:.{}f}", value, size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
  if (text.front() == '-') text.replace(0, 1, "−");
  return text;
}

std::optional<std::size_t> live_index(const std::string& name, const std::vector<std::string>& live_names) {
  const auto found = std::find(live_names.begin(), live_names.end(), name);
  if (found == live_names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - live_names.begin());
}

}  // namespace

std::vector<LiveRoom> take_live_rooms(DisplayList& list) {
  constexpr double kDigit = 0.5;  // advance of a digit, em
  std::vector<std::string> live_names;
  for (std::size_t i = 0; i < list.names.size(); ++i) live_names.push_back(live_name(i));
  std::vector<LiveRoom> rooms;
  const auto take = [&](const Glyph& glyph) {
    if (glyph.naming.term < 0) return false;
    const auto index = live_index(list.names[static_cast<std::size_t>(glyph.naming.term)], live_names);
    if (!index) return false;
    if (rooms.empty() || rooms.back().index != *index) rooms.emplace_back().index = *index;
    rooms.back().end = Vec2(glyph.x + kDigit * glyph.size, glyph.y);
    rooms.back().size = glyph.size;
    rooms.back().color = glyph.color;
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
  const Vec2 at(room.end.x() - list.width, room.end.y());
  return {.list = std::move(list), .at = at};
}

}  // namespace polhode
