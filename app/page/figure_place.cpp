// SPDX-License-Identifier: MIT
#include "app/page/figure_place.h"

#include "app/narration/still_numbers.h"
#include "render/drawing/plots/meter_plots.h"
#include "render/figure/make_figure.h"
#include "render/typeset/paragraph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace polhode {

namespace {

// In em of the caption.
constexpr double kLargestDiagramType = 1.5;
constexpr double kPad = 1.2;         // around diagrams, beside captions
constexpr double kCaptionGap = 0.6;  // above and below captions
constexpr double kCaptionTop = 0.74;
constexpr double kCaptionLeading = 1.3;

constexpr std::array kSpaceParts = {0.5, 0.42};  // of the place, where diagrams share it

DiagramStyle diagram_style(const FigurePlace& place) {
  const PageColors& colors = colors_of(place.theme);
  return {.type_size = kLargestDiagramType * place.caption_px,
          .ink = colors.ink,
          .muted = colors.quiet,
          .line = colors.line,
          .paper = place.ground.value_or(colors.paper),
          .panel = place.theme == Theme::dark ? colors.line : colors.panel};  // on the backdrop
}

std::array<PixelBox, 2> split(const PixelBox& box, bool beside, double part) {
  if (beside) {
    const double x = std::round(std::lerp(box.x0, box.x1, part));
    return {{{box.x0, box.y0, x, box.y1}, {x, box.y0, box.x1, box.y1}}};
  }
  const double y = std::round(std::lerp(box.y0, box.y1, part));
  return {{{box.x0, box.y0, box.x1, y}, {box.x0, y, box.x1, box.y1}}};
}

/// One box for each diagram, beside or below each other.
std::vector<PixelBox> cells_of(PixelBox box, std::size_t count, bool beside) {
  std::vector<PixelBox> cells;
  for (; count > 0; --count) {
    const auto [first, rest] = split(box, beside, 1.0 / static_cast<double>(count));
    cells.push_back(first);
    box = rest;
  }
  return cells;
}

/// Of the diagram whose type would be smallest, px.
double type_px(const std::vector<Overlay>& diagrams, const std::vector<PixelBox>& cells, double pad) {
  double px = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < diagrams.size(); ++i) {
    const Vec2 extent = diagram_extent(diagrams[i], cells[i].grown(-pad));
    px = std::min(
        {px, (cells[i].width() - 2.0 * pad) / extent.x(), (cells[i].height() - 2.0 * pad) / extent.y()});
  }
  return px;
}

std::vector<PixelBox> best_cells(const std::vector<Overlay>& diagrams, const PixelBox& box, double pad) {
  const auto beside = cells_of(box, diagrams.size(), true), below = cells_of(box, diagrams.size(), false);
  return type_px(diagrams, beside, pad) > type_px(diagrams, below, pad) ? beside : below;
}

/// Space first, its views side by side, then what the diagrams have. Type that is a little larger is worth
/// more than a space that is a little larger.
std::array<PixelBox, 2> share(const std::vector<Overlay>& diagrams, std::size_t views, const PixelBox& box,
                              double pad) {
  const auto worth = [&](const std::array<PixelBox, 2>& parts) {
    return type_px(diagrams, best_cells(diagrams, parts[1], pad), pad) *
           std::sqrt(std::min(parts[0].width() / static_cast<double>(views), parts[0].height()));
  };
  std::array<PixelBox, 2> best = split(box, true, kSpaceParts[0]);
  for (const bool beside : {true, false})
    for (const double part : kSpaceParts)
      if (const auto parts = split(box, beside, part); worth(parts) > worth(best)) best = parts;
  return best;
}

PixelRect rect_of(const PixelBox& box) {
  const auto px = [](double v) { return static_cast<int>(std::lround(v)); };
  return {px(box.x0), px(box.y0), px(box.x1) - px(box.x0), px(box.y1) - px(box.y0)};
}

PixelBox box_of(const PixelRect& rect) {
  return {static_cast<double>(rect.x), static_cast<double>(rect.y), static_cast<double>(rect.x + rect.width),
          static_cast<double>(rect.y + rect.height)};
}

Inset space_of(const SceneModel& model, double t_s, const PixelRect& rect, const FigurePlace& place,
               const SceneModel& first) {
  const double aspect = static_cast<double>(rect.width) / std::max(1, rect.height);
  Inset inset{.figure = make_figure(model, t_s, aspect, common_half_height(first, aspect)),
              .place = rect,
              .background = place.background,
              .quality = place.quality};
  inset.figure.caption_px = place.caption_px;
  return inset;
}

