// SPDX-License-Identifier: MIT
// What stands above, below and around.
#include "render/typeset/math/layout.h"

#include <algorithm>

namespace polhode {

using Kind = MathNode::Kind;
MathBox MathLayout::accent(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathTextStyle style = item.style;
  const double s = size(style);
  const MathBox base = dotless_base(node.children[0], cramped(style), item.paint);
  const auto mark_glyph = accent_glyph(node, base.width / s);
  if (!mark_glyph) {
    fail(node.span, node.character);
    return base;
  }
  if (node.wide && is_arrow(node.character)) return arrow_accent(item, base, *mark_glyph);
  const GlyphBox ink = fonts_.box(Face::math, *mark_glyph);
  const double base_middle = base.attachment.value_or(0.5 * base.width);
  const double own_middle = middle_of_accent(*mark_glyph, ink) * s;
  const double rise = std::max(
      0.0, base.height - std::min(base.height, measure(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT, style)));
  const SourceSpan own{node.span.begin, std::max(node.span.begin, node.children[0].span.begin)};
  put_glyph(Face::math, *mark_glyph, base_middle - own_middle, -rise, s, item.paint,
            own.end > own.begin ? own : node.span);
  MathBox box = base;
  box.height = std::max(base.height, rise + ink.top * s);
  box.attachment = base_middle;
  return box;
}

std::optional<std::uint32_t> MathLayout::accent_glyph(const MathNode& node, double base_em) const {
  const auto glyph = fonts_.glyph(Face::math, node.character);
  if (!glyph || !node.wide || is_arrow(node.character)) return glyph;
  return widest_form_within(font_, *glyph, base_em);
}

double MathLayout::middle_of_accent(std::uint32_t glyph, const GlyphBox& ink) const {
  const double attachment = font_.top_accent_attachment(glyph);
  const bool inside = ink.left <= attachment && attachment <= ink.right;
  return inside ? attachment : 0.5 * (ink.left + ink.right);
}

MathBox MathLayout::dotless_base(const MathNode& node, MathTextStyle style, const MathPaint& paint) {
  std::vector<MathAtom> items = items_of(node, style, paint);
  if (items.size() == 1 && items.front().node->kind == Kind::symbol) {
    const MathNode& symbol_node = *items.front().node;
    if (symbol_node.character == U'i' || symbol_node.character == U'j') {
      MathNode dotless = symbol_node;
      dotless.character = symbol_node.character == U'i' ? U'ı' : U'ȷ';
      items.front().node = &dotless;
      return atom(items.front());
    }
  }
  return nucleus(node, style, paint);
}

MathBox MathLayout::arrow_accent(const MathAtom& item, const MathBox& base, std::uint32_t glyph) {
  const MathTextStyle style = item.style;
  const double s = size(style);
  const double base_width = base.width + base.italic;
  const StretchedGlyph arrow = stretched(font_, glyph, Stretch::horizontal, base_width / s);
  const double rise = std::max(0.0, base.height - measure(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT, style));
  const MathMark begin = mark();
  const MathBox made = put_horizontal(arrow, style, item.paint, item.node->span);
  shift(begin, 0.5 * (base_width - made.width), -rise);
  MathBox box = base;
  box.width = base_width;
  box.italic = 0.0;
  box.glyph.reset();
  box.height = std::max(base.height, made.height + rise);
  return box;
}

MathBox MathLayout::put_horizontal(const StretchedGlyph& sign, MathTextStyle style, const MathPaint& paint,
                                   SourceSpan span) {
  const double s = size(style);
  MathBox box;
  box.height = -1e9;
  box.depth = -1e9;
  for (const StretchedGlyph::Part& part : sign.parts) {
    const GlyphBox ink = fonts_.box(Face::math, part.glyph);
    put_glyph(Face::math, part.glyph, (part.offset - ink.left) * s, 0, s, paint, span);
    box.height = std::max(box.height, ink.top * s);
    box.depth = std::max(box.depth, -ink.bottom * s);
    box.width = std::max(box.width, (part.offset + ink.right - ink.left) * s);
  }
  return box;
}

MathBox MathLayout::bar(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathTextStyle style = item.style;
  const bool above = node.character == U'-';
  MathBox box = row(node.children[0], above ? cramped(style) : style, item.paint);
  const double gap = measure(
      above ? HB_OT_MATH_CONSTANT_OVERBAR_VERTICAL_GAP : HB_OT_MATH_CONSTANT_UNDERBAR_VERTICAL_GAP, style);
  const double thickness = measure(
      above ? HB_OT_MATH_CONSTANT_OVERBAR_RULE_THICKNESS : HB_OT_MATH_CONSTANT_UNDERBAR_RULE_THICKNESS,
      style);
  const double extra = measure(
      above ? HB_OT_MATH_CONSTANT_OVERBAR_EXTRA_ASCENDER : HB_OT_MATH_CONSTANT_UNDERBAR_EXTRA_DESCENDER,
      style);
  const double y = above ? -(box.height + gap + 0.5 * thickness) : box.depth + gap + 0.5 * thickness;
  put_rule(0, y, box.width, y, thickness, item.paint, node.span);
  (above ? box.height : box.depth) += gap + thickness + extra;
  box.glyph.reset();
  box.attachment.reset();
  return box;
}

MathBox MathLayout::brace(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathTextStyle style = item.style;
  const double s = size(style);
  MathBox box = row(node.children[0], style, item.paint);
  const auto glyph = fonts_.glyph(Face::math, node.character);
  if (!glyph) {
    fail(node.span, node.character);
    return box;
  }
  const bool above = node.character == U'⏞';
  const StretchedGlyph sign = stretched(font_, *glyph, Stretch::horizontal, box.width / s);
  const MathMark begin = mark();
  const MathBox made = put_horizontal(sign, style, item.paint, node.span);
  constexpr double kGap = 0.1;
  const double y = above ? -(box.height + kGap * s + made.depth) : box.depth + kGap * s + made.height;
  shift(begin, 0.5 * (box.width - made.width), y);
  const double grown = kGap * s + made.height + made.depth;
  (above ? box.height : box.depth) += grown;
  box.glyph.reset();
  box.attachment.reset();
  return box;
}

MathBox MathLayout::stacked(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathMark begin = mark();
  const MathBox base = with_italic(nucleus(node.children[0], item.style, item.paint));
  return above_and_below(
      item, begin, base, set_labels(item, node.children[1], node.children[2]), 0.0,
      {HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN,
       HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN});
}

MathBox MathLayout::with_italic(MathBox box) {
  box.width += box.italic;
  box.italic = 0.0;
  return box;
}

MathBox MathLayout::arrow(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathTextStyle style = item.style;
  const double s = size(style);
  Labels labels = set_labels(item, node.children[0], node.children[1]);
  const auto glyph = fonts_.glyph(Face::math, node.character);
  if (!glyph) {
    fail(node.span, node.character);
    return {};
  }
  constexpr double kAround = 0.6, kLeast = 1.2, kSide = 0.08;
  const double widest =
      std::max(labels.above ? labels.above->width : 0.0, labels.below ? labels.below->width : 0.0);
  const double wanted = std::max(widest + kAround * s, kLeast * s);
  const MathMark arrow_begin = mark();
  MathBox made =
      put_horizontal(stretched(font_, *glyph, Stretch::horizontal, wanted / s), style, item.paint, node.span);
  shift(arrow_begin, kSide * s, 0.0);
  made.width += 2.0 * kSide * s;
  // The arrow is read before its labels.
  const MathMark begin = labels.begin;
  const std::size_t added = mark().glyphs - arrow_begin.glyphs;
  read_first(begin, arrow_begin);
  for (MathMark* at : {&labels.begin, &labels.above_begin, &labels.end}) at->glyphs += added;
  return above_and_below(
      item, begin, made, labels, 0.0,
      {HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_ABOVE_MIN, HB_OT_MATH_CONSTANT_STRETCH_STACK_TOP_SHIFT_UP,
       HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_BELOW_MIN, HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_BELOW_MIN});
}

MathBox MathLayout::cancel(const MathAtom& item) {
  const MathNode& node = *item.node;
  const double s = size(item.style);
  const MathBox box = with_italic(nucleus(node.children[0], item.style, item.paint));
  // Through one letter it is flatter than the diagonal, which would lie along the slanted stem.
  const bool narrow = box.width < box.height + box.depth;
  const double beside = (narrow ? 0.1 : 0.06) * s, beyond = (narrow ? -0.06 : 0.04) * s;
  const double left = -beside, right = box.width + beside;
  const double top = -(box.height + beyond), bottom = box.depth + beyond;
  const double thickness = 0.7 * rule_thickness(item.style);
  MathPaint striking = item.paint;
  if (style_.strike && node.character != U'n') striking.color = *style_.strike;
  const auto stroke = [&](double y0, double y1) {
    put_rule(left, y0, right, y1, thickness, striking, node.span);
  };
  if (node.character == U'n') {
    const double middle = 0.5 * box.width, half = 0.2 * s, tall = 0.4 * s;
    put_rule(middle - half, -axis(item.style) + tall, middle + half, -axis(item.style) - tall, thickness,
             item.paint, node.span);
  }
  if (node.character == U'/' || node.character == U'x') stroke(bottom, top);
  if (node.character == U'\\' || node.character == U'x') stroke(top, bottom);
  MathBox all = box;
  all.glyph.reset();
  return all;
}

MathBox MathLayout::framed(const MathAtom& item) {
  const double s = size(item.style);
  const MathMark begin = mark();
  const MathBox inside = row(item.node->children[0], item.style, item.paint);
  constexpr double kSeparation = 0.3;
  const double thickness = 0.8 * rule_thickness(item.style), half = 0.5 * thickness;
  const double room = kSeparation * s + thickness;
  shift(begin, room, 0.0);
  const double right = inside.width + 2.0 * room, top = -(inside.height + room), bottom = inside.depth + room;
  const auto put = [&](double x0, double y0, double x1, double y1) {
    put_rule(x0, y0, x1, y1, thickness, item.paint, item.node->span);
  };
  // Rules end at each other's middles, and meet on whatever pixels these are drawn.
  put(half, top + half, right - half, top + half);
  put(half, bottom - half, right - half, bottom - half);
  put(half, top + half, half, bottom - half);
  put(right - half, top + half, right - half, bottom - half);
  return {right, -top, bottom, 0, {}, {}};
}

MathBox MathLayout::phantom(const MathAtom& item) {
  const MathMark begin = mark();
  const MathBox inside = row(item.node->children[0], item.style, item.paint);
  out_.glyphs.resize(begin.glyphs);
  out_.rules.resize(begin.rules);
  const int kept = static_cast<int>(item.node->amount);
  MathBox box;
  if ((kept & 1) != 0) box.width = inside.width;
  if ((kept & 2) != 0) {
    box.height = inside.height;
    box.depth = inside.depth;
  }
  return box;
}

}  // namespace polhode
