// SPDX-License-Identifier: MIT
#include "render/vector/vector_path.h"

#include "render/drawing/type_grid.h"

#include <fmt/format.h>

#include <cmath>

namespace polhode {

namespace {

using Kind = OutlineStep::Kind;

void add_line(std::vector<OutlineStep>& steps, Kind kind, const Vec2& to) {
  steps.push_back({kind, {Vec2(0, 0), Vec2(0, 0), to}});
}

std::vector<OutlineStep> polygon(const std::vector<Vec2>& points, bool closed) {
  std::vector<OutlineStep> steps;
  for (const Vec2& point : points) add_line(steps, steps.empty() ? Kind::move : Kind::line, point);
  if (closed && !steps.empty()) add_line(steps, Kind::close, {0, 0});
  return steps;
}

VectorPath path_of(const Area& area) {
  VectorPath path{polygon(area.points, true)};
  path.fill = area.color;
  return path;
}

VectorPath path_of(const Stroke& stroke) {
  VectorPath path{polygon(stroke.points, false)};
  path.stroke = stroke.color;
  path.width = stroke.width;
  path.dash = stroke.dash;
  return path;
}

std::vector<OutlineStep> outline_of(const Glyph& glyph, const PlacedType& type, const Fonts& fonts) {
  const GridGlyph at = on_grid(glyph, type);
  const Vec2 origin(at.x + at.quarter_x / 4.0, at.y + at.quarter_y / 4.0);
  const double em = at.size_64 / 64.0;
  std::vector<OutlineStep> steps = outline_of(fonts, glyph.face, glyph.id);
  for (OutlineStep& step : steps)
    for (Vec2& point : step.to) point = origin + em * Vec2(point.x(), -point.y());
  return steps;
}

std::vector<OutlineStep> outline_of(const Rule& rule, const PlacedType& type) {
  const RuleBox box = on_grid(rule, type);
  const Vec2 along = box.half.x() * box.along, across = box.half.y() * Vec2(-box.along.y(), box.along.x());
  return polygon({box.middle - along - across, box.middle + along - across, box.middle + along + across,
                  box.middle - along + across},
                 true);
}

/// Glyphs in the order of reading, then rules. A rule shares no path with glyphs, whose outlines may turn the
/// other way: where it lies over one, as over the sign of a root, their windings would cancel, and leave a
/// hole.
std::vector<VectorPath> ink_of(const PlacedType& type, const Fonts& fonts) {
  std::vector<VectorPath> paths;
  std::size_t first = 0;
  const auto add = [&](const Color& color, std::vector<OutlineStep> steps) {
    if (paths.size() == first || !(paths.back().fill == color)) {
      paths.emplace_back();
      paths.back().fill = color;
    }
    std::vector<OutlineStep>& all = paths.back().steps;
    all.insert(all.end(), steps.begin(), steps.end());
  };
  for (const Glyph& glyph : type.list.glyphs) add(glyph.color, outline_of(glyph, type, fonts));
  first = paths.size();
  for (const Rule& rule : type.list.rules) add(rule.color, outline_of(rule, type));
  return paths;
}

}  // namespace

std::vector<VectorPath> paths_of(const Sheet& sheet, const Fonts& fonts) {
  std::vector<VectorPath> paths;
  for (const std::vector<FlatShape>* shapes : {&sheet.shapes, &sheet.over_insets})
    for (const FlatShape& shape : *shapes)
      paths.push_back(std::visit([](const auto& one) { return path_of(one); }, shape));
  std::vector<VectorPath> inks;
  for (const PlacedType& type : sheet.texts)
    for (VectorPath& ink : ink_of(type, fonts)) {
      if (type.halo.a > 0) {
        VectorPath halo{ink.steps, type.halo, type.halo};
        halo.width = 2 * halo_radius(type.list);
        paths.push_back(std::move(halo));
      }
      inks.push_back(std::move(ink));
    }
  paths.insert(paths.end(), std::make_move_iterator(inks.begin()), std::make_move_iterator(inks.end()));
  std::erase_if(paths, [](const VectorPath& path) { return path.steps.empty(); });
  return paths;
}

std::string side_length(double px, double px_per_inch) {
  constexpr double kPointsPerInch = 72, kLess = 1e-4;
  return fmt::format("{:.4f}", std::floor((px * kPointsPerInch / px_per_inch - kLess) / kLess) * kLess);
}

std::string coordinate(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace polhode
