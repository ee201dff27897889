// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/entities.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace polhode {
namespace {

struct NamedCharacter {
  std::string_view name;
  char32_t character;
};
/// Those with a use in text; formulas have the rest.
constexpr std::array<NamedCharacter, 20> kEntities = {
    {{"amp", U'&'},     {"lt", U'<'},      {"gt", U'>'},      {"quot", U'"'},     {"apos", U'\''},
     {"nbsp", 0xA0},    {"ndash", 0x2013}, {"mdash", 0x2014}, {"hellip", 0x2026}, {"lsquo", 0x2018},
     {"rsquo", 0x2019}, {"ldquo", 0x201C}, {"rdquo", 0x201D}, {"middot", 0xB7},   {"times", 0xD7},
     {"deg", 0xB0},     {"plusmn", 0xB1},  {"sect", 0xA7},    {"rarr", 0x2192},   {"minus", 0x2212}}};

}  // namespace

std::optional<char32_t> entity_character(std::string_view entity) {
  std::string_view name = entity.substr(1, entity.size() - 2);
  if (name.substr(0, 1) != "#") {
    const auto found = std::find_if(kEntities.begin(), kEntities.end(),
                                    [name](const NamedCharacter& e) { return e.name == name; });
    if (found == kEntities.end()) return std::nullopt;
    return found->character;
  }
  const bool hex = name.size() > 1 && (name[1] == 'x' || name[1] == 'X');
  name.remove_prefix(hex ? 2 : 1);
  std::uint32_t value = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), value, hex ? 16 : 10);
  const bool is_control = value < 0x20 || (value >= 0x7F && value < 0xA0);
  const bool is_character = !is_control && value <= 0x10FFFF && !(value >= 0xD800 && value <= 0xDFFF);
  if (read.ec != std::errc{} || read.ptr != name.data() + name.size() || !is_character) return std::nullopt;
  return value;
}

}  // namespace polhode
