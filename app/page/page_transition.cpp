// SPDX-License-Identifier: MIT
#include "app/page/page_transition.h"

#include "render/drawing/fade.h"
#include "render/typeset/morph.h"

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

/// A piece of a page's column with the column's place.
struct Piece {
  const ColumnPiece* piece = nullptr;
  Vec2 corner{0, 0};

  explicit operator bool() const { return piece != nullptr; }
  const Sheet& sheet() const { return piece->sheet; }
};

Piece piece_of(const FittedText& text, const void* of) {
  for (const ColumnPiece& piece : text.stack.pieces)
    if (piece.of == of) return {&piece, text.corner};
  return {};
}

/// The equation that has been come to last, on this step or an earlier one.
Piece main_of(const FittedText& text) {
  Piece last;
  for (const ColumnPiece& piece : text.stack.pieces)
    if (piece.is_main) last = {&piece, text.corner};
  return last;
}

Vec2 between(const Vec2& a, const Vec2& b, double way) { return a + way * (b - a); }

/// As soft at both ends as a film's fade; all that comes before `begin` and after `end` is still.
double eased(double way, double begin, double end) {
  const double u = std::clamp((way - begin) / (end - begin), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

double morphed(double way) { return eased(way, 0.0, 1.0); }
double moved(double way) { return eased(way, 0.0, 0.7); }
double vanished(double way) { return eased(way, 0.0, 0.4); }

void fade(DisplayList& list, double opacity) {
  for (Glyph& glyph : list.glyphs) glyph.color.a = static_cast<float>(glyph.color.a * opacity);
  for (Rule& rule : list.rules) rule.color.a = static_cast<float>(rule.color.a * opacity);
}

bool same_letters(const DisplayList& a, const DisplayList& b) {
  return std::equal(a.glyphs.begin(), a.glyphs.end(), b.glyphs.begin(), b.glyphs.end(),
                    [](const Glyph& x, const Glyph& y) { return x.face == y.face && x.id == y.id; });
}

/// The same letters in lines of the same or another width: what stands on another line goes out and comes in.
DisplayList reflowed(const DisplayList& a, const DisplayList& b, double way) {
  constexpr double kOtherLine = 0.4;  // em
  DisplayList stays = a, arrives = b, goes, comes;
  goes.names = a.names, comes.names = b.names;
  stays.glyphs.clear(), arrives.glyphs.clear();
  for (std::size_t i = 0; i < a.glyphs.size(); ++i) {
    const Glyph &x = a.glyphs[i], &y = b.glyphs[i];
    const bool same_line = std::abs(y.y / y.size - x.y / x.size) < kOtherLine;
    (same_line ? stays : goes).glyphs.push_back(x);
    (same_line ? arrives : comes).glyphs.push_back(y);
  }
  DisplayList list = morph(stays, arrives, moved(way));
  fade(goes, 1.0 - vanished(way));
  fade(comes, appeared(way));
  append(list, goes, 0, 0);
  append(list, comes, 0, 0);
  return list;
}

PlacedType on_its_way(const PlacedType& a, const Vec2& a_corner, const PlacedType& b, const Vec2& b_corner,
                      double way) {
  const Vec2 first = a.at + a_corner, last = b.at + b_corner;
  PlacedType text = b;
  text.at = between(first, last, moved(way));
  if (a.list == b.list && first == last) return text;
  text.list =
      same_letters(a.list, b.list) ? reflowed(a.list, b.list, way) : morph(a.list, b.list, morphed(way));
  text.moving = true;
  return text;
}

/// Of the same kind and number of points.
bool alike(const FlatShape& a, const FlatShape& b) {
  const auto points = [](const FlatShape& shape) {
    return std::visit([](const auto& s) { return s.points.size(); }, shape);
  };
  return a.index() == b.index() && points(a) == points(b);
}

FlatShape between(const FlatShape& a, const Vec2& a_corner, FlatShape b, const Vec2& b_corner, double way) {
  std::visit(
      [&](auto& shape) {
        const auto& first = std::get<std::decay_t<decltype(shape)>>(a);
        for (std::size_t i = 0; i < shape.points.size(); ++i)
          shape.points[i] = between(first.points[i] + a_corner, shape.points[i] + b_corner, way);
      },
      b);
  return b;
}

/// Draws the way; `way` is the same for all.
class PageTransition {
 public:
  PageTransition(const FittedText& from, const FittedText& to, double way)
      : from_(from), to_(to), way_(way), main_before_(main_of(from)), main_(main_of(to)) {
    if (!main_before_ || !main_ || piece_of(from, main_.piece->of)) main_before_ = main_ = {};
  }

  Sheet draw() {
    for (const ColumnPiece& piece : from_.stack.pieces)
      if (!piece_of(to_, piece.of)) vanish({&piece, from_.corner});
    for (const ColumnPiece& piece : to_.stack.pieces) {
      const Piece there{&piece, to_.corner}, before = piece_of(from_, piece.of);
      if (before)
        move(before, there);
      else if (&piece == main_.piece)
        come_out_of_main_before();
      else
        appear(there, 0, std::nullopt);
    }
    return std::move(sheet_);
  }

 private:
  double leaving() const { return 1.0 - vanished(way_); }

  /// Without its first shapes, and without a text that goes its own way.
  void add_faded(const Piece& part, double opacity, std::size_t without_shapes,
                 std::optional<std::size_t> without_text) {
    Sheet sheet = part.sheet();
    sheet.shapes.erase(sheet.shapes.begin(),
                       sheet.shapes.begin() + static_cast<std::ptrdiff_t>(without_shapes));
    if (without_text) sheet.texts.erase(sheet.texts.begin() + static_cast<std::ptrdiff_t>(*without_text));
    append(sheet_, faded(std::move(sheet), opacity), part.corner);
  }

  void appear(const Piece& part, std::size_t without_shapes, std::optional<std::size_t> without_text) {
    add_faded(part, appeared(way_), without_shapes, without_text);
  }

  /// Panel and bar of a focus that goes on elsewhere go with it.
  std::size_t panel_that_leaves(const Piece& part) const {
    return part.piece == main_before_.piece ? part.piece->panel : 0;
  }

  void vanish(const Piece& part) { add_faded(part, leaving(), panel_that_leaves(part), std::nullopt); }

  /// What stands between the places of the line that flies steps back while it comes by.
  void step_back(PlacedType& text) const {
    if (!main_) return;
    constexpr double kLeast = 0.15;
    const auto& from = main_before_.piece->sheet.texts[*main_before_.piece->formula];
    const auto& to = main_.piece->sheet.texts[*main_.piece->formula];
    const double y0 = from.at.y() + main_before_.corner.y(), y1 = to.at.y() + main_.corner.y();
    const double top = std::min(y0 - from.list.ascent, y1 - to.list.ascent),
                 bottom = std::max(y0 + from.list.depth, y1 + to.list.depth);
    if (text.at.y() + text.list.depth < top || text.at.y() - text.list.ascent > bottom) return;
    const double on_the_way = morphed(way_);
    fade(text.list, 1.0 - (1.0 - kLeast) * 4.0 * on_the_way * (1.0 - on_the_way));
  }

  void move(const Piece& a, const Piece& b) {
    const std::size_t panel = panel_that_leaves(a);
    move_shapes(a, panel, b);
    const std::vector<PlacedType>&before = a.sheet().texts, &after = b.sheet().texts;
    if (before.size() == after.size()) {
      for (std::size_t i = 0; i < after.size(); ++i) {
        sheet_.texts.push_back(on_its_way(before[i], a.corner, after[i], b.corner, way_));
        step_back(sheet_.texts.back());
      }
      return;
    }
    // Whole on one page, an equation alone on the other.
    Sheet of_a, of_b;
    of_a.texts = before, of_b.texts = after;
    if (a.piece->formula && b.piece->formula) {
      const std::size_t i = *a.piece->formula, j = *b.piece->formula;
      sheet_.texts.push_back(on_its_way(before[i], a.corner, after[j], b.corner, way_));
      of_a.texts.erase(of_a.texts.begin() + static_cast<std::ptrdiff_t>(i));
      of_b.texts.erase(of_b.texts.begin() + static_cast<std::ptrdiff_t>(j));
    }
    append(sheet_, faded(std::move(of_a), leaving()), a.corner);
    append(sheet_, faded(std::move(of_b), appeared(way_)), b.corner);
  }

  void move_shapes(const Piece& a, std::size_t panel, const Piece& b) {
    const std::vector<FlatShape> before(a.sheet().shapes.begin() + static_cast<std::ptrdiff_t>(panel),
                                        a.sheet().shapes.end());
    const std::vector<FlatShape>& after = b.sheet().shapes;
    const bool pairwise = std::equal(before.begin(), before.end(), after.begin(), after.end(), alike);
    for (std::size_t i = 0; pairwise && i < after.size(); ++i)
      sheet_.shapes.push_back(between(before[i], a.corner, after[i], b.corner, moved(way_)));
    if (pairwise) return;
    Sheet of_a, of_b;
    of_a.shapes = before, of_b.shapes = after;
    append(sheet_, faded(std::move(of_a), leaving()), a.corner);
    append(sheet_, faded(std::move(of_b), appeared(way_)), b.corner);
  }

  void come_out_of_main_before() {
    const Piece &a = main_before_, &b = main_;
    // Where a step of words lies between, no panel is there to come.
    const std::size_t panel = std::min(a.piece->panel, b.piece->panel);
    for (std::size_t i = 0; i < panel; ++i)
      sheet_.shapes.push_back(
          between(a.sheet().shapes[i], a.corner, b.sheet().shapes[i], b.corner, morphed(way_)));
    const std::size_t i = *a.piece->formula, j = *b.piece->formula;
    appear(b, panel, j);
    PlacedType formula = b.sheet().texts[j];
    formula.at = between(a.sheet().texts[i].at + a.corner, formula.at + b.corner, morphed(way_));
    formula.list = morph(a.sheet().texts[i].list, formula.list, morphed(way_));
    formula.moving = true;
    sheet_.texts.push_back(std::move(formula));
  }

  const FittedText &from_, &to_;
  double way_;
  Piece main_before_, main_;  ///< both, or none: the new one comes out of the one before
  Sheet sheet_;
};

Sheet fading_in(const FittedText& text, double way) {
  Sheet sheet;
  for (const ColumnPiece& piece : text.stack.pieces)
    append(sheet, faded(piece.sheet, piece.is_new ? appeared(way) : 1.0), text.corner);
  return sheet;
}

}  // namespace

double appeared(double way) { return eased(way, 0.45, 1.0); }

Sheet column_on_its_way(const FittedText* from, const FittedText& to, double way) {
  return from ? PageTransition(*from, to, way).draw() : fading_in(to, way);
}

}  // namespace polhode