void add_ground(const PixelBox& box, const Color& color, Sheet& sheet) {
  sheet.shapes.push_back(
      Area{{{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}, color});
}

bool is_written(const Scene& scene, double t_s, const FigurePlace& place) {
  const bool holds = scene.caption_when == CaptionWhen::always || !place.is_frame;
  return !place.rooms_alone && holds && caption_holds(scene, t_s);
}

/// Of a caption, px, with what is free around it: above its first baseline, and below.
struct CaptionRoom {
  double above = 0, below = 0;
  double height() const { return above + below; }
};
CaptionRoom larger(const CaptionRoom& a, const CaptionRoom& b) {
  return {std::max(a.above, b.above), std::max(a.below, b.below)};
}

/// A caption in as many lines as it takes.
struct CaptionLines {
  DisplayList lines{};
  CaptionRoom room{};
};

CaptionLines caption_lines(const std::string& caption, double width, const FigurePlace& place,
                           const Fonts& fonts) {
  if (caption.empty()) return {};
  const double em = place.caption_px;
  TextStyle style;
  style.size = em;
  style.color = diagram_style(place).ink;
  style.sans = true;
  style.leading = kCaptionLeading;
  style.width = std::max(em, width - 2.0 * kPad * em);
  DisplayList lines = set_lines(caption, style, fonts);
  style.size *= std::min(1.0, style.width / lines.width);  // a long word in a narrow place
  lines = set_lines(caption, style, fonts);
  const CaptionRoom room{std::round(kCaptionGap * em + std::max(lines.ascent, kCaptionTop * em)),
                         std::round(lines.depth + kCaptionGap * em)};
  return {std::move(lines), room};
}

/// Left and right, or above and below, as lets the scenes be larger; with plots below them left and right.
/// @param captions whether each has one of its own, which takes from its height
std::vector<PixelBox> places_of_scenes(const SceneModel& model, const PixelBox& box, bool captions,
                                       const FigurePlace& place, const Fonts& fonts) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  auto beside = cells_of(box, shown.size(), true), below = cells_of(box, shown.size(), false);
  if (each_has_meters(model)) return beside;
  // Of one line, however long they are: numbers that change never make scenes change their places.
  const double caption = captions ? caption_lines("0", box.width(), place, fonts).room.height() : 0.0;
  struct Scale {
    double space = std::numeric_limits<double>::infinity(), side = space;  ///< px a scene unit; px
    bool operator>=(const Scale& other) const {
      return std::isfinite(space) && space != other.space ? space > other.space : side >= other.side;
    }
  };
  const auto smallest = [&](const std::vector<PixelBox>& cells) {
    Scale least;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double width = cells[i].width(), height = std::max(1.0, cells[i].height() - caption);
      const double half_height = own_half_height(*shown[i], width / height);
      if (half_height > 0.0) least.space = std::min(least.space, 0.5 * height / half_height);
      least.side = std::min({least.side, width / static_cast<double>(shown[i]->scene.views.size()), height});
    }
    return least;
  };
  return smallest(beside) >= smallest(below) ? beside : below;
}

/// Below what stands in the box, which is cut by it, whether it is written or not: by `least`, so that
/// pictures side by side end at one height and their captions stand on one line.
void cut_caption(const std::string& caption, bool is_written, const CaptionRoom& least,
                 const FigurePlace& place, PixelBox& box, Sheet& sheet, const Fonts& fonts) {
  CaptionLines set = caption_lines(caption, box.width(), place, fonts);
  const CaptionRoom room = larger(set.room, least);
  const double y1 = box.y1 - room.height();
  if (y1 == box.y1) return;
  if (place.ground) add_ground({box.x0, y1, box.x1, box.y1}, *place.ground, sheet);
  if (is_written && !caption.empty())
    sheet.texts.push_back({.list = std::move(set.lines),
                           .at = {std::round(box.x0 + kPad * place.caption_px), y1 + room.above},
                           .text = caption});
  box.y1 = y1;
}

/// What stands below one scene.
struct OwnCaption {
  std::string text{};
  bool is_written = false;
  CaptionRoom least{};  ///< that it has
};

