// SPDX-License-Identifier: MIT
#include "render/typeset/paragraph.h"

#include "render/typeset/characters.h"
#include "render/typeset/line_breaker.h"
#include "render/typeset/line_formulas.h"
#include "render/typeset/line_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace polhode {
namespace {

// Lengths in em of the text.
constexpr double kRag = 2.6;          // what a ragged line may lack
constexpr double kListIndent = 1.35;  // of each level
constexpr double kBulletSize = 0.8;
constexpr double kMarkerGap = 0.5;    // between a marker and its text
constexpr double kListBetween = 0.5;  // of the space between other blocks
constexpr double kLinkDrop = 0.13;    // of the line below a link
constexpr double kLinkThickness = 0.045;

// Of tables.
constexpr double kColumnGap = 1.5;                       // between columns
constexpr double kTablePad = 0.35;                       // to the ends of the lines
constexpr double kRowGap = 0.16;                         // between rows, besides what lines have
constexpr double kRulePad = 0.3;                         // between a line and the rows beside it
constexpr double kAboveTable = 0.25, kBelowTable = 0.6;  // beside its outer lines
constexpr double kHeavyRule = 0.075, kLightRule = 0.045;
constexpr double kLeastTableSize = 0.6;   // of the text; rather than smaller, words are broken
constexpr double kLeastBrokenSize = 0.1;  // where there is not even room for letters

/// Sets text; collects what is wrong with it, or, if it is lenient, shows it somehow.
class TextSetter {
 public:
  TextSetter(const TextStyle& style, const Fonts& fonts, bool lenient)
      : style_(style), fonts_(fonts), metrics_(style, fonts), lenient_(lenient) {}

  DisplayList set(const RichText& text) {
    measure_indents(text);
    for (const TextBlock& block : text) {
      const TextBlock* before = &block != text.data() ? &block - 1 : nullptr;
      if (block.is_table())
        set_table(block, before);
      else
        set_block(block, before);
      if (errors_.size() >= kMaxTypeErrors) break;
    }
    return std::move(list_);
  }
  std::vector<TypeError> take_errors() {
    std::stable_sort(errors_.begin(), errors_.end(),
                     [](const TypeError& a, const TypeError& b) { return a.offset < b.offset; });
    if (errors_.size() > kMaxTypeErrors) errors_.resize(kMaxTypeErrors);
    return std::move(errors_);
  }

 private:
  TextParts parts_of(const TextBlock& block, double width) {
    return polhode::parts_of(block, width, {style_, fonts_, metrics_, lenient_, list_, errors_});
  }

  // ---- From parts to lines

  void measure_indents(const RichText& text) {
    for (const TextBlock& block : text) {
      if (block.indent <= 0) continue;
      double& step = indents_[block.indent];
      step = std::max(
          {step, kListIndent * style_.size, marker_of(block.marker).width() + kMarkerGap * style_.size});
    }
  }
  double indent_of(int level) const {
    double x = 0.0;
    for (int i = 1; i <= level; ++i) {
      const auto step = indents_.find(i);
      x += step == indents_.end() ? kListIndent * style_.size : step->second;
    }
    return style_.width > 0.0 ? std::min(x, 0.5 * style_.width) : x;
  }
  Face marker_face() const { return face_of({}, style_); }
  /// The font's bullet is as heavy as bold text.
  double marker_size(const std::string& marker) const {
    return (marker == "•" ? kBulletSize : 1.0) * style_.size;
  }
  /// The digits of a raised number, of which the fonts lack some above 3; empty: the marker is none.
  static std::string raised_digits(const std::string& marker) {
    std::string digits;
    for (std::size_t at = 0; at < marker.size();) {
      const Script script = script_of(next_character(marker, at));
      if (!script.raised) return "";
      append_utf8(digits, script.character);
    }
    return digits;
  }
  /// A marker's glyphs, as large and as high as they stand.
  struct Marker {
    std::vector<ShapedGlyph> glyphs;
    double size = 0, rise = 0;
    double width() const {
      double sum = 0.0;
      for (const ShapedGlyph& g : glyphs) sum += g.advance * size;
      return sum;
    }
  };
  Marker marker_of(const std::string& marker) const {
    const std::string raised = raised_digits(marker);
    if (raised.empty()) return {fonts_.shape(marker_face(), marker), marker_size(marker), 0.0};
    return {fonts_.shape(marker_face(), raised), kScriptSize * style_.size, kScriptRise * style_.size};
  }

