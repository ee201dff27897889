// SPDX-License-Identifier: MIT
#include "render/typeset/math/layout.h"

#include "render/typeset/characters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {

using Kind = MathNode::Kind;
namespace {

/// Thin, medium, thick space between atoms; negative: in display and text only; 9: cannot come.
constexpr int kSpacing[8][8] = {
    {0, 1, -2, -3, 0, 0, 0, -1},      // ordinary
    {1, 1, 9, -3, 0, 0, 0, -1},       // large operator
    {-2, -2, 9, 9, -2, 9, 9, -2},     // binary
    {-3, -3, 9, 0, -3, 0, 0, -3},     // relation
    {0, 0, 9, 0, 0, 0, 0, 0},         // opening
    {0, 1, -2, -3, 0, 0, 0, -1},      // closing
    {-1, -1, 9, -1, -1, -1, -1, -1},  // punctuation
    {-1, 1, -2, -3, -1, 0, -1, -1},   // inner
};

constexpr double kMu = 1.0 / 18.0;

double space_between(MathClass left, MathClass right, MathTextStyle style) {
  const int entry = kSpacing[static_cast<int>(left)][static_cast<int>(right)];
  if (entry == 9 || (entry < 0 && style.is_script())) return 0.0;
  constexpr std::array<double, 4> kSpaces = {0.0, 3 * kMu, 4 * kMu, 5 * kMu};
  return kSpaces[static_cast<std::size_t>(std::abs(entry))];
}

/// Rules 5 and 6: a binary operator without two operands is an ordinary sign.
void settle_classes(std::vector<MathAtom>& items, bool continues) {
  MathAtom before;
  MathAtom* last = continues ? &before : nullptr;
  for (MathAtom& item : items) {
    if (item.node->kind == Kind::space) continue;
    const bool no_left = last == nullptr || last->atom == MathClass::binary ||
                         last->atom == MathClass::large || last->atom == MathClass::relation ||
                         last->atom == MathClass::opening || last->atom == MathClass::punctuation;
    if (item.atom == MathClass::binary && no_left) item.atom = MathClass::ordinary;
    const bool no_right = item.atom == MathClass::relation || item.atom == MathClass::closing ||
                          item.atom == MathClass::punctuation;
    if (no_right && last != nullptr && last->atom == MathClass::binary) last->atom = MathClass::ordinary;
    last = &item;
  }
  const bool alone = continues && items.size() == 1;
  if (last != nullptr && last->atom == MathClass::binary && !alone) last->atom = MathClass::ordinary;
}

}  // namespace

Result<DisplayList, std::vector<TypeError>> MathLayout::run(const MathNode& root) {
  MathPaint paint;
  paint.color = style_.color;
  const MathTextStyle style{style_.display ? 0 : 1, false};
  std::vector<PlacedAtom> placed;
  const MathBox box = row(root, style, paint, &placed);
  out_.width = box.width;
  out_.ascent = std::max(box.height, 0.0);
  out_.depth = std::max(box.depth, 0.0);
  const bool too_wide = style_.line_width > 0.0 && box.width > style_.line_width;
  if (too_wide) break_lines(placed);
  if (!errors_.empty()) return Failure<std::vector<TypeError>>{std::move(errors_)};
  return std::move(out_);
}

double MathLayout::size(MathTextStyle s) const {
  if (s.level == 2) return style_.size * font_[HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN];
  if (s.level == 3) return style_.size * font_[HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN];
  return style_.size;
}

void MathLayout::shift(MathMark begin, MathMark end, double dx, double dy) {
  for (std::size_t i = begin.glyphs; i < end.glyphs; ++i) {
    out_.glyphs[i].x += dx;
    out_.glyphs[i].y += dy;
  }
  for (std::size_t i = begin.rules; i < end.rules; ++i) {
    Rule& r = out_.rules[i];
    r.x0 += dx;
    r.x1 += dx;
    r.y0 += dy;
    r.y1 += dy;
  }
}

