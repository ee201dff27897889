// SPDX-License-Identifier: MIT
// Lines of text: shaped by HarfBuzz, broken where the whole paragraph looks best (D. E. Knuth & M. F. Plass,
// "Breaking paragraphs into lines", Software: Practice and Experience 11 (1981) 1119-1184).
#pragma once

#include "render/typeset/rich_text.h"

namespace polhode {

struct TextStyle {
  double size = 24;  ///< em, px
  Color color;
  bool sans = false;        ///< Heros instead of Pagella: labels and captions
  bool bold = false;        ///< headings
  double leading = 1.47;    ///< from baseline to baseline, em
  double width = 0;         ///< px; 0: a single line
  bool justified = false;   ///< both edges straight; else the right one is ragged
  double between = 0.55;    ///< extra space between blocks, em
  double clearance = 0.08;  ///< at least, between what is on two lines, em
  Color link_color;
  const std::vector<MathSymbol>* symbols = nullptr;
};

/// Sets blocks one below the other. `depth` of the list is the whole height below the first baseline, `width`
/// that of the longest line. Every baseline is a whole number of pixels below the first. Characters that the
/// fonts lack, and those that run from right to left, are errors; offsets are those of the spans' sources.
/// Straight quotation marks become curly ones but in code.
Result<DisplayList, std::vector<TypeError>> set_text(const RichText& text, const TextStyle& style,
                                                     const Fonts& fonts);

/// One line of plain text with formulas between single `$`, as labels and captions have it; no Markdown. What
/// cannot be set is shown as it stands, a missing glyph as the font's own box.
DisplayList set_line(std::string_view text, const TextStyle& style, const Fonts& fonts);
/// The same in as many lines as the style's width asks for.
DisplayList set_lines(std::string_view text, const TextStyle& style, const Fonts& fonts);

}  // namespace polhode