  void set_block(const TextBlock& block, const TextBlock* before) {
    const double x = indent_of(block.indent);
    const double width = style_.width > 0.0 ? style_.width - x : 0.0;
    TextParts parts = parts_of(block, width);
    if (width > 0.0) split_wide_parts(parts, width);

    LineShape shape;
    shape.width = width;
    shape.rag = kRag * style_.size;
    shape.edge = style_.bold        ? LineShape::Edge::balanced
                 : style_.justified ? LineShape::Edge::justified
                                    : LineShape::Edge::ragged;
    const bool in_list = before != nullptr && before->indent > 0 && block.indent > 0;
    block_gap_ = before == nullptr ? 0.0 : style_.between * style_.size * (in_list ? kListBetween : 1.0);
    std::size_t begin = 0;
    for (const std::size_t end : width > 0.0 ? break_lines(parts.lines, shape) : forced_ends(parts.lines)) {
      set_line(block, parts, begin, end, x, space_change(parts.lines, begin, end, shape));
      if (begin == 0 && !block.marker.empty()) set_marker(block, x);
      begin = end;
    }
  }

  /// The lines of a text without width.
  static std::vector<std::size_t> forced_ends(const std::vector<LinePart>& lines) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].ends_line || i + 1 == lines.size()) ends.push_back(i + 1);
    return ends;
  }

  struct Extent {
    double ascent, depth;
  };
  Extent extent_of(const TextParts& parts, std::size_t first, std::size_t last) const {
    Extent extent{metrics_.ascent * style_.size, metrics_.depth * style_.size};
    for (std::size_t a = first; a < last; ++a) {
      if (parts.atoms[a].formula < 0) continue;
      const DisplayList& formula = parts.formulas[static_cast<std::size_t>(parts.atoms[a].formula)];
      extent.ascent = std::max(extent.ascent, formula.ascent);
      extent.depth = std::max(extent.depth, formula.depth);
    }
    return extent;
  }

  /// Baseline of the next line: by the leading, and lower by whole pixels if something high is on it.
  void advance_to_line(const Extent& extent) {
    if (!has_line_) {
      list_.ascent = extent.ascent;
    } else {
      const double leading = std::round(style_.leading * style_.size + block_gap_);
      const double needed = std::ceil(line_depth_ + extent.ascent + style_.clearance * style_.size);
      y_ += std::max({1.0, leading, needed});
    }
    has_line_ = true;
    block_gap_ = 0.0;
    line_depth_ = extent.depth;
    list_.depth = std::max(list_.depth, y_ + extent.depth);
  }

  void set_line(const TextBlock& block, const TextParts& parts, std::size_t begin, std::size_t end, double x,
                double change) {
    advance_to_line(extent_of(parts, parts.first_atoms[begin], parts.first_atoms[end]));
    double pen = x;
    if (flush_right_ && style_.width > 0.0)
      pen += std::max(0.0, style_.width - x - length_of(parts, begin, end));
    double right = pen;
    LinkRule link;
    for (std::size_t p = begin; p < end; ++p) {
      const LinePart& part = parts.lines[p];
      for (std::size_t a = parts.first_atoms[p]; a < parts.first_atoms[p + 1]; ++a) {
        const bool last_of_part = a + 1 == parts.first_atoms[p + 1];
        place(parts, parts.atoms[a], pen);
        follow_link(block.spans[parts.atoms[a].span], pen + parts.atoms[a].glyph.x,
                    pen + (last_of_part ? part.width : parts.atoms[a + 1].glyph.x), link);
      }
      right = pen + part.width;
      pen = right + part.space + change * (change < 0.0 ? part.shrink : part.stretch);
    }
    end_link(link);
    list_.width = std::max(list_.width, right);
  }

  static double length_of(const TextParts& parts, std::size_t begin, std::size_t end) {
    double length = 0.0;
    for (std::size_t p = begin; p < end; ++p)
      length += parts.lines[p].width + (p + 1 < end ? parts.lines[p].space : 0.0);
    return length;
  }

  void place(const TextParts& parts, const TextAtom& atom, double x) {
    if (atom.formula >= 0) {
      append(list_, parts.formulas[static_cast<std::size_t>(atom.formula)], x + atom.glyph.x, y_);
      return;
    }
    list_.glyphs.push_back(atom.glyph);
    list_.glyphs.back().x += x;
    list_.glyphs.back().y += y_;
  }

  void set_marker(const TextBlock& block, double x) {
    const Marker marker = marker_of(block.marker);
    const double size = marker.size;
    const double pen = x - kMarkerGap * style_.size - marker.width();
    const SourceSpan source = block.spans.empty() ? SourceSpan{} : block.spans.front().source;
    for (const ShapedGlyph& g : marker.glyphs) {
      const GlyphBox box = fonts_.box(marker_face(), g.id);
      const double rise = marker.rise > 0.0
                              ? marker.rise
                              : 0.5 * (box.bottom + box.top) * (style_.size - size);  // keeps its middle
      list_.glyphs.push_back({marker_face(),
                              g.id,
                              pen + g.x * size,
                              y_ - rise - g.y * size,
                              size,
                              style_.color,
                              {},
                              {source.begin, source.begin}});
    }
  }

  // ---- Tables

  /// A table's cells at one size of type.
  struct SetTable {
    double size = 0;
    std::vector<double> widths;  ///< of the columns
    std::vector<std::vector<DisplayList>> rows;
    double width() const {
      double sum = 2.0 * kTablePad * size + kColumnGap * size * static_cast<double>(widths.size() - 1);
      for (const double one : widths) sum += one;
      return sum;
    }
  };

  DisplayList cell_list(const TextTable::Cell& cell, const TextStyle& style,
                        TextTable::Align align = TextTable::Align::left) {
    TextSetter setter(style, fonts_, lenient_);
    setter.flush_right_ = align == TextTable::Align::right;
    DisplayList list = setter.set({TextBlock{.indent = 0, .marker = {}, .spans = cell}});
    std::vector<TypeError> errors = setter.take_errors();
    if (errors_.size() < kMaxTypeErrors) errors_.insert(errors_.end(), errors.begin(), errors.end());
    return list;
  }

  /// Of the widest word or formula.
  double least_width(const TextTable::Cell& cell, const TextStyle& style) {
    TextSetter setter(style, fonts_, true);
    double least = 0.0;
    for (const LinePart& part :
         setter.parts_of(TextBlock{.indent = 0, .marker = {}, .spans = cell}, 0.0).lines)
      least = std::max(least, part.width);
    return least;
  }

  /// How wide a column may be at most, so that all together lose so much.
  static double widest_column(std::vector<double> widths, double loss) {
    std::sort(widths.begin(), widths.end());
    double room = -loss;
    for (const double one : widths) room += one;
    std::size_t left = widths.size();
    for (const double one : widths) {
      if (one * static_cast<double>(left) > room) break;
      room -= one;
      --left;
    }
    return left == 0 ? widths.back() : std::max(0.0, room / static_cast<double>(left));
  }

  /// Each column as wide as its widest cell; where that is too much, the wide ones give what they have above
  /// their widest word, in proportion; where that is not enough, the type is made smaller.
  SetTable laid_out(const TextTable& table, double width) {
    TextStyle style = style_;
    style.justified = false;
    // What is as wide as its column fits into it: glyphs are set on a grid of their own.
    const auto with_room = [](double one) { return std::ceil(one) + 1.0; };
    for (SetTable made; true; style.size *= 0.93) {
      style.width = 0.0;
      made = {style.size, std::vector<double>(table.columns.size()), {}};
      std::vector<double> least(table.columns.size());
      for (const auto& row : table.rows)
        for (std::size_t c = 0; c < row.size(); ++c) {
          made.widths[c] = std::max(made.widths[c], with_room(cell_list(row[c], style).width));
          if (width > 0.0) least[c] = std::max(least[c], with_room(least_width(row[c], style)));
        }
      if (!errors_.empty()) return made;
      const double over = width > 0.0 ? made.width() - width : 0.0;
      if (over > 0.0) {
        double spare = 0.0;
        for (std::size_t c = 0; c < least.size(); ++c) spare += made.widths[c] - least[c];
        if (spare < over && style.size > kLeastTableSize * style_.size) continue;
        const double part = spare > over ? over / spare : 1.0;
        for (std::size_t c = 0; c < least.size(); ++c) made.widths[c] -= part * (made.widths[c] - least[c]);
        if (spare < over) {  // words will be broken
          const double widest = widest_column(made.widths, made.width() - width);
          if (widest < style.size && style.size > kLeastBrokenSize * style_.size) continue;
          for (double& one : made.widths) one = std::min(one, widest);
        }
      }
      for (const auto& row : table.rows) {
        made.rows.emplace_back();
        for (std::size_t c = 0; c < row.size(); ++c) {
          style.width = made.widths[c];
          made.rows.back().push_back(cell_list(row[c], style, table.columns[c]));
        }
      }
      return made;
    }
  }

  void set_table(const TextBlock& block, const TextBlock* before) {
    const double x0 = indent_of(block.indent);
    const double room = style_.width > 0.0 ? style_.width - x0 : 0.0;
    const SetTable table = laid_out(block.table, room);
    if (!errors_.empty()) return;
    const double em = table.size, width = table.width();
    const double left = x0 + (block.indent == 0 ? std::max(0.0, std::round(0.5 * (room - width))) : 0.0);
    const double heavy = std::max(1.0, std::round(kHeavyRule * em)),
                 light = std::max(1.0, std::round(kLightRule * em)), pad = kRulePad * em;
    const auto rule = [&](double y, double thickness) {
      list_.rules.push_back({left, y, left + width, y, thickness, style_.color, {}, {}});
    };
    block_gap_ = before == nullptr ? 0.0 : style_.between * style_.size;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const bool is_head = r == 0, is_last = r + 1 == table.rows.size();
      Extent extent{metrics_.ascent * em, metrics_.depth * em};
      for (const DisplayList& cell : table.rows[r]) {
        extent.ascent = std::max(extent.ascent, cell.ascent);
        extent.depth = std::max(extent.depth, cell.depth);
      }
      const double above = is_head ? std::ceil(extent.ascent + pad) : 0.0,
                   below = std::ceil(extent.depth + pad);
      Extent with_rules = extent;
      if (is_head) with_rules.ascent = above + heavy + (has_line_ ? kAboveTable * em : 0.0);
      if (is_head || is_last) with_rules.depth = below + (is_last ? heavy : light + pad);
      if (!is_head && !is_last) with_rules.depth += kRowGap * em;
      advance_to_line(with_rules);
      if (is_head) rule(y_ - above - 0.5 * heavy, heavy);
      if (is_last)
        rule(y_ + below + 0.5 * heavy, heavy);
      else if (is_head)
        rule(y_ + below + 0.5 * light, light);
      double x = left + kTablePad * em;
      for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
        const DisplayList& cell = table.rows[r][c];
        const double free = table.widths[c] - cell.width;
        const TextTable::Align align = block.table.columns[c];
        const double shift = align == TextTable::Align::left    ? 0.0
                             : align == TextTable::Align::right ? free
                                                                : 0.5 * free;
        append(list_, cell, x + shift, y_);
        x += table.widths[c] + kColumnGap * em;
      }
    }
    line_depth_ += kBelowTable * em;
    list_.width = std::max(list_.width, left + width);
  }

  // ---- The line below a link

  struct LinkRule {
    const TextSpan* first = nullptr;  ///< of the spans with this link
    double x0 = 0, x1 = 0;
    SourceSpan source;
  };
  void follow_link(const TextSpan& span, double x0, double x1, LinkRule& link) {
    if (link.first != nullptr && link.first->link != span.link) end_link(link);
    if (span.link.empty()) return;
    if (link.first == nullptr) link = {&span, x0, x1, span.source};
    link.x1 = x1;
    link.source.end = std::max(link.source.end, span.source.end);
  }
  void end_link(LinkRule& link) {
    if (link.first != nullptr) {
      const double thickness = std::max(1.0, std::round(kLinkThickness * style_.size));
      const double y = y_ + std::round(kLinkDrop * style_.size) + 0.5 * thickness;
      list_.rules.push_back({link.x0, y, link.x1, y, thickness, style_.link_color, {}, link.source});
    }
    link.first = nullptr;
  }

  const TextStyle& style_;
  const Fonts& fonts_;
  TextMetrics metrics_;
  bool lenient_;
  bool flush_right_ = false;       // lines of a cell, in the whole width
  std::map<int, double> indents_;  // steps of the levels of lists
  std::vector<TypeError> errors_;

  DisplayList list_;
  bool has_line_ = false;
  double y_ = 0;           // of the last baseline
  double line_depth_ = 0;  // of the last line
  double block_gap_ = 0;   // before the next line
};

