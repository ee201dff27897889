// SPDX-License-Identifier: MIT
#include "render/typeset/line_breaker.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kRounding = 1e-6;     // px by which sums of widths may be off
constexpr double kEachLine = 10.0;     // Knuth & Plass's line penalty
constexpr double kWorst = 1e4;         // badness of what cannot be helped
constexpr double kLonelyWord = 400.0;  // of a last line of one word
constexpr double kLineMore = 1e12;     // a balanced text never takes one more line

struct Line {
  double length = 0;  // of what is not space at its end
  double stretch = 0, shrink = 0;
  bool one_word = true;
  bool is_last = false;  // of the paragraph, or before a forced end

  /// One part more at its front.
  void take(const LinePart& part, bool has_follower) {
    length += part.width;
    if (!has_follower) return;
    length += part.space;
    stretch += part.stretch;
    shrink += part.shrink;
    one_word = one_word && part.space <= 0.0;
  }
};

double cube(double x) { return x * x * x; }

/// How much of its stretch or shrink a justified line needs.
double ratio(const Line& line, double width) {
  const double lacks = width - line.length;
  if (line.is_last && lacks >= 0.0) return 0.0;
  const double give = lacks < 0.0 ? line.shrink : line.stretch;
  if (give <= 0.0) return std::abs(lacks) <= kRounding ? 0.0 : std::copysign(kWorst, lacks);
  return lacks / give;
}

double badness(const Line& line, const LineShape& shape) {
  const double lacks = std::max(0.0, shape.width - line.length);
  if (shape.edge == LineShape::Edge::balanced) return 100.0 * (lacks / shape.width) * (lacks / shape.width);
  if (line.is_last && shape.edge == LineShape::Edge::ragged) return 0.0;
  const double used =
      shape.edge == LineShape::Edge::justified ? std::abs(ratio(line, shape.width)) : lacks / shape.rag;
  return std::min(kWorst, 100.0 * cube(used));
}

double demerits_of(const Line& line, double penalty, bool is_only, const LineShape& shape) {
  if (shape.edge == LineShape::Edge::balanced)
    return kLineMore + badness(line, shape) + (line.is_last ? 0.0 : penalty * penalty * 1e-3);
  const double bad = kEachLine + badness(line, shape);
  const double lonely = line.is_last && line.one_word && !is_only ? kLonelyWord : 0.0;
  return bad * bad + (line.is_last ? 0.0 : penalty * penalty) + lonely * lonely;
}

bool fits(const Line& line, const LineShape& shape) {
  const double give = shape.edge == LineShape::Edge::justified ? line.shrink : 0.0;
  return line.length - give <= shape.width + kRounding;
}

Line line_of(const std::vector<LinePart>& parts, std::size_t begin, std::size_t end) {
  Line line;
  line.is_last = end == parts.size() || parts[end - 1].ends_line;
  for (std::size_t i = end; i-- > begin;) line.take(parts[i], i + 1 < end);
  return line;
}

bool begins_paragraph(const std::vector<LinePart>& parts, std::size_t begin) {
  return begin == 0 || parts[begin - 1].ends_line;
}

}  // namespace

std::vector<std::size_t> break_lines(const std::vector<LinePart>& parts, const LineShape& shape) {
  struct Best {
    double total = std::numeric_limits<double>::infinity();
    std::size_t begin = 0;  // of the line that ends here
  };
  std::vector<Best> best(parts.size() + 1);
  best[0].total = 0.0;
  for (std::size_t end = 1; end <= parts.size(); ++end) {
    Line line;
    line.is_last = end == parts.size() || parts[end - 1].ends_line;
    for (std::size_t begin = end; begin-- > 0;) {
      line.take(parts[begin], begin + 1 < end);
      if (begin + 1 < end && (!fits(line, shape) || parts[begin].ends_line)) break;
      const double total = best[begin].total +
                           demerits_of(line, parts[end - 1].penalty, begins_paragraph(parts, begin), shape);
      if (total < best[end].total) best[end] = {total, begin};
    }
  }
  std::vector<std::size_t> ends;
  for (std::size_t end = parts.size(); end > 0; end = best[end].begin) ends.push_back(end);
  std::reverse(ends.begin(), ends.end());
  return ends;
}

double demerits(const std::vector<LinePart>& parts, const std::vector<std::size_t>& ends,
                const LineShape& shape) {
  double total = 0.0;
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    total += demerits_of(line_of(parts, begin, end), parts[end - 1].penalty, begins_paragraph(parts, begin),
                         shape);
    begin = end;
  }
  return total;
}

double space_change(const std::vector<LinePart>& parts, std::size_t begin, std::size_t end,
                    const LineShape& shape) {
  if (shape.edge != LineShape::Edge::justified) return 0.0;
  const double change = ratio(line_of(parts, begin, end), shape.width);
  return std::abs(change) < kWorst ? std::max(-1.0, change) : 0.0;
}

}  // namespace polhode
