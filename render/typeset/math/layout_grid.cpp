// SPDX-License-Identifier: MIT
// Matrices and alignments, and displays broken into lines.
#include "render/typeset/math/layout.h"

#include <algorithm>

namespace polhode {

using Kind = MathNode::Kind;
MathLayout::Spacing MathLayout::spacing_of(const MathGrid& grid) {
  switch (grid.kind) {
    case MathGrid::Kind::aligned:
    case MathGrid::Kind::gathered:
      return {0.84, 0.36, 0.3, 0.36, 1.0, 0, true};
    case MathGrid::Kind::cases:
      return {1.008, 0.432, 0, 0.12, 1.0, 0};
    case MathGrid::Kind::small:
      return {0, 0, 0, 0.2, 0.36, grid.columns > 1 ? 0.22 : 0.0};
    case MathGrid::Kind::array:
      return {0.84, 0.36, 0, 0.12, 1.0, 0.5};
    default: {
      const bool has_bars = grid.left == U'|' || grid.left == U'‖';  // straight, so that entries touch them
      return {0.84, 0.36, 0, 0.12, 1.0, has_bars ? 0.14 : 0.0};
    }
  }
}

MathTextStyle MathLayout::cell_style(MathGrid::Kind kind, MathTextStyle style) {
  if (kind == MathGrid::Kind::aligned || kind == MathGrid::Kind::gathered)
    return {style.is_script() ? style.level : 0, false};
  if (kind == MathGrid::Kind::small) return {std::max(style.level, 2), style.cramped};
  return {std::max(style.level, 1), style.cramped};
}

double MathLayout::room_left(const MathGrid& grid, std::size_t column) {
  switch (grid.kind) {
    case MathGrid::Kind::aligned:
      return column % 2 == 0 ? 1.0 : 0.0;
    case MathGrid::Kind::cases:
      return 0.0;
    case MathGrid::Kind::array:
      if (column < grid.places.size())
        return grid.places[column] == 'l' ? 0.0 : grid.places[column] == 'r' ? 1.0 : 0.5;
      return 0.5;
    default:
      return 0.5;
  }
}

MathBox MathLayout::grid(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathGrid& grid = *node.grid;
  const MathTextStyle style = cell_style(grid.kind, item.style);
  const Spacing spacing = spacing_of(grid);
  const double s = size(style);
  const auto columns = static_cast<std::size_t>(std::max(grid.columns, 1));
  const std::size_t rows = node.children.size() / columns;

  const MathMark begin = mark();
  std::vector<MathMark> begins;
  std::vector<MathBox> cells;
  std::vector<double> widths(columns, 0.0), heights(rows, spacing.strut_height * s),
      depths(rows, spacing.strut_depth * s);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    begins.push_back(mark());
    const bool continues = grid.kind == MathGrid::Kind::aligned && i % columns % 2 == 1;
    cells.push_back(row(node.children[i], style, item.paint, nullptr, continues));
    widths[i % columns] = std::max(widths[i % columns], cells.back().width);
    heights[i / columns] = std::max(heights[i / columns], cells.back().height);
    depths[i / columns] = std::max(depths[i / columns], cells.back().depth);
  }
  begins.push_back(mark());

  std::vector<double> lefts(columns + 1, spacing.outside * s);
  for (std::size_t c = 0; c < columns; ++c) {
    const bool inside_pair = grid.kind == MathGrid::Kind::aligned && c % 2 == 0;
    lefts[c + 1] = lefts[c] + widths[c] + (inside_pair ? 0.0 : spacing.between * s);
  }
  std::vector<double> pitches(rows, 0.0);
  for (std::size_t r = 1; r < rows; ++r) {
    const double struts = depths[r - 1] + heights[r] + spacing.leading * s;
    const double ink = ink_depth(cells, columns, r - 1) + spacing.gap * s + ink_height(cells, columns, r);
    pitches[r] = std::max(struts, ink) + grid.skips[r - 1] * s;
  }
  if (spacing.trimmed && rows > 0) {
    heights.front() = ink_height(cells, columns, 0);
    depths.back() = ink_depth(cells, columns, rows - 1);
  }
  std::vector<double> baselines(rows, heights.empty() ? 0.0 : heights.front());
  for (std::size_t r = 1; r < rows; ++r) baselines[r] = baselines[r - 1] + pitches[r];
  const double width = lefts[columns - 1] + widths[columns - 1] + spacing.outside * s;
  const double total = rows == 0 ? 0.0 : baselines.back() + depths.back();
  const double top = -(axis(item.style) + 0.5 * total);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t c = i % columns;
    const double room = widths[c] - cells[i].width;
    shift(begins[i], begins[i + 1], lefts[c] + room_left(grid, c) * room, top + baselines[i / columns]);
  }
  const MathMark cells_end = mark();
  grid_lines(item, grid, lefts, widths, baselines, heights, depths, width, top, spacing.between * s);

  MathBox box{width, -top, top + total, 0, {}, {}};
  const double length = delimiter_length(0.5 * total, item.style);
  if (grid.left != 0) {
    shift(begin, delimiter_width(grid.left, length, item.style), 0.0);
    const MathBox left = delimiter(grid.left, length, item.style, item.paint, node.span);
    read_first(begin, cells_end);
    box = beside(box, left);
  } else if (grid.right != 0) {
    shift(begin, kNoDelimiter * s, 0.0);
    box.width += kNoDelimiter * s;
  }
  if (grid.right != 0) {
    const MathMark at = mark();
    const MathBox right = delimiter(grid.right, length, item.style, item.paint, node.span);
    shift(at, box.width, 0.0);
    box = beside(box, right);
  } else if (grid.left != 0) {
    box.width += kNoDelimiter * s;
  }
  return box;
}

