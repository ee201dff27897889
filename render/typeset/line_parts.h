// SPDX-License-Identifier: MIT
// A block of text as parts, between which a line may end: words, formulas, the spaces behind them. What
// belongs together, a number and its unit, is seldom parted. Internal to the setting of paragraphs.
#pragma once

#include "render/typeset/fonts.h"
#include "render/typeset/line_breaker.h"
#include "render/typeset/paragraph.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace polhode {

/// Raised digits and marks, of the text's size, and how high they stand.
inline constexpr double kScriptSize = 0.68;
inline constexpr double kScriptRise = 0.38;

/// A glyph or a formula, x from the begin of its part.
struct TextAtom {
  Glyph glyph;
  int formula = -1;        ///< in formulas; −1: a glyph
  bool is_cluster = true;  ///< may be first on a line
  std::uint32_t span = 0;
};

/// Of one block: atoms, and the parts they make.
struct TextParts {
  std::vector<TextAtom> atoms;
  std::vector<std::size_t> first_atoms;  ///< of each part, and one past the last
  std::vector<LinePart> lines;           ///< what the breaker sees of each part
  std::vector<DisplayList> formulas;
};

/// Measures of faces that a text is set with, em of the text.
struct TextMetrics {
  TextMetrics(const TextStyle& style, const Fonts& fonts);
  double size(Face face) const { return sizes[static_cast<std::size_t>(face)]; }

  bool sans;
  std::array<double, kFaceCount> sizes{};
  double ascent = 0, depth = 0;
};

Face face_of(const TextSpan& span, const TextStyle& style);

/// Where a text goes: `list` gets the names of its links, `errors` what is wrong with it, or, if it is
/// lenient, it is shown somehow.
struct TextSetting {
  const TextStyle& style;
  const Fonts& fonts;
  const TextMetrics& metrics;
  bool lenient;
  DisplayList& list;
  std::vector<TypeError>& errors;
};

/// Formulas that are wider than `width` are broken, or made smaller; 0: they stay as they are.
TextParts parts_of(const TextBlock& block, double width, const TextSetting& setting);

/// Words that are wider than a line are broken anywhere.
void split_wide_parts(TextParts& parts, double width);

}  // namespace polhode
