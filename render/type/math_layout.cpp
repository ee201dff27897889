// SPDX-License-Identifier: MIT
// The rules named here are those of The TeXbook, Appendix G.
#include "render/type/characters.h"
#include "render/type/math.h"
#include "render/type/math_alphabets.h"
#include "render/type/math_delimiters.h"
#include "render/type/math_symbols.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace polhode {
namespace {

using Kind = MathNode::Kind;

/// Display, text, script, scriptscript; cramped: exponents stand lower.
struct Style {
  int level = 1;
  bool cramped = false;

  bool is_display() const { return level == 0; }
  bool is_script() const { return level >= 2; }
};
Style cramped(Style s) { return {s.level, true}; }
Style superscript(Style s) { return {std::min(s.level < 2 ? 2 : 3, 3), s.cramped}; }
Style subscript(Style s) { return {superscript(s).level, true}; }
Style numerator(Style s) { return {std::min(s.level + 1, 3), s.cramped}; }
Style denominator(Style s) { return {std::min(s.level + 1, 3), true}; }

struct Paint {
  Color color;
  bool fixed_color = false;  ///< \textcolor wins over the colour of symbols
  bool sealed = false;       ///< inside of a symbol of one atom none is looked for
  Naming naming;
};

/// How much of the list is made: what lies between two marks can be moved.
struct Mark {
  std::size_t glyphs = 0, rules = 0;
};

/// Something set with its origin at (0, 0): px, `height` and `depth` from the baseline.
struct Box {
  double width = 0, height = 0, depth = 0;
  double italic = 0;                   ///< correction, not part of the width
  std::optional<double> attachment;    ///< x of an accent's middle; none: the middle
  std::optional<std::uint32_t> glyph;  ///< it is this one, or has its shape below accents
};

/// One atom of a row.
struct Item {
  const MathNode* node = nullptr;
  Paint paint;
  Style style;
  MathClass atom = MathClass::ordinary;
  const MathSymbol* base_symbol = nullptr;  ///< nucleus and subscript of these scripts are a symbol
};

/// An item in its place: a line may be broken before it.
struct Placed {
  Mark begin;
  double x = 0;  ///< its left edge; the space before it lies to the left
  double end = 0;
  double height = 0, depth = 0;
  MathClass atom = MathClass::ordinary;
  double space = 0;  ///< of a space in the source, em
};

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

double space_between(MathClass left, MathClass right, Style style) {
  const int entry = kSpacing[static_cast<int>(left)][static_cast<int>(right)];
  if (entry == 9 || (entry < 0 && style.is_script())) return 0.0;
  constexpr std::array<double, 4> kSpaces = {0.0, 3 * kMu, 4 * kMu, 5 * kMu};
  return kSpaces[static_cast<std::size_t>(std::abs(entry))];
}

/// Rules 5 and 6: a binary operator without two operands is an ordinary sign.
void settle_classes(std::vector<Item>& items, bool continues) {
  Item before;
  Item* last = continues ? &before : nullptr;
  for (Item& item : items) {
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

class MathLayout {
 public:
  MathLayout(const MathStyle& style, const Fonts& fonts)
      : style_(style), fonts_(fonts), font_(fonts), symbols_(style.symbols) {}

  Result<DisplayList, std::vector<TypeError>> run(const MathNode& root) {
    Paint paint;
    paint.color = style_.color;
    const Style style{style_.display ? 0 : 1, false};
    std::vector<Placed> placed;
    const Box box = row(root, style, paint, &placed);
    out_.width = box.width;
    out_.ascent = std::max(box.height, 0.0);
    out_.depth = std::max(box.depth, 0.0);
    const bool too_wide = style_.display && style_.line_width > 0.0 && box.width > style_.line_width;
    if (too_wide) break_lines(placed);
    if (!errors_.empty()) return Failure<std::vector<TypeError>>{std::move(errors_)};
    return std::move(out_);
  }

 private:
  // --- measures -----------------------------------------------------------------------------------------

  double size(Style s) const {
    if (s.level == 2) return style_.size * font_[HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN];
    if (s.level == 3) return style_.size * font_[HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN];
    return style_.size;
  }
  double measure(hb_ot_math_constant_t constant, Style s) const { return font_[constant] * size(s); }
  double axis(Style s) const { return font_.axis() * size(s); }
  double rule_thickness(Style s) const { return font_.rule() * size(s); }

  // --- the list -----------------------------------------------------------------------------------------

  Mark mark() const { return {out_.glyphs.size(), out_.rules.size()}; }

  void shift(Mark begin, Mark end, double dx, double dy) {
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
  void shift(Mark begin, double dx, double dy) { shift(begin, mark(), dx, dy); }

  /// Glyphs made since `made` are read before those since `begin`.
  void read_first(Mark begin, Mark made) {
    const auto at = [](auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
    std::rotate(at(out_.glyphs, begin.glyphs), at(out_.glyphs, made.glyphs), out_.glyphs.end());
  }

  void put_glyph(Face face, std::uint32_t id, double x, double y, double size, const Paint& paint,
                 SourceSpan source) {
    out_.glyphs.push_back({face, id, x, y, size, paint.color, paint.naming, source});
  }

  void put_rule(double x0, double y0, double x1, double y1, double thickness, const Paint& paint,
                SourceSpan source) {
    out_.rules.push_back({x0, y0, x1, y1, thickness, paint.color, paint.naming, source});
  }

  void fail(SourceSpan at, char32_t character) {
    constexpr std::size_t kMostErrors = 16;
    if (errors_.size() == kMostErrors) return;
    std::string shown;
    append_utf8(shown, character);
    errors_.push_back({at.begin, "the fonts lack " + shown + " (" + code_point_name(character) + ")", ""});
  }

  // --- symbols of the lesson ----------------------------------------------------------------------------

  Paint named(const Paint& paint, const MathSymbol& symbol, bool sealed) {
    Paint p = paint;
    if (!p.fixed_color) p.color = symbol.color;
    p.naming.symbol = index_of(out_, symbol.name);
    p.sealed = sealed;
    return p;
  }

  // --- rows ---------------------------------------------------------------------------------------------

  /// The atoms of a row; those of terms, colours and alphabets are atoms of the row they stand in.
  void flatten(const MathNode& node, Style& style, const Paint& paint, std::vector<Item>& into) {
    if (node.kind == Kind::row) return flatten_all(node.children, style, paint, into);
    const std::vector<MathNode>* one = nullptr;
    Paint inner = paint;
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
      Style within = style;
      return flatten(one->front(), within, inner, into);
    }
    if (node.kind == Kind::style) {
      style.level = static_cast<int>(node.amount);
    } else if (!node.absent()) {
      into.push_back({&node, paint, style, node.atom, nullptr});
      if (!paint.sealed) into.back().base_symbol = symbols_.below_power(node);
    }
  }

  void flatten_all(const std::vector<MathNode>& children, Style& style, const Paint& paint,
                   std::vector<Item>& into) {
    for (std::size_t i = 0; i < children.size(); ++i) {
      const auto [symbol, count] = paint.sealed ? MathSymbols::Found{} : symbols_.at(children, i);
      if (symbol == nullptr) {
        flatten_child(children[i], style, paint, into);
        continue;
      }
      const Paint own = named(paint, *symbol, count == 1);
      for (std::size_t k = i; k < i + count; ++k) flatten_child(children[k], style, own, into);
      i += count - 1;
    }
  }

  /// A group in braces is one atom of its row.
  void flatten_child(const MathNode& child, Style& style, const Paint& paint, std::vector<Item>& into) {
    if (child.kind == Kind::row)
      into.push_back({&child, paint, style, child.atom, nullptr});
    else
      flatten(child, style, paint, into);
  }

  std::vector<Item> items_of(const MathNode& node, Style style, const Paint& paint, bool continues = false) {
    std::vector<Item> items;
    if (node.absent()) return items;
    if (node.kind == Kind::row) {
      flatten(node, style, paint, items);
    } else {
      flatten_single(node, style, paint, items);
    }
    settle_classes(items, continues);
    return items;
  }

  /// An argument without braces.
  void flatten_single(const MathNode& node, Style style, const Paint& paint, std::vector<Item>& into) {
    const MathSymbol* symbol = paint.sealed ? nullptr : symbols_.of(node);
    const Paint own = symbol == nullptr ? paint : named(paint, *symbol, true);
    flatten(node, style, own, into);
  }

  /// Contents of an argument, a cell, a group: atoms with the space between them. In a cell behind & the
  /// first atom stands as if something were before it.
  Box row(const MathNode& node, Style style, const Paint& paint, std::vector<Placed>* placed = nullptr,
          bool continues = false) {
    const std::vector<Item> items = items_of(node, style, paint, continues);
    Box box;
    std::optional<MathClass> last;
    if (continues) last = MathClass::ordinary;
    for (const Item& item : items) {
      if (item.node->kind == Kind::space) {
        if (placed != nullptr)
          placed->push_back({mark(), box.width, box.width, 0, 0, item.atom, item.node->amount});
        box.width += item.node->amount * size(item.style);
        continue;
      }
      if (last) box.width += space_between(*last, item.atom, item.style) * size(item.style);
      last = item.atom;
      const Mark begin = mark();
      const Box part = atom(item);
      shift(begin, box.width, 0.0);
      const double x = box.width;
      if (items.size() == 1) {
        box.attachment = part.attachment;
        box.glyph = part.glyph;
      }
      box.width += part.width + part.italic;
      box.height = std::max(box.height, part.height);
      box.depth = std::max(box.depth, part.depth);
      if (placed != nullptr)
        placed->push_back({begin, x, box.width, part.height, part.depth, item.atom, 0.0});
    }
    return box;
  }

  /// A field that is one atom keeps its shape: a character's scripts and accents stand closer.
  Box nucleus(const MathNode& node, Style style, const Paint& paint) {
    const std::vector<Item> items = items_of(node, style, paint);
    if (items.size() == 1 && items.front().node->kind == Kind::row)
      return nucleus(*items.front().node, style, items.front().paint);
    if (items.size() == 1 && items.front().node->kind != Kind::space) return atom(items.front());
    return row(node, style, paint);
  }

  Box atom(const Item& item) {
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

  /// Braces, or \mathrel{…}: its argument is its only child.
  Box group(const Item& item) { return row(*item.node, item.style, item.paint); }

  // --- characters ---------------------------------------------------------------------------------------

  struct Found {
    Face face = Face::math;
    std::uint32_t glyph = 0;
  };

  std::optional<Found> find_glyph(char32_t character, Alphabet alphabet, Style style) const {
    if (const auto glyph = fonts_.glyph(Face::math, in_alphabet(character, alphabet))) {
      const bool small = style.is_script();
      return Found{Face::math, small ? font_.script_form(*glyph, style.level - 1) : *glyph};
    }
    for (const Face face : {Face::math, Face::serif, Face::sans})
      if (const auto glyph = fonts_.glyph(face, character)) return Found{face, *glyph};
    return std::nullopt;
  }

  Box symbol(const Item& item) {
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

  Box plain_glyph(const Found& found, const Item& item) {
    const double s = size(item.style);
    const GlyphBox ink = fonts_.box(found.face, found.glyph);
    put_glyph(found.face, found.glyph, 0, 0, s, item.paint, item.node->span);
    return {fonts_.advance(found.face, found.glyph) * s, ink.top * s, -ink.bottom * s, 0, {}, {}};
  }

  Box math_glyph(std::uint32_t glyph, const Item& item) {
    const double s = size(item.style);
    const GlyphBox ink = fonts_.box(Face::math, glyph);
    put_glyph(Face::math, glyph, 0, 0, s, item.paint, item.node->span);
    Box box{fonts_.advance(Face::math, glyph) * s, ink.top * s, -ink.bottom * s, 0, {}, glyph};
    box.italic = font_.italic_correction(glyph) * s;
    box.attachment = font_.top_accent_attachment(glyph) * s;
    return box;
  }

  /// Rule 13: larger in displays, its middle on the axis.
  Box large_operator(std::uint32_t glyph, const Item& item) {
    if (item.style.is_display())
      glyph = stretched_single(glyph, font_[HB_OT_MATH_CONSTANT_DISPLAY_OPERATOR_MIN_HEIGHT]);
    const Mark begin = mark();
    Box box = math_glyph(glyph, item);
    const double drop = 0.5 * (box.height - box.depth) - axis(item.style);
    shift(begin, 0.0, drop);
    box.height -= drop;
    box.depth += drop;
    box.italic = 0.0;
    box.attachment.reset();
    return box;
  }

  std::uint32_t stretched_single(std::uint32_t glyph, double length) const {
    const StretchedGlyph found = stretched(font_, glyph, Stretch::vertical, length);
    if (!found.joined) return found.parts.front().glyph;
    // A sign in parts is not for this: the largest whole one.
    for (double l = length; l > 0.0; l *= 0.9) {
      const StretchedGlyph smaller = stretched(font_, glyph, Stretch::vertical, l);
      if (!smaller.joined) return smaller.parts.front().glyph;
    }
    return glyph;
  }

  Box text(const Item& item) {
    const MathNode& node = *item.node;
    const double s = size(item.style);
    Box box;
    for (const ShapedGlyph& g : fonts_.shape(node.face, node.text)) {
      const Cluster cluster = cluster_at(node, g.cluster);
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

  void put_text_glyph(Face face, std::uint32_t id, double x, double y, double s, const Paint& paint,
                      SourceSpan source, Box& box) {
    const GlyphBox ink = fonts_.box(face, id);
    if (!(ink.left < ink.right)) return;  // a space
    put_glyph(face, id, x, y, s, paint, source);
    box.height = std::max(box.height, ink.top * s - y);
    box.depth = std::max(box.depth, y - ink.bottom * s);
  }

  struct Cluster {
    char32_t character = 0;
    SourceSpan source;
  };
  /// The character at a byte of a text; its source reaches to the next glyph's at most.
  static Cluster cluster_at(const MathNode& node, std::size_t byte) {
    std::size_t at = 0, index = 0;
    Cluster cluster;
    while (at < node.text.size() && at <= byte) {
      cluster.character = next_character(node.text, at);
      cluster.source = node.sources[std::min(index, node.sources.size() - 1)];
      ++index;
    }
    return cluster;
  }

  // --- scripts ------------------------------------------------------------------------------------------

  /// Rule 18.
  Box scripts(const Item& item) {
    const MathNode& node = *item.node;
    if (has_limits(node, item.style)) return limits(item);
    const Style style = item.style;
    const MathNode& below = node.children[1];
    const MathNode& above = node.children[2];
    Paint base_paint = item.paint, below_paint = item.paint;
    if (item.base_symbol != nullptr) base_paint = below_paint = named(item.paint, *item.base_symbol, true);

    Box box = nucleus(node.children[0], style, base_paint);
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

    const Mark below_begin = mark();
    const Box sub = below.absent() ? Box{} : row(below, subscript(style), below_paint);
    const Mark above_begin = mark();
    const Box sup = above.absent() ? Box{} : row(above, superscript(style), item.paint);

    raise = std::max({raise,
                      measure(style.cramped ? HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED
                                            : HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP,
                              style),
                      sup.depth + measure(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MIN, style)});
    lower = std::max({lower, measure(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN, style),
                      sub.height - measure(HB_OT_MATH_CONSTANT_SUBSCRIPT_TOP_MAX, style)});
    if (!above.absent() && !below.absent()) keep_scripts_apart(sub, sup, style, raise, lower);

    const double sup_kern = is_character && !above.absent()
                                ? corner_kern(box, above_begin, mark(), raise, sup, style, true)
                                : 0.0;
    const double sub_kern = is_character && !below.absent()
                                ? corner_kern(box, below_begin, above_begin, lower, sub, style, false)
                                : 0.0;
    shift(below_begin, above_begin, sub_x + sub_kern, lower);
    shift(above_begin, mark(), sup_x + sup_kern, -raise);

    const double after = measure(HB_OT_MATH_CONSTANT_SPACE_AFTER_SCRIPT, style);
    Box all = box;
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

  /// Rule 18e.
  void keep_scripts_apart(const Box& sub, const Box& sup, Style style, double& raise, double& lower) const {
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

  /// Moves a script to its base as far as the corners of both allow, at the script's near edge and at the
  /// base's far edge.
  double corner_kern(const Box& base, Mark begin, Mark end, double offset, const Box& script, Style style,
                     bool above) const {
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

  static bool has_limits(const MathNode& node, Style style) {
    return node.limits == Limits::above_below || (node.limits == Limits::in_display && style.is_display());
  }

  /// Rule 13a.
  Box limits(const Item& item) {
    const MathNode& node = *item.node;
    const Style style = item.style;
    const Mark begin = mark();
    const Box base = with_italic(nucleus(node.children[0], style, item.paint));
    const bool leans = base.glyph.has_value() && node.children[0].atom == MathClass::large;
    const double lean = leans ? font_.italic_correction(*base.glyph) * size(style) : 0.0;
    return above_and_below(
        item, begin, base, node.children[2], node.children[1], lean,
        {HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN,
         HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN});
  }

  struct Gaps {
    hb_ot_math_constant_t above, above_baseline, below, below_baseline;
  };

  /// The base is what was made since `begin`.
  Box above_and_below(const Item& item, Mark begin, const Box& base, const MathNode& above,
                      const MathNode& below, double lean, const Gaps& gaps) {
    const Style style = item.style;
    const Mark above_begin = mark();
    const Box top = above.absent() ? Box{} : row(above, superscript(style), item.paint);
    const Mark below_begin = mark();
    const Box bottom = below.absent() ? Box{} : row(below, subscript(style), item.paint);
    const Mark end = mark();

    // Everything stands about one middle; what sticks out to the left moves all to the right.
    const double middle = 0.5 * base.width;
    const double top_x = middle + 0.5 * lean - 0.5 * top.width;
    const double bottom_x = middle - 0.5 * lean - 0.5 * bottom.width;
    const double left = std::min({0.0, above.absent() ? 0.0 : top_x, below.absent() ? 0.0 : bottom_x});
    Box all = base;
    all.glyph.reset();
    all.attachment.reset();
    all.italic = 0.0;
    if (!above.absent()) {
      const double rise =
          std::max(measure(gaps.above, style) + top.depth, measure(gaps.above_baseline, style));
      shift(above_begin, below_begin, top_x, -(base.height + rise));
      all.height = base.height + rise + top.height;
      all.width = std::max(all.width, top_x + top.width);
    }
    if (!below.absent()) {
      const double drop =
          std::max(measure(gaps.below, style) + bottom.height, measure(gaps.below_baseline, style));
      shift(below_begin, end, bottom_x, base.depth + drop);
      all.depth = base.depth + drop + bottom.depth;
      all.width = std::max(all.width, bottom_x + bottom.width);
    }
    all.width -= left;
    shift(begin, -left, 0.0);
    return all;
  }

  // --- fractions and radicals ---------------------------------------------------------------------------

  /// Rule 15.
  Box fraction(const Item& item) {
    const MathNode& node = *item.node;
    Style style = item.style;
    if (node.forced_style >= 0) style.level = node.forced_style;
    const bool display = style.is_display();
    const bool has_bar = node.amount > 0.0;
    const double thickness = has_bar ? rule_thickness(style) : 0.0;
    const Mark top_begin = mark();
    const Box top = row(node.children[0], numerator(style), item.paint);
    const Mark bottom_begin = mark();
    const Box bottom = row(node.children[1], denominator(style), item.paint);
    const Mark end = mark();

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
          display ? HB_OT_MATH_CONSTANT_STACK_DISPLAY_STYLE_GAP_MIN : HB_OT_MATH_CONSTANT_STACK_GAP_MIN,
          style);
      const double lacking = least - ((up - top.depth) - (bottom.height - down));
      if (lacking > 0.0) {
        up += 0.5 * lacking;
        down += 0.5 * lacking;
      }
    }
    const double width = std::max(top.width, bottom.width);
    Box box;
    box.height = up + top.height;
    box.depth = down + bottom.depth;

    const double opening =
        node.binomial ? fraction_delimiter(U'(', item, style, box, 0.0) : kNoDelimiter * size(style);
    shift(top_begin, bottom_begin, opening + 0.5 * (width - top.width), -up);
    shift(bottom_begin, end, opening + 0.5 * (width - bottom.width), down);
    if (has_bar) put_rule(opening, -middle, opening + width, -middle, thickness, item.paint, node.span);
    const double closing = node.binomial ? fraction_delimiter(U')', item, style, box, opening + width)
                                         : kNoDelimiter * size(style);
    if (node.binomial) open_first(top_begin, end);
    box.width = opening + width + closing;
    return box;
  }

  /// TeX's \nulldelimiterspace of 1.2 pt, em.
  static constexpr double kNoDelimiter = 0.12;

  /// Around \binom; its width.
  double fraction_delimiter(char32_t character, const Item& item, Style style, const Box& inside, double x) {
    const double half = std::max(inside.height - axis(style), inside.depth + axis(style));
    const Mark begin = mark();
    const Box made = delimiter(character, delimiter_length(half, style), style, item.paint, item.node->span);
    shift(begin, x, 0.0);
    return made.width;
  }

  /// The first glyph of those made since `made` is read before those since `begin`.
  void open_first(Mark begin, Mark made) {
    const auto at = [this](std::size_t i) { return out_.glyphs.begin() + static_cast<std::ptrdiff_t>(i); };
    if (made.glyphs < out_.glyphs.size()) std::rotate(at(begin.glyphs), at(made.glyphs), at(made.glyphs) + 1);
  }

  /// Rule 11, with the sign's foot and the degree as the MATH table has it.
  Box radical(const Item& item) {
    const MathNode& node = *item.node;
    const Style style = item.style;
    const double s = size(style);
    const double thickness = measure(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS, style);
    double gap = measure(style.is_display() ? HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP
                                            : HB_OT_MATH_CONSTANT_RADICAL_VERTICAL_GAP,
                         style);
    const MathNode& degree = node.children[1];
    const Mark begin = mark();
    const Box degree_box = degree.absent() ? Box{} : row(degree, {3, true}, item.paint);
    const Mark inside_begin = mark();
    const Box inside = row(node.children[0], cramped(style), item.paint);
    const Mark inside_end = mark();

    const auto root = fonts_.glyph(Face::math, U'√');
    if (!root) {
      fail(node.span, U'√');
      return inside;
    }
    const double wanted = inside.height + inside.depth + gap + thickness;
    const StretchedGlyph sign = stretched(font_, *root, Stretch::vertical, wanted / s);
    const Box sign_box = put_vertical(sign, 0.0, style, item.paint, node.span);
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

    Box box;
    box.width = rule_x + inside.width;
    box.height = top + measure(HB_OT_MATH_CONSTANT_RADICAL_EXTRA_ASCENDER, style);
    box.depth = std::max(inside.depth, sign_height - top);
    if (!degree.absent()) box.height = std::max(box.height, degree_rise + degree_box.height);
    return box;
  }

  // --- delimiters ---------------------------------------------------------------------------------------

  /// A vertical stretch, its lower end `bottom` above the baseline if it is of parts; one glyph stands as the
  /// font has it.
  Box put_vertical(const StretchedGlyph& sign, double bottom, Style style, const Paint& paint,
                   SourceSpan span) {
    const double s = size(style);
    Box box;
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

  /// Rule 19: how long a delimiter around contents that reach `half` from the axis is.
  double delimiter_length(double half, Style style) const {
    constexpr double kFactor = 0.901, kShortfall = 0.5;
    return std::max(2.0 * half * kFactor, 2.0 * half - kShortfall * size(style));
  }

  /// A delimiter of at least the length, centred on the axis.
  Box delimiter(char32_t character, double length, Style style, const Paint& paint, SourceSpan span) {
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
    const Mark begin = mark();
    Box box = put_vertical(sign, 0.0, style, paint, span);
    const double drop = 0.5 * (box.height - box.depth) - axis(style);
    shift(begin, 0.0, drop);
    box.height -= drop;
    box.depth += drop;
    box.glyph.reset();
    return box;
  }

  /// Tall bars are rules: even, and without joints.
  Box bars(char32_t character, double length, Style style, const Paint& paint, SourceSpan span) {
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

  Box big_delimiter(const Item& item) {
    constexpr double kFactor = 0.901;
    return delimiter(item.node->character, kFactor * item.node->amount * style_.size, item.style, item.paint,
                     item.node->span);
  }

  Box fenced(const Item& item) {
    const MathNode& node = *item.node;
    const Style style = item.style;
    const std::size_t parts = node.children.size() / 2;
    std::vector<Box> rows;
    std::vector<Mark> begins;
    double half = 0.0;
    Box box;
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
      const Mark begin = mark();
      const Box made = delimiter(d.character, length, style, item.paint, d.span);
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

  // --- above, below, around -----------------------------------------------------------------------------

  /// Rule 12.
  Box accent(const Item& item) {
    const MathNode& node = *item.node;
    const Style style = item.style;
    const double s = size(style);
    const Box base = dotless_base(node.children[0], cramped(style), item.paint);
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
    Box box = base;
    box.height = std::max(base.height, rise + ink.top * s);
    box.attachment = base_middle;
    return box;
  }

  static bool is_arrow(char32_t accent) { return accent == 0x20D7 || accent == 0x20D6 || accent == 0x20E1; }

  std::optional<std::uint32_t> accent_glyph(const MathNode& node, double base_em) const {
    const auto glyph = fonts_.glyph(Face::math, node.character);
    if (!glyph || !node.wide || is_arrow(node.character)) return glyph;
    return widest_form_within(font_, *glyph, base_em);
  }

  /// Where an accent's middle is; four dots are drawn by the font beside their attachment.
  double middle_of_accent(std::uint32_t glyph, const GlyphBox& ink) const {
    const double attachment = font_.top_accent_attachment(glyph);
    const bool inside = ink.left <= attachment && attachment <= ink.right;
    return inside ? attachment : 0.5 * (ink.left + ink.right);
  }

  /// i and j lose their dots below accents.
  Box dotless_base(const MathNode& node, Style style, const Paint& paint) {
    std::vector<Item> items = items_of(node, style, paint);
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

  /// An arrow as wide as what stands below it.
  Box arrow_accent(const Item& item, const Box& base, std::uint32_t glyph) {
    const Style style = item.style;
    const double s = size(style);
    const double base_width = base.width + base.italic;
    const StretchedGlyph arrow = stretched(font_, glyph, Stretch::horizontal, base_width / s);
    const double rise = std::max(0.0, base.height - measure(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT, style));
    const Mark begin = mark();
    const Box made = put_horizontal(arrow, style, item.paint, item.node->span);
    shift(begin, 0.5 * (base_width - made.width), -rise);
    Box box = base;
    box.width = base_width;
    box.italic = 0.0;
    box.glyph.reset();
    box.height = std::max(base.height, made.height + rise);
    return box;
  }

  /// From x = 0; parts stand at the font's own height.
  Box put_horizontal(const StretchedGlyph& sign, Style style, const Paint& paint, SourceSpan span) {
    const double s = size(style);
    Box box;
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

  /// Rules 9 and 10.
  Box bar(const Item& item) {
    const MathNode& node = *item.node;
    const Style style = item.style;
    const bool above = node.character == U'-';
    Box box = row(node.children[0], above ? cramped(style) : style, item.paint);
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

  Box brace(const Item& item) {
    const MathNode& node = *item.node;
    const Style style = item.style;
    const double s = size(style);
    Box box = row(node.children[0], style, item.paint);
    const auto glyph = fonts_.glyph(Face::math, node.character);
    if (!glyph) {
      fail(node.span, node.character);
      return box;
    }
    const bool above = node.character == U'⏞';
    const StretchedGlyph sign = stretched(font_, *glyph, Stretch::horizontal, box.width / s);
    const Mark begin = mark();
    const Box made = put_horizontal(sign, style, item.paint, node.span);
    constexpr double kGap = 0.1;
    const double y = above ? -(box.height + kGap * s + made.depth) : box.depth + kGap * s + made.height;
    shift(begin, 0.5 * (box.width - made.width), y);
    const double grown = kGap * s + made.height + made.depth;
    (above ? box.height : box.depth) += grown;
    box.glyph.reset();
    box.attachment.reset();
    return box;
  }

  Box stacked(const Item& item) {
    const MathNode& node = *item.node;
    const Mark begin = mark();
    const Box base = with_italic(nucleus(node.children[0], item.style, item.paint));
    return above_and_below(
        item, begin, base, node.children[1], node.children[2], 0.0,
        {HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN,
         HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN, HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN});
  }

  static Box with_italic(Box box) {
    box.width += box.italic;
    box.italic = 0.0;
    return box;
  }

  /// \xrightarrow: as long as its labels.
  Box arrow(const Item& item) {
    const MathNode& node = *item.node;
    const Style style = item.style;
    const double s = size(style);
    const Mark begin = mark();
    const double above = row(node.children[0], superscript(style), item.paint).width;
    const double below =
        node.children[1].absent() ? 0.0 : row(node.children[1], subscript(style), item.paint).width;
    out_.glyphs.resize(begin.glyphs);
    out_.rules.resize(begin.rules);
    const auto glyph = fonts_.glyph(Face::math, node.character);
    if (!glyph) {
      fail(node.span, node.character);
      return {};
    }
    constexpr double kAround = 0.6, kLeast = 1.2, kSide = 0.08;
    const double wanted = std::max({above + kAround * s, below + kAround * s, kLeast * s});
    const Mark arrow_begin = mark();
    Box made = put_horizontal(stretched(font_, *glyph, Stretch::horizontal, wanted / s), style, item.paint,
                              node.span);
    shift(arrow_begin, kSide * s, 0.0);
    made.width += 2.0 * kSide * s;
    return above_and_below(
        item, arrow_begin, made, node.children[0], node.children[1], 0.0,
        {HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_ABOVE_MIN, HB_OT_MATH_CONSTANT_STRETCH_STACK_TOP_SHIFT_UP,
         HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_BELOW_MIN, HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_BELOW_MIN});
  }

  Box cancel(const Item& item) {
    const MathNode& node = *item.node;
    const double s = size(item.style);
    const Box box = with_italic(nucleus(node.children[0], item.style, item.paint));
    constexpr double kBeyond = 0.06;
    const double left = -kBeyond * s, right = box.width + kBeyond * s;
    const double top = -(box.height + kBeyond * s), bottom = box.depth + kBeyond * s;
    const double thickness = 0.9 * rule_thickness(item.style);
    const auto stroke = [&](double y0, double y1) {
      put_rule(left, y0, right, y1, thickness, item.paint, node.span);
    };
    if (node.character == U'n') {
      const double middle = 0.5 * box.width, half = 0.2 * s, tall = 0.4 * s;
      put_rule(middle - half, -axis(item.style) + tall, middle + half, -axis(item.style) - tall, thickness,
               item.paint, node.span);
    }
    if (node.character == U'/' || node.character == U'x') stroke(bottom, top);
    if (node.character == U'\\' || node.character == U'x') stroke(top, bottom);
    Box all = box;
    all.glyph.reset();
    return all;
  }

  Box framed(const Item& item) {
    const double s = size(item.style);
    const Mark begin = mark();
    const Box inside = row(item.node->children[0], item.style, item.paint);
    constexpr double kSeparation = 0.3;
    const double thickness = 0.8 * rule_thickness(item.style), half = 0.5 * thickness;
    const double room = kSeparation * s + thickness;
    shift(begin, room, 0.0);
    const double right = inside.width + 2.0 * room, top = -(inside.height + room),
                 bottom = inside.depth + room;
    const auto put = [&](double x0, double y0, double x1, double y1) {
      put_rule(x0, y0, x1, y1, thickness, item.paint, item.node->span);
    };
    put(0, top + half, right, top + half);
    put(0, bottom - half, right, bottom - half);
    put(half, top + thickness, half, bottom - thickness);
    put(right - half, top + thickness, right - half, bottom - thickness);
    return {right, -top, bottom, 0, {}, {}};
  }

  Box phantom(const Item& item) {
    const Mark begin = mark();
    const Box inside = row(item.node->children[0], item.style, item.paint);
    out_.glyphs.resize(begin.glyphs);
    out_.rules.resize(begin.rules);
    const int kept = static_cast<int>(item.node->amount);
    Box box;
    if ((kept & 1) != 0) box.width = inside.width;
    if ((kept & 2) != 0) {
      box.height = inside.height;
      box.depth = inside.depth;
    }
    return box;
  }

  // --- grids --------------------------------------------------------------------------------------------

  /// How a kind of grid is spaced, em: TeX's struts and skips for a ten-point font on twelve points.
  struct Spacing {
    double strut_height = 0, strut_depth = 0;  ///< of each row at least
    double leading = 0;                        ///< more between rows
    double gap = 0;                            ///< between ink of neighbouring rows at least
    double between = 0;                        ///< columns
    double outside = 0;
    bool trimmed = false;  ///< the struts of the first and the last row do not count outwards
  };
  static Spacing spacing_of(const MathGrid& grid) {
    switch (grid.kind) {
      case MathGrid::Kind::aligned:
      case MathGrid::Kind::gathered:
        return {0.84, 0.36, 0.3, 0.3, 1.0, 0, true};
      case MathGrid::Kind::cases:
        return {1.008, 0.432, 0, 0.12, 1.0, 0};
      case MathGrid::Kind::small:
        return {0, 0, 0, 0.2, 0.36, grid.columns > 1 ? 0.22 : 0.0};
      case MathGrid::Kind::array:
        return {0.84, 0.36, 0, 0.12, 1.0, 0.5};
      default:
        return {0.84, 0.36, 0, 0.12, 1.0, 0};
    }
  }

  static Style cell_style(MathGrid::Kind kind, Style style) {
    if (kind == MathGrid::Kind::aligned || kind == MathGrid::Kind::gathered)
      return {style.is_script() ? style.level : 0, false};
    if (kind == MathGrid::Kind::small) return {std::max(style.level, 2), style.cramped};
    return {std::max(style.level, 1), style.cramped};
  }

  /// Part of the room beside a cell that goes to its left.
  static double room_left(const MathGrid& grid, std::size_t column) {
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

  Box grid(const Item& item) {
    const MathNode& node = *item.node;
    const MathGrid& grid = *node.grid;
    const Style style = cell_style(grid.kind, item.style);
    const Spacing spacing = spacing_of(grid);
    const double s = size(style);
    const auto columns = static_cast<std::size_t>(std::max(grid.columns, 1));
    const std::size_t rows = node.children.size() / columns;

    const Mark begin = mark();
    std::vector<Mark> begins;
    std::vector<Box> cells;
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
    const Mark cells_end = mark();
    grid_lines(item, grid, lefts, widths, baselines, heights, depths, width, top, spacing.between * s);

    Box box{width, -top, top + total, 0, {}, {}};
    const double length = delimiter_length(0.5 * total, item.style);
    if (grid.left != 0) {
      shift(begin, delimiter_width(grid.left, length, item.style), 0.0);
      const Box left = delimiter(grid.left, length, item.style, item.paint, node.span);
      read_first(begin, cells_end);
      box = beside(box, left);
    } else if (grid.right != 0) {
      shift(begin, kNoDelimiter * s, 0.0);
      box.width += kNoDelimiter * s;
    }
    if (grid.right != 0) {
      const Mark at = mark();
      const Box right = delimiter(grid.right, length, item.style, item.paint, node.span);
      shift(at, box.width, 0.0);
      box = beside(box, right);
    } else if (grid.left != 0) {
      box.width += kNoDelimiter * s;
    }
    return box;
  }

  static Box beside(const Box& a, const Box& b) {
    return {a.width + b.width, std::max(a.height, b.height), std::max(a.depth, b.depth), 0, {}, {}};
  }

  /// Measured by setting it once.
  double delimiter_width(char32_t character, double length, Style style) {
    const Mark begin = mark();
    const double width = delimiter(character, length, style, {}, {}).width;
    out_.glyphs.resize(begin.glyphs);
    out_.rules.resize(begin.rules);
    return width;
  }

  static double ink_height(const std::vector<Box>& cells, std::size_t columns, std::size_t r) {
    double height = 0.0;
    for (std::size_t c = 0; c < columns; ++c) height = std::max(height, cells[r * columns + c].height);
    return height;
  }
  static double ink_depth(const std::vector<Box>& cells, std::size_t columns, std::size_t r) {
    double depth = 0.0;
    for (std::size_t c = 0; c < columns; ++c) depth = std::max(depth, cells[r * columns + c].depth);
    return depth;
  }

  void grid_lines(const Item& item, const MathGrid& grid, const std::vector<double>& lefts,
                  const std::vector<double>& widths, const std::vector<double>& baselines,
                  const std::vector<double>& heights, const std::vector<double>& depths, double width,
                  double top, double between) {
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

  // --- lines of a long display --------------------------------------------------------------------------

  struct Line {
    std::size_t begin = 0, end = 0;  ///< items
  };

  /// How gladly a line is broken before an item: 0 at a wide space, 1 at a relation, 2 at a binary operator,
  /// 3 never.
  static int break_rank(const Placed& placed) {
    constexpr double kWide = 0.99;
    if (placed.space >= kWide) return 0;
    if (placed.space != 0.0) return 3;
    if (placed.atom == MathClass::relation) return 1;
    return placed.atom == MathClass::binary ? 2 : 3;
  }

  /// Items [begin, end) of the line that begins at `begin`: as many as fit, and rather up to a relation than
  /// to a binary operator.
  Line line_from(const std::vector<Placed>& placed, std::size_t begin, double room) const {
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

  void break_lines(const std::vector<Placed>& placed) {
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
      const Mark end = line.end < placed.size() ? placed[line.end].begin : mark();
      shift(placed[line.begin].begin, end, left - placed[line.begin].x, y);
      out_.width = std::max(out_.width, left + placed[line.end - 1].end - placed[line.begin].x);
      last_depth = depth;
      begin = line.end;
    }
    out_.depth = y + last_depth;
  }

  const MathStyle& style_;
  const Fonts& fonts_;
  MathFont font_;
  MathSymbols symbols_;
  DisplayList out_;
  std::vector<TypeError> errors_;
};

}  // namespace

Result<DisplayList, std::vector<TypeError>> set_math(const Math& math, const MathStyle& style,
                                                     const Fonts& fonts) {
  if (!math.root) return DisplayList{};
  return MathLayout(style, fonts).run(*math.root);
}

}  // namespace polhode
