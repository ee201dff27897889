// SPDX-License-Identifier: MIT
// Type set on a page as data: glyphs and rules, each with its place, colour, and where it comes from. All
// that the layouts of this folder make is such a list; a renderer draws it, and needs to know nothing of
// text. Pixels, x to the right, y down, from the left end of the first baseline.
#pragma once

#include "base/color.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// The faces text is set in: TeX Gyre Pagella (serif), Pagella Math, Heros (sans), Cursor (mono).
enum class Face : std::uint8_t {
  serif,
  serif_italic,
  serif_bold,
  serif_bold_italic,
  math,
  sans,
  sans_bold,
  mono
};
inline constexpr int kFaceCount = 8;

/// Bytes [begin, end) of the text that something was made from.
struct SourceSpan {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const SourceSpan&) const = default;
};

/// What is named: a `\term{id}{…}` or a link, or a symbol of the lesson. Indices into DisplayList::names; −1:
/// none.
struct Naming {
  std::int16_t term = -1;    ///< the innermost \term, else the link
  std::int16_t symbol = -1;  ///< the innermost symbol
  bool operator==(const Naming&) const = default;
};

struct Glyph {
  Face face = Face::serif;
  std::uint32_t id = 0;  ///< in the font, not a character
  double x = 0, y = 0;   ///< its origin, on the baseline
  double size = 0;       ///< em
  Color color;
  Naming naming;
  SourceSpan source;
  bool operator==(const Glyph&) const = default;
};

/// A straight line of even thickness with cut ends: bars of fractions and roots, frames, what strikes out.
struct Rule {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< the ends of its middle line
  double thickness = 1;
  Color color;
  Naming naming;
  SourceSpan source;
  bool operator==(const Rule&) const = default;
};

struct DisplayList {
  std::vector<Glyph> glyphs;  ///< in reading order
  std::vector<Rule> rules;
  std::vector<std::string> names;
  double width = 0;   ///< advance
  double ascent = 0;  ///< height above the first baseline, ≥ 0
  double depth = 0;   ///< and below it, ≥ 0
  bool operator==(const DisplayList&) const = default;
};

/// Adds `part` with its origin at (x, y); its names are kept. The measures of `list` stay as they are.
void append(DisplayList& list, const DisplayList& part, double x, double y);

/// Place of `name` in the list's names, added if it is new.
std::int16_t index_of(DisplayList& list, std::string_view name);

struct TypeBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return !(x0 < x1 && y0 < y1); }
};

/// What is wrong with a text that is to be set. `offset` counts bytes.
struct TypeError {
  std::size_t offset = 0;
  std::string message;
  std::string hint{};          ///< what to do; may be empty
  std::string macro{};         ///< of the author, which says what is wrong; empty: the text itself does
  std::size_t macro_offset{};  ///< byte of what that macro stands for
};

/// So many of them are told of one text at most.
inline constexpr std::size_t kMaxTypeErrors = 16;

}  // namespace polhode