TextSpan plain_span(std::string_view line, std::size_t begin, std::size_t end) {
  TextSpan span;
  for (std::size_t i = begin; i < end; ++i) {
    if (line[i] == '\\' && i + 1 < end && line[i + 1] == '$') continue;
    span.text += line[i];
  }
  span.source = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  return span;
}

/// A formula that cannot be set is shown as it is written.
TextSpan formula_span(std::string_view line, SourceSpan source, const TextStyle& style, const Fonts& fonts) {
  const std::string_view tex = line.substr(source.begin, source.end - source.begin);
  TextSpan span;
  span.source = source;
  if (auto math = parse_math(tex)) {
    MathStyle math_style;
    math_style.size = style.size;
    if (set_math(*math, math_style, fonts)) {
      span.kind = TextSpan::Kind::math;
      span.text = tex;
      span.math = std::move(*math);
      return span;
    }
  }
  return plain_span(line, source.begin - 1, source.end + 1);
}

}  // namespace

Result<DisplayList, std::vector<TypeError>> set_text(const RichText& text, const TextStyle& style,
                                                     const Fonts& fonts) {
  TextSetter setter(style, fonts, false);
  DisplayList list = setter.set(text);
  std::vector<TypeError> errors = setter.take_errors();
  if (!errors.empty()) return Failure{std::move(errors)};
  return list;
}

DisplayList set_lines(std::string_view text, const TextStyle& style, const Fonts& fonts) {
  TextBlock block;
  std::size_t at = 0;
  for (const SourceSpan& formula : formulas_of_line(text)) {
    if (formula.begin > at + 1) block.spans.push_back(plain_span(text, at, formula.begin - 1));
    block.spans.push_back(formula_span(text, formula, style, fonts));
    at = formula.end + 1;
  }
  if (at < text.size()) block.spans.push_back(plain_span(text, at, text.size()));
  return TextSetter(style, fonts, true).set({block});
}

DisplayList set_line(std::string_view text, const TextStyle& style, const Fonts& fonts) {
  TextStyle one_line = style;
  one_line.width = 0.0;
  return set_lines(text, one_line, fonts);
}

}  // namespace polhode
