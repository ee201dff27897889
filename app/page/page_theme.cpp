// SPDX-License-Identifier: MIT
#include "app/page/page_theme.h"

#include "render/palette.h"

namespace polhode {

namespace {

constexpr PageColors kLight = {.paper = kPaper,
                               .ink = kInk,
                               .quiet = color_from_hex(0x5F656D),
                               .accent = kOmegaRole.ink,
                               .panel = color_from_hex(0xF3EDDD),
                               .line = color_from_hex(0xDDD8CB),
                               .said = color_from_hex(0x5F656D),
                               .meant = kPolhodeRole.ink,
                               .question = kLRole.ink,
                               .marked = color_from_hex(0xF0C27A, 0.55F),
                               .backdrop = kPaper};

constexpr PageColors kDark = {.paper = color_from_hex(0x1B1E23),
                              .ink = color_from_hex(0xECE9E1),
                              .quiet = color_from_hex(0xA4AAB3),
                              .accent = color_from_hex(0xF08A3C),
                              .panel = color_from_hex(0x2A2E35),
                              .line = color_from_hex(0x3C424B),
                              .said = color_from_hex(0xA4AAB3),
                              .meant = color_from_hex(0x4FC79B),
                              .question = color_from_hex(0x6FB6E6),
                              .marked = color_from_hex(0x8A5A1A, 0.55F),
                              .backdrop = color_from_hex(0x22262C)};

}  // namespace

const PageColors& colors_of(Theme theme) { return theme == Theme::paper ? kLight : kDark; }

Color on_paper(const Color& ink, Theme theme) { return theme == Theme::dark ? on_dark(ink) : ink; }

std::vector<MathSymbol> symbols_of(const Lesson& lesson, Theme theme) {
  std::vector<MathSymbol> symbols;
  for (const auto& [name, symbol] : lesson.symbols) {
    const auto role = role_from(symbol.role);
    const bool has_color = role && symbol.role != "axes";
    symbols.push_back({name, symbol.math, has_color ? on_paper(role->ink, theme) : colors_of(theme).ink});
  }
  return symbols;
}

}  // namespace polhode
