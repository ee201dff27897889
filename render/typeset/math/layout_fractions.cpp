// SPDX-License-Identifier: MIT
// Fractions, roots and delimiters.
#include "render/typeset/math/layout.h"

#include <algorithm>

namespace polhode {
MathBox MathLayout::fraction(const MathAtom& item) {
  const MathNode& node = *item.node;
  MathTextStyle style = item.style;
  if (node.forced_style >= 0) style.level = node.forced_style;
  const bool display = style.is_display();
  const bool has_bar = node.amount > 0.0;
  const double thickness = has_bar ? rule_thickness(style) : 0.0;
  const MathMark top_begin = mark();
  const MathBox top = row(node.children[0], numerator(style), item.paint);
  const MathMark bottom_begin = mark();
  const MathBox bottom = row(node.children[1], denominator(style), item.paint);
  const MathMark end = mark();

  using C = hb_ot_math_constant_t;
  const auto pick = [&](C display_bar, C bar, C display_stack, C stack) {
    return measure(has_bar ? (display ? display_bar : bar) : (display ? display_stack : stack), style);
  };
  double up =
      pick(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP,
           HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_SHIFT_UP,
           HB_OT_MATH_CONSTANT_STACK_TOP_DISPLAY_STYLE_SHIFT_UP, HB_OT_MATH_CONSTANT_STACK_TOP_SHIFT_UP);
  double down = pick(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_DISPLAY_STYLE_SHIFT_DOWN,
                     HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_SHIFT_DOWN,
                     HB_OT_MATH_CONSTANT_STACK_BOTTOM_DISPLAY_STYLE_SHIFT_DOWN,
                     HB_OT_MATH_CONSTANT_STACK_BOTTOM_SHIFT_DOWN);
  const double middle = axis(style);
  if (has_bar) {
    const double above = measure(display ? HB_OT_MATH_CONSTANT_FRACTION_NUM_DISPLAY_STYLE_GAP_MIN
                                         : HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_GAP_MIN,
                                 style);
    const double below = measure(display ? HB_OT_MATH_CONSTANT_FRACTION_DENOM_DISPLAY_STYLE_GAP_MIN
                                         : HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_GAP_MIN,
                                 style);
    up = std::max(up, middle + 0.5 * thickness + above + top.depth);
    down = std::max(down, -middle + 0.5 * thickness + below + bottom.height);
  } else {
    const double least = measure(
        display ? HB_OT_MATH_CONSTANT_STACK_DISPLAY_STYLE_GAP_MIN : HB_OT_MATH_CONSTANT_STACK_GAP_MIN, style);
    const double lacking = least - ((up - top.depth) - (bottom.height - down));
    if (lacking > 0.0) {
      up += 0.5 * lacking;
      down += 0.5 * lacking;
    }
  }
  const double width = std::max(top.width, bottom.width);
  MathBox box;
  box.height = up + top.height;
  box.depth = down + bottom.depth;

  const double opening =
      node.binomial ? fraction_delimiter(U'(', item, style, box, 0.0) : kNoDelimiter * size(style);
  shift(top_begin, bottom_begin, opening + 0.5 * (width - top.width), -up);
  shift(bottom_begin, end, opening + 0.5 * (width - bottom.width), down);
  if (node.binomial) read_first(top_begin, end);
  if (has_bar) put_rule(opening, -middle, opening + width, -middle, thickness, item.paint, node.span);
  const double closing = node.binomial ? fraction_delimiter(U')', item, style, box, opening + width)
                                       : kNoDelimiter * size(style);
  box.width = opening + width + closing;
  return box;
}

double MathLayout::fraction_delimiter(char32_t character, const MathAtom& item, MathTextStyle style,
                                      const MathBox& inside, double x) {
  const double half = std::max(inside.height - axis(style), inside.depth + axis(style));
  const MathMark begin = mark();
  const MathBox made =
      delimiter(character, delimiter_length(half, style), style, item.paint, item.node->span);
  shift(begin, x, 0.0);
  return made.width;
}

MathBox MathLayout::radical(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathTextStyle style = item.style;
  const double s = size(style);
  const double thickness = measure(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS, style);
  double gap = measure(style.is_display() ? HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP
                                          : HB_OT_MATH_CONSTANT_RADICAL_VERTICAL_GAP,
                       style);
  const MathNode& degree = node.children[1];
  const MathMark begin = mark();
  const MathBox degree_box = degree.absent() ? MathBox{} : row(degree, {3, true}, item.paint);
  const MathMark inside_begin = mark();
  const MathBox inside = row(node.children[0], cramped(style), item.paint);
  const MathMark inside_end = mark();

  const auto root = fonts_.glyph(Face::math, U'√');
  if (!root) {
    fail(node.span, U'√');
    return inside;
  }
  const double wanted = inside.height + inside.depth + gap + thickness;
  const StretchedGlyph sign = stretched(font_, *root, Stretch::vertical, wanted / s);
  const MathBox sign_box = put_vertical(sign, 0.0, style, item.paint, node.span);
  const double sign_height = sign_box.height + sign_box.depth;
  if (sign_height > wanted) gap += 0.5 * (sign_height - wanted);
  const double top = inside.height + gap + thickness;

  double x = 0.0;
  double degree_rise = 0.0;
  if (!degree.absent()) {
    x = measure(HB_OT_MATH_CONSTANT_RADICAL_KERN_BEFORE_DEGREE, style);
    degree_rise = font_[HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT] * sign_height -
                  (sign_height - top) + degree_box.depth;
    shift(begin, inside_begin, x, -degree_rise);
    x = std::max(0.0, x + degree_box.width + measure(HB_OT_MATH_CONSTANT_RADICAL_KERN_AFTER_DEGREE, style));
  }
  shift(inside_end, mark(), x, -(top - sign_box.height));
  const double rule_x = x + sign_box.width;
  put_rule(rule_x, -(top - 0.5 * thickness), rule_x + inside.width, -(top - 0.5 * thickness), thickness,
           item.paint, node.span);
  shift(inside_begin, inside_end, rule_x, 0.0);
  read_first(inside_begin, inside_end);

  MathBox box;
  box.width = rule_x + inside.width;
  box.height = top + measure(HB_OT_MATH_CONSTANT_RADICAL_EXTRA_ASCENDER, style);
  box.depth = std::max(inside.depth, sign_height - top);
  if (!degree.absent()) box.height = std::max(box.height, degree_rise + degree_box.height);
  return box;
}

MathBox MathLayout::put_vertical(const StretchedGlyph& sign, double bottom, MathTextStyle style,
                                 const MathPaint& paint, SourceSpan span) {
  const double s = size(style);
  MathBox box;
  if (!sign.joined) {
    const std::uint32_t glyph = sign.parts.front().glyph;
    const GlyphBox ink = fonts_.box(Face::math, glyph);
    put_glyph(Face::math, glyph, 0, 0, s, paint, span);
    return {fonts_.advance(Face::math, glyph) * s, ink.top * s, -ink.bottom * s, 0, {}, glyph};
  }
  for (const StretchedGlyph::Part& part : sign.parts) {
    const GlyphBox ink = fonts_.box(Face::math, part.glyph);
    put_glyph(Face::math, part.glyph, 0, -(bottom + (part.offset - ink.bottom) * s), s, paint, span);
    box.width = std::max(box.width, fonts_.advance(Face::math, part.glyph) * s);
  }
  box.height = bottom + sign.length * s;
  box.depth = -bottom;
  return box;
}

double MathLayout::delimiter_length(double half, MathTextStyle style) const {
  constexpr double kFactor = 0.901, kShortfall = 0.5;
  return std::max(2.0 * half * kFactor, 2.0 * half - kShortfall * size(style));
}

MathBox MathLayout::delimiter(char32_t character, double length, MathTextStyle style, const MathPaint& paint,
                              SourceSpan span) {
  const double s = size(style);
  if (character == 0) return {kNoDelimiter * s, 0, 0, 0, {}, {}};
  const auto glyph = fonts_.glyph(Face::math, character);
  if (!glyph) {
    fail(span, character);
    return {};
  }
  const bool is_bar = character == U'|' || character == U'‖';
  const GlyphBox plain = fonts_.box(Face::math, *glyph);
  if (is_bar && length > (plain.top - plain.bottom) * s) return bars(character, length, style, paint, span);
  const StretchedGlyph sign = stretched(font_, *glyph, Stretch::vertical, length / s);
  const MathMark begin = mark();
  MathBox box = put_vertical(sign, 0.0, style, paint, span);
  const double drop = 0.5 * (box.height - box.depth) - axis(style);
  shift(begin, 0.0, drop);
  box.height -= drop;
  box.depth += drop;
  box.glyph.reset();
  return box;
}

MathBox MathLayout::bars(char32_t character, double length, MathTextStyle style, const MathPaint& paint,
                         SourceSpan span) {
  const double s = size(style);
  const std::uint32_t glyph = fonts_.glyph(Face::math, character).value_or(0);
  const GlyphBox one = fonts_.box(Face::math, fonts_.glyph(Face::math, U'|').value_or(0));
  const GlyphBox all = fonts_.box(Face::math, glyph);
  const double thickness = (one.right - one.left) * s;
  const double top = -(axis(style) + 0.5 * length), bottom = -(axis(style) - 0.5 * length);
  const auto put = [&](double x) { put_rule(x, top, x, bottom, thickness, paint, span); };
  put(all.left * s + 0.5 * thickness);
  if (character == U'‖') put(all.right * s - 0.5 * thickness);
  return {fonts_.advance(Face::math, glyph) * s, -top, bottom, 0, {}, {}};
}

MathBox MathLayout::big_delimiter(const MathAtom& item) {
  constexpr double kFactor = 0.901;
  return delimiter(item.node->character, kFactor * item.node->amount * style_.size, item.style, item.paint,
                   item.node->span);
}

MathBox MathLayout::fenced(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathTextStyle style = item.style;
  const std::size_t parts = node.children.size() / 2;
  std::vector<MathBox> rows;
  std::vector<MathMark> begins;
  double half = 0.0;
  MathBox box;
  for (std::size_t i = 0; i < parts; ++i) {
    begins.push_back(mark());
    rows.push_back(row(node.children[2 * i + 1], style, item.paint));
    half = std::max({half, rows.back().height - axis(style), rows.back().depth + axis(style)});
    box.height = std::max(box.height, rows.back().height);
    box.depth = std::max(box.depth, rows.back().depth);
  }
  begins.push_back(mark());
  const double length = delimiter_length(half, style);
  for (std::size_t i = 0; i <= parts; ++i) {
    const MathNode& d = node.children[2 * i];
    const MathMark begin = mark();
    const MathBox made = delimiter(d.character, length, style, item.paint, d.span);
    shift(begin, box.width, 0.0);
    box.height = std::max(box.height, made.height);
    box.depth = std::max(box.depth, made.depth);
    box.width += made.width;
    if (i == parts) break;
    const std::size_t added = mark().glyphs - begin.glyphs;
    shift(begins[i], begins[i + 1], box.width, 0.0);
    read_first(begins[i], begin);
    for (std::size_t k = i; k <= parts; ++k) begins[k].glyphs += added;
    box.width += rows[i].width;
  }
  return box;
}

}  // namespace polhode
