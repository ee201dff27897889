// SPDX-License-Identifier: MIT
// Characters, words, and their scripts.
#include "render/typeset/characters.h"
#include "render/typeset/math/alphabets.h"
#include "render/typeset/math/layout.h"

#include <algorithm>

namespace polhode {
std::optional<MathLayout::Found> MathLayout::find_glyph(char32_t character, Alphabet alphabet,
                                                        MathTextStyle style) const {
  if (const auto glyph = fonts_.glyph(Face::math, in_alphabet(character, alphabet))) {
    const bool small = style.is_script();
    return Found{Face::math, small ? font_.script_form(*glyph, style.level - 1) : *glyph};
  }
  for (const Face face : {Face::math, Face::serif, Face::sans})
    if (const auto glyph = fonts_.glyph(face, character)) return Found{face, *glyph};
  return std::nullopt;
}

MathBox MathLayout::symbol(const MathAtom& item) {
  const MathNode& node = *item.node;
  const auto found = find_glyph(node.character, node.alphabet, item.style);
  if (!found) {
    fail(node.span, node.character);
    return {};
  }
  if (found->face != Face::math) return plain_glyph(*found, item);
  if (node.atom == MathClass::large) return large_operator(found->glyph, item);
  return math_glyph(found->glyph, item);
}

MathBox MathLayout::plain_glyph(const Found& found, const MathAtom& item) {
  const double s = size(item.style);
  const GlyphBox ink = fonts_.box(found.face, found.glyph);
  put_glyph(found.face, found.glyph, 0, 0, s, item.paint, item.node->span);
  return {fonts_.advance(found.face, found.glyph) * s, ink.top * s, -ink.bottom * s, 0, {}, {}};
}

MathBox MathLayout::math_glyph(std::uint32_t glyph, const MathAtom& item) {
  const double s = size(item.style);
  const GlyphBox ink = fonts_.box(Face::math, glyph);
  put_glyph(Face::math, glyph, 0, 0, s, item.paint, item.node->span);
  MathBox box{fonts_.advance(Face::math, glyph) * s, ink.top * s, -ink.bottom * s, 0, {}, glyph};
  box.italic = font_.italic_correction(glyph) * s;
  box.attachment = font_.top_accent_attachment(glyph) * s;
  return box;
}

MathBox MathLayout::large_operator(std::uint32_t glyph, const MathAtom& item) {
  if (item.style.is_display())
    glyph = stretched_single(glyph, font_[HB_OT_MATH_CONSTANT_DISPLAY_OPERATOR_MIN_HEIGHT]);
  const MathMark begin = mark();
  MathBox box = math_glyph(glyph, item);
  const double drop = 0.5 * (box.height - box.depth) - axis(item.style);
  shift(begin, 0.0, drop);
  box.height -= drop;
  box.depth += drop;
  box.italic = 0.0;
  box.attachment.reset();
  return box;
}

std::uint32_t MathLayout::stretched_single(std::uint32_t glyph, double length) const {
  const StretchedGlyph found = stretched(font_, glyph, Stretch::vertical, length);
  if (!found.joined) return found.parts.front().glyph;
  // A sign in parts is not for this: the largest whole one.
  for (double l = length; l > 0.0; l *= 0.9) {
    const StretchedGlyph smaller = stretched(font_, glyph, Stretch::vertical, l);
    if (!smaller.joined) return smaller.parts.front().glyph;
  }
  return glyph;
}

MathBox MathLayout::text(const MathAtom& item) {
  const MathNode& node = *item.node;
  const double s = size(item.style);
  MathBox box;
  Clusters cluster{node, 0, 0, 0, {}};
  for (const ShapedGlyph& g : fonts_.shape(node.face, node.text)) {
    cluster.go_to(g.cluster);
    if (g.id == 0) {
      const auto found = find_glyph(cluster.character, Alphabet::upright, item.style);
      if (!found) {
        fail(cluster.source, cluster.character);
        continue;
      }
      put_text_glyph(found->face, found->glyph, box.width, 0.0, s, item.paint, cluster.source, box);
      box.width += fonts_.advance(found->face, found->glyph) * s;
    } else {
      put_text_glyph(node.face, g.id, box.width, -(g.y * s), s, item.paint, cluster.source, box);
      box.width += g.advance * s;
    }
  }
  return box;
}

void MathLayout::put_text_glyph(Face face, std::uint32_t id, double x, double y, double s,
                                const MathPaint& paint, SourceSpan source, MathBox& box) {
  const GlyphBox ink = fonts_.box(face, id);
  if (!(ink.left < ink.right)) return;  // a space
  put_glyph(face, id, x, y, s, paint, source);
  box.height = std::max(box.height, ink.top * s - y);
  box.depth = std::max(box.depth, y - ink.bottom * s);
}

void MathLayout::Clusters::go_to(std::size_t byte) {
  while (at < node.text.size() && at <= byte) {
    character = next_character(node.text, at);
    source = node.sources[std::min(index, node.sources.size() - 1)];
    ++index;
  }
}

MathBox MathLayout::scripts(const MathAtom& item) {
  const MathNode& node = *item.node;
  if (has_limits(node, item.style)) return limits(item);
  const MathTextStyle style = item.style;
  const MathNode& below = node.children[1];
  const MathNode& above = node.children[2];
  MathPaint base_paint = item.paint, below_paint = item.paint;
  MathPaint above_paint = item.paint;
  if (item.base_symbol != nullptr) base_paint = below_paint = named(item.paint, *item.base_symbol, true);
  if (item.base_symbol == nullptr && !item.paint.sealed && !item.paint.fixed_color)
    if (const MathSymbol* under = symbols_.below_dots(node))
      base_paint.color = below_paint.color = above_paint.color = under->color;
  // The power of a symbol has its colour, and is no part of it: ω₁² is one thing to the eye.
  const MathSymbol* powered = item.paint.sealed             ? nullptr
                              : item.base_symbol != nullptr ? item.base_symbol
                                                            : symbols_.of(node.children[0]);
  if (powered != nullptr && !above_paint.fixed_color) above_paint.color = powered->color;

  MathBox box = nucleus(node.children[0], style, base_paint);
  const bool is_large = without_groups(node.children[0]).atom == MathClass::large && box.glyph.has_value();
  const bool is_character = box.glyph.has_value() && !is_large;
  double raise = 0.0, lower = 0.0;
  if (!is_character) {
    raise = box.height - measure(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BASELINE_DROP_MAX, superscript(style));
    lower = box.depth + measure(HB_OT_MATH_CONSTANT_SUBSCRIPT_BASELINE_DROP_MIN, subscript(style));
  }
  // The sign of an integral leans: its subscript goes under it, its superscript behind.
  const double lean = is_large ? font_.italic_correction(*box.glyph) * size(style) : 0.0;
  const double sub_x = box.width - lean, sup_x = box.width + box.italic;

  const MathMark below_begin = mark();
  const MathBox sub = below.absent() ? MathBox{} : row(below, subscript(style), below_paint);
  const MathMark above_begin = mark();
  const MathBox sup = above.absent() ? MathBox{} : row(above, superscript(style), above_paint);

  raise = std::max({raise,
                    measure(style.cramped ? HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED
                                          : HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP,
                            style),
                    sup.depth + measure(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MIN, style)});
  lower = std::max({lower, measure(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN, style),
                    sub.height - measure(HB_OT_MATH_CONSTANT_SUBSCRIPT_TOP_MAX, style)});
  if (!above.absent() && !below.absent()) keep_scripts_apart(sub, sup, style, raise, lower);

  const double sup_kern =
      is_character && !above.absent() ? corner_kern(box, above_begin, mark(), raise, sup, style, true) : 0.0;
  const double sub_kern = is_character && !below.absent()
                              ? corner_kern(box, below_begin, above_begin, lower, sub, style, false)
                              : 0.0;
  shift(below_begin, above_begin, sub_x + sub_kern, lower);
  shift(above_begin, mark(), sup_x + sup_kern, -raise);

  const double after = measure(HB_OT_MATH_CONSTANT_SPACE_AFTER_SCRIPT, style);
  MathBox all = box;
  all.glyph.reset();
  all.attachment.reset();
  all.italic = 0.0;
  if (!below.absent()) {
    all.width = std::max(box.width, sub_x + sub_kern + sub.width + after);
    all.depth = std::max(all.depth, lower + sub.depth);
    all.height = std::max(all.height, sub.height - lower);
  }
  if (!above.absent()) {
    all.width = std::max(all.width, sup_x + sup_kern + sup.width + after);
    all.height = std::max(all.height, raise + sup.height);
    all.depth = std::max(all.depth, sup.depth - raise);
  }
  return all;
}

void MathLayout::keep_scripts_apart(const MathBox& sub, const MathBox& sup, MathTextStyle style,
                                    double& raise, double& lower) const {
  const double gap = (raise - sup.depth) - (sub.height - lower);
  const double least = measure(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN, style);
  if (gap >= least) return;
  lower += least - gap;
  const double bottom = measure(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MAX_WITH_SUBSCRIPT, style);
  const double more = bottom - (raise - sup.depth);
  if (more <= 0.0) return;
  raise += more;
  lower -= more;
}

double MathLayout::corner_kern(const MathBox& base, MathMark begin, MathMark end, double offset,
                               const MathBox& script, MathTextStyle style, bool above) const {
  if (end.glyphs == begin.glyphs || out_.glyphs[begin.glyphs].face != Face::math) return 0.0;
  const Glyph& first = out_.glyphs[begin.glyphs];
  const double s = size(style);
  const auto at = [&](double height) {
    const double own = height + (above ? -offset : offset);
    return s * font_.kern(*base.glyph, above ? HB_OT_MATH_KERN_TOP_RIGHT : HB_OT_MATH_KERN_BOTTOM_RIGHT,
                          height / s) +
           first.size * font_.kern(first.id, above ? HB_OT_MATH_KERN_BOTTOM_LEFT : HB_OT_MATH_KERN_TOP_LEFT,
                                   own / first.size);
  };
  return above ? std::max(at(offset - script.depth), at(base.height))
               : std::max(at(script.height - offset), at(-base.depth));
}

bool MathLayout::has_limits(const MathNode& node, MathTextStyle style) {
  return node.limits == Limits::above_below || (node.limits == Limits::in_display && style.is_display());
}

MathBox MathLayout::limits(const MathAtom& item) {
  const MathNode& node = *item.node;
  const MathTextStyle style = item.style;
  const MathMark begin = mark();
  const MathBox base = with_italic(nucleus(node.children[0], style, item.paint));
  const bool leans = base.glyph.has_value() && node.children[0].atom == MathClass::large;
  const double lean = leans ? font_.italic_correction(*base.glyph) * size(style) : 0.0;
  return above_and_below(
      item, begin, base, set_labels(item, node.children[2], node.children[1]), lean,
      {HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN,
       HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN});
}

MathLayout::Labels MathLayout::set_labels(const MathAtom& item, const MathNode& above,
                                          const MathNode& below) {
  Labels labels;
  labels.begin = mark();
  if (!below.absent()) labels.below = row(below, subscript(item.style), item.paint);
  labels.above_begin = mark();
  if (!above.absent()) labels.above = row(above, superscript(item.style), item.paint);
  labels.end = mark();
  return labels;
}

MathBox MathLayout::above_and_below(const MathAtom& item, MathMark begin, const MathBox& base,
                                    const Labels& labels, double lean, const Gaps& gaps) {
  const MathTextStyle style = item.style;
  const bool has_above = labels.above.has_value(), has_below = labels.below.has_value();
  const MathBox top = labels.above.value_or(MathBox{}), bottom = labels.below.value_or(MathBox{});

  // Everything stands about one middle; what sticks out to the left moves all to the right.
  const double middle = 0.5 * base.width;
  const double top_x = middle + 0.5 * lean - 0.5 * top.width;
  const double bottom_x = middle - 0.5 * lean - 0.5 * bottom.width;
  const double left = std::min({0.0, has_above ? top_x : 0.0, has_below ? bottom_x : 0.0});
  MathBox all = base;
  all.glyph.reset();
  all.attachment.reset();
  all.italic = 0.0;
  if (has_above) {
    const double rise = std::max(measure(gaps.above, style) + top.depth, measure(gaps.above_baseline, style));
    shift(labels.above_begin, labels.end, top_x, -(base.height + rise));
    all.height = base.height + rise + top.height;
    all.width = std::max(all.width, top_x + top.width);
  }
  if (has_below) {
    const double drop =
        std::max(measure(gaps.below, style) + bottom.height, measure(gaps.below_baseline, style));
    shift(labels.begin, labels.above_begin, bottom_x, base.depth + drop);
    all.depth = base.depth + drop + bottom.depth;
    all.width = std::max(all.width, bottom_x + bottom.width);
  }
  all.width -= left;
  shift(begin, -left, 0.0);
  return all;
}

}  // namespace polhode
