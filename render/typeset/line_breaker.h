// SPDX-License-Identifier: MIT
// Where the lines of a paragraph end: the choice whose lines are best together (D. E. Knuth & M. F. Plass,
// "Breaking paragraphs into lines", Software: Practice and Experience 11 (1981) 1119-1184). Sees widths
// alone.
#pragma once

#include <cstddef>
#include <vector>

namespace polhode {

/// A stretch that is never broken, and what follows it: Knuth & Plass's box, glue and penalty.
struct LinePart {
  double width = 0;                ///< px, as all lengths here
  double space = 0;                ///< after it, dropped where a line ends
  double stretch = 0, shrink = 0;  ///< of the space, in justified lines
  double penalty = 0;              ///< of a line that ends after it; 100 is a lot
  bool ends_line = false;          ///< a line must end after it
};

struct LineShape {
  enum class Edge {
    ragged,     ///< spaces keep their width
    justified,  ///< spaces stretch and shrink, but for a last line's
    balanced    ///< ragged, as few lines as possible, all of them about as long: headings
  };
  double width = 0;  ///< no part is wider
  Edge edge = Edge::ragged;
  double rag = 0;  ///< what a ragged line may lack before it looks bad, > 0
};

/// Lines as the place of one past their last parts. O(parts · parts of a line).
std::vector<std::size_t> break_lines(const std::vector<LinePart>& parts, const LineShape& shape);

/// What break_lines makes least: the demerits of all lines.
double demerits(const std::vector<LinePart>& parts, const std::vector<std::size_t>& ends,
                const LineShape& shape);

/// By how much of its stretch (> 0) or shrink (< 0) each space of a justified line changes; 0 for the last
/// line of a paragraph and before a forced end.
double space_change(const std::vector<LinePart>& parts, std::size_t begin, std::size_t end,
                    const LineShape& shape);

}  // namespace polhode
