// SPDX-License-Identifier: MIT
#include "app/session/page_symbols.h"

#include "render/typeset/rich_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {

namespace {

TypeBox united(const TypeBox& a, const TypeBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

TypeBox grown(const TypeBox& box, double by) { return {box.x0 - by, box.y0 - by, box.x1 + by, box.y1 + by}; }

TypeBox box_of(const Glyph& g, const Vec2& at, const Fonts& fonts) {
  const GlyphBox b = fonts.box(g.face, g.id);
  const double x = at.x() + g.x, y = at.y() + g.y;
  return {x + b.left * g.size, y - b.top * g.size, x + b.right * g.size, y - b.bottom * g.size};
}

/// About, without the font: of a line of type.
TypeBox line_box_of(const Glyph& g, const Vec2& at) {
  constexpr double kAbove = 0.75, kBelow = 0.25;  // of the size
  const double x = at.x() + g.x, y = at.y() + g.y;
  return {x, y - kAbove * g.size, x + 0.5 * g.size, y + kBelow * g.size};
}

TypeBox box_of(const Rule& r, const Vec2& at) {
  const double half = 0.5 * r.thickness;
  return grown({at.x() + std::min(r.x0, r.x1), at.y() + std::min(r.y0, r.y1), at.x() + std::max(r.x0, r.x1),
                at.y() + std::max(r.y0, r.y1)},
               half);
}

/// EulerTerms, or symbols, of one text: glyph after glyph.
class Runs {
 public:
  Runs(bool of_terms, std::vector<PageSymbol>& found) : of_terms_(of_terms), found_(found) {}

  std::int16_t index_in(const Naming& naming) const { return of_terms_ ? naming.term : naming.symbol; }

  void take(const Naming& naming, const TypeBox& box, const DisplayList& list) {
    const std::int16_t index = index_in(naming);
    const bool goes_on = index >= 0 && index == running_ && !is_on_next_line(box);
    if (index >= 0 && !goes_on) {
      runs_.push_back(found_.size());
      indices_.push_back(index);
      found_.push_back({list.names[static_cast<std::size_t>(index)], of_terms_, {}});
    }
    running_ = index;
    if (index >= 0) found_[runs_.back()].box = united(found_[runs_.back()].box, box);
  }

  /// A link in a text may go on where the next line begins: lower, and back to the left.
  bool is_on_next_line(const TypeBox& box) const {
    const PageSymbol& last = found_[runs_.back()];
    return is_link_name(last.name) && !box.empty() && !last.box.empty() && box.x0 < last.box.x1 &&
           box.y0 > last.box.y1;
  }

  /// Rules come after all glyphs: each belongs to the run of its name that is nearest.
  void take_rule(const Naming& naming, const TypeBox& box) {
    std::optional<std::size_t> nearest;
    double least = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (indices_[i] != index_in(naming)) continue;
      const TypeBox& run = found_[runs_[i]].box;
      const double off = std::hypot(run.x0 + run.x1 - box.x0 - box.x1, run.y0 + run.y1 - box.y0 - box.y1);
      if (!nearest || off < least) nearest = runs_[i], least = off;
    }
    if (nearest) found_[*nearest].box = united(found_[*nearest].box, box);
  }

 private:
  bool of_terms_;
  std::vector<PageSymbol>& found_;
  std::vector<std::size_t> runs_;  ///< places in found_
  std::vector<std::int16_t> indices_;
  std::int16_t running_ = -1;
};

void add_symbols(const PlacedType& text, const Fonts& fonts, std::vector<PageSymbol>& found) {
  if (text.list.names.empty()) return;
  const std::size_t first = found.size();
  TypeBox all;
  Runs terms(true, found), symbols(false, found);
  for (const Glyph& glyph : text.list.glyphs) {
    const bool is_named = glyph.naming != Naming{};
    const TypeBox box = is_named ? box_of(glyph, text.at, fonts) : TypeBox{};
    all = united(all, line_box_of(glyph, text.at));
    terms.take(glyph.naming, box, text.list);
    symbols.take(glyph.naming, box, text.list);
  }
  for (const Rule& rule : text.list.rules) {
    if (rule.naming == Naming{}) continue;
    terms.take_rule(rule.naming, box_of(rule, text.at));
    symbols.take_rule(rule.naming, box_of(rule, text.at));
  }
  for (std::size_t i = first; i < found.size(); ++i) found[i].around = all;
}

double distance(const TypeBox& box, const Vec2& point) {
  const double dx = std::max({box.x0 - point.x(), 0.0, point.x() - box.x1}),
               dy = std::max({box.y0 - point.y(), 0.0, point.y() - box.y1});
  return std::hypot(dx, dy);
}

double area(const TypeBox& box) { return (box.x1 - box.x0) * (box.y1 - box.y0); }

/// With round corners, from the middle of the upper left one on.
std::vector<Vec2> rounded_box(const TypeBox& box, double radius) {
  constexpr int kPoints = 6;  // of a corner
  const double r = std::min({radius, 0.5 * (box.x1 - box.x0), 0.5 * (box.y1 - box.y0)});
  const Vec2 middles[] = {
      {box.x0 + r, box.y0 + r}, {box.x1 - r, box.y0 + r}, {box.x1 - r, box.y1 - r}, {box.x0 + r, box.y1 - r}};
  std::vector<Vec2> points;
  for (int corner = 0; corner < 4; ++corner)
    for (int i = 0; i <= kPoints; ++i) {
      const double angle = 0.5 * std::numbers::pi * (2 + corner + static_cast<double>(i) / kPoints);
      points.emplace_back(middles[corner] + r * Vec2(std::cos(angle), std::sin(angle)));
    }
  return points;
}

}  // namespace

std::vector<PageSymbol> symbols_on(const Sheet& sheet, const Fonts& fonts) {
  std::vector<PageSymbol> found;
  for (const PlacedType& text : sheet.texts) add_symbols(text, fonts, found);
  std::erase_if(found, [](const PageSymbol& symbol) { return symbol.box.empty(); });
  return found;
}

std::optional<std::size_t> symbol_at(const std::vector<PageSymbol>& symbols, const Vec2& point,
                                     double reach) {
  std::optional<std::size_t> best;
  const auto is_better = [&](std::size_t i) {
    const PageSymbol &a = symbols[i], &b = symbols[*best];
    // What is under the pointer comes before what is near it.
    const bool a_under = distance(a.box, point) == 0.0, b_under = distance(b.box, point) == 0.0;
    return a_under != b_under ? a_under : area(a.box) < area(b.box);
  };
  for (std::size_t i = 0; i < symbols.size(); ++i)
    if (distance(symbols[i].box, point) <= reach && (!best || is_better(i))) best = i;
  return best;
}

std::vector<FlatShape> marks_of(const std::vector<PageSymbol>& symbols, const std::string& lit,
                                std::optional<std::size_t> focus, const Color& mark, const Color& ring,
                                double em) {
  const double radius = 0.17 * em;
  std::vector<FlatShape> shapes;
  for (const PageSymbol& symbol : symbols)
    if (!lit.empty() && symbol.name == lit)
      shapes.emplace_back(Area{rounded_box(grown(symbol.box, 0.11 * em), radius), mark});
  if (!focus || *focus >= symbols.size()) return shapes;
  Stroke around{.points = rounded_box(grown(symbols[*focus].box, 0.17 * em), radius),
                .width = std::max(1.5, 0.075 * em),
                .color = ring};
  around.points.push_back(around.points.front());
  shapes.emplace_back(std::move(around));
  return shapes;
}

}  // namespace polhode