MathBox MathLayout::beside(const MathBox& a, const MathBox& b) {
  return {a.width + b.width, std::max(a.height, b.height), std::max(a.depth, b.depth), 0, {}, {}};
}

double MathLayout::delimiter_width(char32_t character, double length, MathTextStyle style) {
  const MathMark begin = mark();
  const double width = delimiter(character, length, style, {}, {}).width;
  out_.glyphs.resize(begin.glyphs);
  out_.rules.resize(begin.rules);
  return width;
}

double MathLayout::ink_height(const std::vector<MathBox>& cells, std::size_t columns, std::size_t r) {
  double height = 0.0;
  for (std::size_t c = 0; c < columns; ++c) height = std::max(height, cells[r * columns + c].height);
  return height;
}

double MathLayout::ink_depth(const std::vector<MathBox>& cells, std::size_t columns, std::size_t r) {
  double depth = 0.0;
  for (std::size_t c = 0; c < columns; ++c) depth = std::max(depth, cells[r * columns + c].depth);
  return depth;
}

void MathLayout::grid_lines(const MathAtom& item, const MathGrid& grid, const std::vector<double>& lefts,
                            const std::vector<double>& widths, const std::vector<double>& baselines,
                            const std::vector<double>& heights, const std::vector<double>& depths,
                            double width, double top, double between) {
  const double thickness = 0.8 * rule_thickness(item.style);
  const double bottom = top + (baselines.empty() ? 0.0 : baselines.back() + depths.back());
  for (const int before : grid.columns_with_line) {
    const auto c = static_cast<std::size_t>(before);
    const double x = c == 0 ? 0.0 : c >= widths.size() ? width : lefts[c] - 0.5 * between;
    put_rule(x, top, x, bottom, thickness, item.paint, item.node->span);
  }
  for (const int above : grid.rows_with_line) {
    const auto r = static_cast<std::size_t>(above);
    const double y = r < baselines.size() ? top + baselines[r] - heights[r] : bottom;
    put_rule(0, y, width, y, thickness, item.paint, item.node->span);
  }
}

int MathLayout::break_rank(const PlacedAtom& placed) {
  constexpr double kWide = 0.99;
  if (placed.space >= kWide) return 0;
  if (placed.space != 0.0) return 3;
  if (placed.atom == MathClass::relation) return 1;
  return placed.atom == MathClass::binary ? 2 : 3;
}

MathLayout::Line MathLayout::line_from(const std::vector<PlacedAtom>& placed, std::size_t begin,
                                       double room) const {
  constexpr double kFullEnough = 0.4;
  std::size_t best = 0, best_binary = 0, overfull = 0;
  for (std::size_t k = begin + 1; k < placed.size(); ++k) {
    const int rank = break_rank(placed[k]);
    if (rank == 3) continue;
    const double width = placed[k - 1].end - placed[begin].x;
    if (width > room) {
      if (overfull == 0) overfull = k;
      break;
    }
    (rank < 2 ? best : best_binary) = k;
  }
  if (placed.back().end - placed[begin].x <= room) return {begin, placed.size()};
  const auto filled = [&](std::size_t k) { return placed[k].x - placed[begin].x; };
  if (best != 0 && (best_binary == 0 || filled(best) > kFullEnough * room)) return {begin, best};
  if (best_binary != 0) return {begin, best_binary};
  if (overfull != 0) return {begin, overfull};
  return {begin, placed.size()};
}

void MathLayout::break_lines(const std::vector<PlacedAtom>& placed) {
  constexpr double kIndent = 2.0, kPitch = 1.5, kGap = 0.4;
  const double s = style_.size;
  const double indent = std::min(kIndent * s, 0.2 * style_.line_width);
  double y = 0.0, last_depth = 0.0;
  out_.width = 0.0;
  for (std::size_t begin = 0; begin < placed.size();) {
    const bool first = begin == 0;
    while (!first && begin + 1 < placed.size() && placed[begin].space != 0.0) ++begin;
    const double left = first ? 0.0 : indent;
    const Line line = line_from(placed, begin, style_.line_width - left);
    double height = 0.0, depth = 0.0;
    for (std::size_t k = line.begin; k < line.end; ++k) {
      height = std::max(height, placed[k].height);
      depth = std::max(depth, placed[k].depth);
    }
    if (first)
      out_.ascent = height;
    else
      y += std::max(kPitch * s, last_depth + kGap * s + height);
    const MathMark end = line.end < placed.size() ? placed[line.end].begin : mark();
    shift(placed[line.begin].begin, end, left - placed[line.begin].x, y);
    out_.width = std::max(out_.width, left + placed[line.end - 1].end - placed[line.begin].x);
    last_depth = depth;
    begin = line.end;
  }
  out_.depth = y + last_depth;
}

}  // namespace polhode
