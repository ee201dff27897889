// SPDX-License-Identifier: MIT
// Text with its emphasis and inline formulas, ready to be set: no marks of Markdown are left.
#pragma once

#include "render/typeset/math/math.h"

#include <string>
#include <vector>

namespace polhode {

/// A stretch of text of one kind. If `source` is as long as `text`, each byte of the one comes from that of
/// the other; else the text is spelt otherwise there (`&amp;`), and all of it comes from all of that.
struct TextSpan {
  enum class Kind { text, math } kind = Kind::text;
  std::string text;  ///< UTF-8; of a formula its TeX
  Math math;         ///< of Kind::math
  bool bold = false, italic = false, code = false;
  std::string link;  ///< where it leads, the name of its glyphs (DisplayList::names); empty: nowhere
  bool break_after = false;
  SourceSpan source;  ///< of a formula without its dollars
};

/// Cells in rows and columns, set between lines as in books: above, below the head, and at the bottom.
struct TextTable {
  enum class Align { left, center, right };
  using Cell = std::vector<TextSpan>;
  std::vector<Align> columns;           ///< empty: no table
  std::vector<std::vector<Cell>> rows;  ///< each with a cell for every column; the first is the head
};

/// A paragraph, an item of a list, or a table.
struct TextBlock {
  int indent = 0;      ///< depth of the list it belongs to
  std::string marker;  ///< "•", "2."; empty: none
  std::vector<TextSpan> spans;
  TextTable table{};  ///< instead of spans

  bool is_table() const { return !table.columns.empty(); }
};

/// A link to the source of what is said: behind it stands the source's key in the lesson.
inline constexpr std::string_view kCiteLink = "cite:";

/// Whether glyphs of this name (DisplayList::names) are those of a link: no \term has such an id.
inline bool is_link_name(std::string_view name) { return name.find_first_of("#:") != name.npos; }

using RichText = std::vector<TextBlock>;

/// All spans of a text, those of tables too, in their order.
template <class Text, class Do>
void for_each_span(Text& text, const Do& act) {
  for (auto& block : text) {
    for (auto& span : block.spans) act(span);
    for (auto& row : block.table.rows)
      for (auto& cell : row)
        for (auto& span : cell) act(span);
  }
}

}  // namespace polhode