void MathLayout::read_first(MathMark begin, MathMark made) {
  const auto at = [](auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
  std::rotate(at(out_.glyphs, begin.glyphs), at(out_.glyphs, made.glyphs), out_.glyphs.end());
}

void MathLayout::put_glyph(Face face, std::uint32_t id, double x, double y, double size,
                           const MathPaint& paint, SourceSpan source) {
  out_.glyphs.push_back({face, id, x, y, size, paint.color, paint.naming, source});
}

void MathLayout::put_rule(double x0, double y0, double x1, double y1, double thickness,
                          const MathPaint& paint, SourceSpan source) {
  out_.rules.push_back({x0, y0, x1, y1, thickness, paint.color, paint.naming, source});
}

void MathLayout::fail(SourceSpan at, char32_t character) {
  if (errors_.size() == kMaxTypeErrors) return;
  std::string shown;
  append_utf8(shown, character);
  errors_.push_back({at.begin, "the fonts lack " + shown + " (" + code_point_name(character) + ")", ""});
}

MathPaint MathLayout::named(const MathPaint& paint, const MathSymbol& symbol, bool sealed) {
  MathPaint p = paint;
  if (!p.fixed_color) p.color = symbol.color;
  p.naming.symbol = index_of(out_, symbol.name);
  p.sealed = sealed;
  return p;
}

void MathLayout::flatten(const MathNode& node, MathTextStyle& style, const MathPaint& paint,
                         std::vector<MathAtom>& into) {
  if (node.kind == Kind::row) return flatten_all(node.children, style, paint, into);
  const std::vector<MathNode>* one = nullptr;
  MathPaint inner = paint;
  if (node.kind == Kind::alphabet) {
    one = &node.children;
  } else if (node.kind == Kind::color) {
    inner.color = node.color;
    inner.fixed_color = true;
    one = &node.children;
  } else if (node.kind == Kind::term) {
    inner.naming.term = index_of(out_, node.text);
    one = &node.children;
  }
  if (one != nullptr) {
    MathTextStyle within = style;
    return flatten(one->front(), within, inner, into);
  }
  if (node.kind == Kind::style) {
    style.level = static_cast<int>(node.amount);
  } else if (!node.absent()) {
    into.push_back({&node, paint, style, node.atom, nullptr});
    if (!paint.sealed) into.back().base_symbol = symbols_.below_power(node);
  }
}

void MathLayout::flatten_all(const std::vector<MathNode>& children, MathTextStyle& style,
                             const MathPaint& paint, std::vector<MathAtom>& into) {
  for (std::size_t i = 0; i < children.size(); ++i) {
    const auto [symbol, count] = paint.sealed ? MathSymbols::Found{} : symbols_.at(children, i);
    if (symbol == nullptr) {
      flatten_child(children[i], style, paint, into);
      continue;
    }
    const MathPaint own = named(paint, *symbol, count == 1);
    for (std::size_t k = i; k < i + count; ++k) flatten_child(children[k], style, own, into);
    i += count - 1;
  }
}

void MathLayout::flatten_child(const MathNode& child, MathTextStyle& style, const MathPaint& paint,
                               std::vector<MathAtom>& into) {
  if (child.kind == Kind::row)
    into.push_back({&child, paint, style, child.atom, nullptr});
  else
    flatten(child, style, paint, into);
}

std::vector<MathAtom> MathLayout::items_of(const MathNode& node, MathTextStyle style, const MathPaint& paint,
                                           bool continues) {
  std::vector<MathAtom> items;
  if (node.absent()) return items;
  if (node.kind == Kind::row) {
    flatten(node, style, paint, items);
  } else {
    flatten_single(node, style, paint, items);
  }
  settle_classes(items, continues);
  return items;
}

void MathLayout::flatten_single(const MathNode& node, MathTextStyle style, const MathPaint& paint,
                                std::vector<MathAtom>& into) {
  const MathSymbol* symbol = paint.sealed ? nullptr : symbols_.of(node);
  const MathPaint own = symbol == nullptr ? paint : named(paint, *symbol, true);
  flatten(node, style, own, into);
}

MathBox MathLayout::row(const MathNode& node, MathTextStyle style, const MathPaint& paint,
                        std::vector<PlacedAtom>* placed, bool continues) {
  const std::vector<MathAtom> items = items_of(node, style, paint, continues);
  MathBox box;
  std::optional<MathClass> last;
  if (continues) last = MathClass::ordinary;
  for (const MathAtom& item : items) {
    if (item.node->kind == Kind::space) {
      if (placed != nullptr)
        placed->push_back({mark(), box.width, box.width, 0, 0, item.atom, item.node->amount});
      box.width += item.node->amount * size(item.style);
      continue;
    }
    if (last) box.width += space_between(*last, item.atom, item.style) * size(item.style);
    last = item.atom;
    const MathMark begin = mark();
    const MathBox part = atom(item);
    shift(begin, box.width, 0.0);
    const double x = box.width;
    if (items.size() == 1) {
      box.attachment = part.attachment;
      box.glyph = part.glyph;
    }
    box.width += part.width + part.italic;
    box.height = std::max(box.height, part.height);
    box.depth = std::max(box.depth, part.depth);
    if (placed != nullptr) placed->push_back({begin, x, box.width, part.height, part.depth, item.atom, 0.0});
  }
  return box;
}

MathBox MathLayout::nucleus(const MathNode& node, MathTextStyle style, const MathPaint& paint) {
  const std::vector<MathAtom> items = items_of(node, style, paint);
  if (items.size() == 1 && items.front().node->kind == Kind::row)
    return nucleus(*items.front().node, style, items.front().paint);
  if (items.size() == 1 && items.front().node->kind != Kind::space) return atom(items.front());
  return row(node, style, paint);
}

MathBox MathLayout::atom(const MathAtom& item) {
  const MathNode& node = *item.node;
  switch (node.kind) {
    case Kind::symbol:
      return symbol(item);
    case Kind::text:
      return text(item);
    case Kind::scripts:
      return scripts(item);
    case Kind::fraction:
      return fraction(item);
    case Kind::radical:
      return radical(item);
    case Kind::accent:
      return accent(item);
    case Kind::bar:
      return bar(item);
    case Kind::brace:
      return brace(item);
    case Kind::stacked:
      return stacked(item);
    case Kind::arrow:
      return arrow(item);
    case Kind::fenced:
      return fenced(item);
    case Kind::delimiter:
      return big_delimiter(item);
    case Kind::grid:
      return grid(item);
    case Kind::cancel:
      return cancel(item);
    case Kind::box:
      return framed(item);
    case Kind::phantom:
      return phantom(item);
    case Kind::row:
      return group(item);
    default:
      return {};
  }
}

Result<DisplayList, std::vector<TypeError>> set_math(const Math& math, const MathStyle& style,
                                                     const Fonts& fonts) {
  if (!math.root) return DisplayList{};
  return MathLayout(style, fonts).run(*with_decimals(math));
}

}  // namespace polhode
