// SPDX-License-Identifier: MIT
#include "render/drawing/plots/plot_style.h"

#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace polhode {
namespace {

struct LookStyle {
  Color ink;          ///< at least 5.2:1 on paper
  Color first, last;  ///< paints of its first and last curve
  std::vector<MarkShape> shapes;
  bool hollow;
};

const LookStyle& style_of(PlotLook look) {
  using M = MarkShape;
  // Light and dark as well as hue: the four hues differ for colour-blind readers and in grey.
  static const LookStyle kGrey{
      kAxesRole.ink, kAxesRole.paint, kAxesRole.ink, {M::disc, M::square, M::diamond}, false};
  static const LookStyle kOrange{
      kOmegaRole.ink,
      color_from_hex(0xE58A2E),
      kOmegaRole.ink,
      {M::triangle_down, M::square, M::disc, M::diamond, M::triangle_up, M::hexagon},
      false};
  static const LookStyle kBlue{kLRole.ink,
                               color_from_hex(0x2E9BD6),
                               color_from_hex(0x2B3C8F),
                               {M::triangle_up, M::square, M::diamond, M::disc, M::triangle_down, M::hexagon},
                               true};
  static const LookStyle kPurple{
      kNRole.ink, kNRole.paint, color_from_hex(0x8A3A6B), {M::plus, M::cross}, false};
  static const LookStyle kStar{kPolhodeRole.ink, kPolhodeRole.paint, kPolhodeRole.paint, {M::star}, false};
  switch (look) {
    case PlotLook::orange:
      return kOrange;
    case PlotLook::blue:
      return kBlue;
    case PlotLook::purple:
      return kPurple;
    case PlotLook::star:
      return kStar;
    case PlotLook::grey:
      break;
  }
  return kGrey;
}

/// Corners on a circle, the first at `turn` from the right, counted downwards; of a star every other one lies
/// further in.
std::vector<Vec2> ring(const Vec2& at, double radius, int corners, double turn, double inner = 1.0) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * i / corners;
    points.push_back(at + (i % 2 == 1 ? inner : 1.0) * radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// Outlines with nearly the area of a disc of the radius.
std::vector<Vec2> outline(const Vec2& at, double radius, MarkShape shape) {
  constexpr double kPi = std::numbers::pi;
  switch (shape) {
    case MarkShape::square:
      return ring(at, 1.25 * radius, 4, 0.25 * kPi);
    case MarkShape::diamond:
      return ring(at, 1.35 * radius, 4, 0.0);
    case MarkShape::triangle_up:
      return ring(at + Vec2(0, 0.2 * radius), 1.45 * radius, 3, -0.5 * kPi);
    case MarkShape::triangle_down:
      return ring(at - Vec2(0, 0.2 * radius), 1.45 * radius, 3, 0.5 * kPi);
    case MarkShape::hexagon:
      return ring(at, 1.12 * radius, 6, 0.0);
    case MarkShape::star:
      return ring(at, 1.6 * radius, 10, -0.5 * kPi, 0.42);
    default:
      return ring(at, radius, 28, 0.0);
  }
}

void add_bars(Sheet& sheet, const Vec2& at, double radius, double turn, const Color& color) {
  const Vec2 u = 1.1 * radius * Vec2(std::cos(turn), std::sin(turn)), v(-u.y(), u.x());
  for (const Vec2& arm : {u, v}) sheet.shapes.push_back(Stroke{{at - arm, at + arm}, 0.62 * radius, color});
}

}  // namespace

std::vector<CurveStyle> styles_of(const std::vector<PlotSeries>& series) {
  std::map<PlotLook, int> members, seen;
  for (const PlotSeries& s : series) ++members[s.look];
  std::vector<CurveStyle> styles;
  for (const PlotSeries& s : series) {
    const LookStyle& look = style_of(s.look);
    const auto [place, count] = s.place.value_or(PlaceInLook{seen[s.look]++, members[s.look]});
    // Of a whole family neighbours, which are compared most, differ by about half of its range.
    const int shade = !s.place ? place : place / 2 + (place % 2 == 0 ? 0 : (count + 1) / 2);
    const int last = std::max(1, count - 1);
    styles.push_back({look.ink,
                      between(look.first, look.last, static_cast<float>(shade) / static_cast<float>(last)),
                      look.shapes[static_cast<std::size_t>(place) % look.shapes.size()], look.hollow});
  }
  return styles;
}

void add_mark(Sheet& sheet, const Vec2& at, double radius, const CurveStyle& style, const Color& paper) {
  constexpr double kQuarter = 0.25 * std::numbers::pi;
  if (style.shape == MarkShape::plus || style.shape == MarkShape::cross)
    return add_bars(sheet, at, radius, style.shape == MarkShape::cross ? kQuarter : 0.0, style.paint);
  sheet.shapes.push_back(Area{outline(at, radius, style.shape), style.paint});
  if (style.hollow) sheet.shapes.push_back(Area{outline(at, 0.56 * radius, style.shape), paper});
}

}  // namespace polhode