/// One scene, whatever stands beside it; `first` is that of all of them.
PlacedFigure place_scene(const SceneModel& model, const OwnCaption& caption, double t_s,
                         const FigurePlace& place, const Fonts& fonts, const SceneModel& first) {
  PlacedFigure placed;
  PixelBox box = box_of(place.rect);
  cut_caption(caption.text, caption.is_written, caption.least, place, box, placed.sheet, fonts);
  if (is_plots_alone(model)) {
    placed.plots.push_back(box);
    return placed;
  }
  const std::vector<Overlay> diagrams = diagrams_in(model.drawn);
  if (diagrams.empty()) {
    placed.insets.push_back(space_of(model, t_s, rect_of(box), place, first));
    return placed;
  }
  const DiagramStyle style = diagram_style(place);
  const double pad = kPad * place.caption_px;
  // A caption follows its diagrams; below a space, or beside another caption, it stays below the picture.
  const bool is_captioned_alone = !placed.sheet.texts.empty() && caption.least.height() == 0 &&
                                  !shows_space(model.drawn, model.needs.marks);
  if (place.ground) add_ground(box, *place.ground, placed.sheet);
  if (shows_space(model.drawn, model.needs.marks)) {
    const auto [space, rest] = share(diagrams, model.scene.views.size(), box, pad);
    placed.insets.push_back(space_of(model, t_s, rect_of(space), place, first));
    box = rest;
  }
  const std::vector<PixelBox> cells = best_cells(diagrams, box, pad);
  double lowest = box.y0;
  for (std::size_t i = 0; i < diagrams.size(); ++i) {
    const PixelBox cell = cells[i].grown(-pad);
    append(placed.sheet, lay_out_diagram(diagrams[i], model, t_s, cell, style, fonts), {0, 0});
    lowest = std::max(lowest, diagram_box(diagrams[i], cell, style).y1);
  }
  if (is_captioned_alone) placed.sheet.texts.front().at.y() -= box.y1 - pad - lowest;
  return placed;
}

}  // namespace

PlacedFigure place_figure(const SceneModel& model, double t_s, const FigurePlace& place, const Fonts& fonts) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  const auto caption_of = [&](std::size_t i) {
    return with_decimals_in_formulas(place.captions.empty() ? shown[i]->scene.caption : place.captions[i],
                                     shown[i]->scene.language);
  };
  const auto writes = [&](std::size_t i) { return is_written(shown[i]->scene, t_s, place); };
  if (shown.size() == 1) return place_scene(model, {caption_of(0), writes(0)}, t_s, place, fonts, model);
  PlacedFigure placed;
  PixelBox box = box_of(place.rect);
  const bool is_common = have_one_caption(shown_scenes(model.scene));
  if (is_common)
    cut_caption(caption_of(model.scene.before), writes(model.scene.before), {}, place, box, placed.sheet,
                fonts);
  std::vector<OwnCaption> captions;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::string label = with_decimals(shown[i]->scene.label, shown[i]->scene.language);
    const bool has_own = label.empty() && !is_common;
    captions.push_back({has_own ? caption_of(i) : label, !has_own || writes(i)});
  }
  const bool have_captions =
      std::any_of(captions.begin(), captions.end(), [](const OwnCaption& own) { return !own.text.empty(); });
  const std::vector<PixelBox> cells = places_of_scenes(model, box, have_captions, place, fonts);
  CaptionRoom largest;
  for (std::size_t i = 0; i < shown.size(); ++i)
    largest = larger(largest, caption_lines(captions[i].text, cells[i].width(), place, fonts).room);
  const bool are_beside = cells.front().y0 == cells.back().y0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    FigurePlace cell = place;
    cell.rect = rect_of(cells[i]);
    if (are_beside) captions[i].least = largest;
    PlacedFigure one = place_scene(*shown[i], captions[i], t_s, cell, fonts, model);
    append(placed.sheet, std::move(one.sheet), {0, 0});
    placed.plots.insert(placed.plots.end(), one.plots.begin(), one.plots.end());
    const auto at = shown[i] == &model ? placed.insets.begin() : placed.insets.end();
    placed.insets.insert(at, std::make_move_iterator(one.insets.begin()),
                         std::make_move_iterator(one.insets.end()));
  }
  return placed;
}

bool is_plots_alone(const SceneModel& model) {
  return model.needs.meters && shows_nothing(model.drawn, model.needs.marks);
}

bool each_has_meters(const SceneModel& model) {
  return std::any_of(model.beside.begin(), model.beside.end(),
                     [](const SceneModel& other) { return meter_count(other) > 0; });
}

Quality quality_of(QualityLevel level) {
  switch (level) {
    case QualityLevel::draft:
      return {.samples = 0};
    case QualityLevel::fine:
      return {.supersampling = 2};
    case QualityLevel::normal:
      break;
  }
  return {};
}

double caption_px_of(Size size) {
  constexpr double kCaptionSize = 0.029;  // as of figures in space
  return kCaptionSize * std::min<double>(size.height, size.width * 9.0 / 16.0);
}

}  // namespace polhode
