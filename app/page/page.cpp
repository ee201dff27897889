// SPDX-License-Identifier: MIT
#include "app/page/page.h"

#include "app/page/figure_cells.h"
#include "app/page/figure_place.h"
#include "app/page/page_transition.h"
#include "app/page/text/page_text.h"
#include "render/drawing/fade.h"
#include "render/drawing/plots/meter_plots.h"
#include "render/typeset/paragraph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace polhode {

const FiguredStep* figured(const PageRequest& request, int step) {
  if (!request.before) return nullptr;
  const auto found = std::find_if(request.before->begin(), request.before->end(),
                                  [&](const FiguredStep& one) { return one.step == step; });
  return found != request.before->end() ? &*found : nullptr;
}

namespace {

// Relative to the em of prose.
constexpr double kMeasure = 28.0;  ///< width of the text column: 62 to 66 characters
constexpr double kMargin = 3.1;
constexpr double kGutter = 2.4;  ///< between text and figure
constexpr double kTop = 3.1;
constexpr double kBottom = 2.7;
constexpr double kMeterSize = 0.62;
constexpr double kCaptionSize = 0.68;

constexpr double kWidestText = 0.62;  ///< of a wide page, with its margins
constexpr double kLeastEm = 16;       ///< px, of prose in a window: small windows scroll
constexpr double kLeastPlot = 11;     ///< em of small type, in width
constexpr double kBetweenFigures = 0.5;
constexpr double kLeastBeside = 11;  ///< em: of a figure beside a panel, under which one with less room lies
constexpr double kLeastMargin = 2;   ///< where type is larger than the window is meant for

// Of slides. The x-height of the text type is 0.469 em: 1.9 % of the height, as large as that of Beamer's
// slides; that of the smallest labels, 0.62 em of the sans, is 1.3 %.
constexpr double kSlideEm = 0.0405;                              ///< of the height
constexpr double kFewestEms = 22.0;                              ///< in the width of a tall slide
constexpr double kSlideMargin = 1.6;                             ///< em
constexpr double kSlideGutter = 1.2;                             ///< em
constexpr double kSlideTop = 1.5;                                ///< em
constexpr double kSlideBottom = 1.2;                             ///< em
constexpr double kSlideMeasureAlone = 26.0;                      ///< em: of text without a figure
constexpr std::array kSlideTextParts = {0.38, 0.44, 0.5, 0.56};  ///< of a wide slide, with its margins
constexpr double kWishedFormulaScale = 0.8;  ///< a wider column is better than smaller formulas
constexpr std::array kSlideScales = {1.0, 0.93, kLeastScale, 0.8, 0.7, 0.6};

/// Where the parts of a page lie.
struct Grid {
  double em;        ///< of prose
  double small_em;  ///< what labels, captions and plots go by
  PixelBox text;
  PixelRect figure;
  PixelBox meters;
};

PixelRect rounded(double x0, double y0, double x1, double y1) {
  const auto px = [](double v) { return static_cast<int>(std::lround(v)); };
  return {px(x0), px(y0), px(x1) - px(x0), px(y1) - px(y0)};
}

/// What a page is laid out for.
struct Room {
  double w, h;
  std::size_t meter_rows;  ///< below the figure; 0: none, or in its place
  double text_scale;
  bool shows_space = true;  ///< a picture in space, not diagrams alone, whose type goes with their size
  double least_em = 0;      ///< px
  double covered = 0;       ///< px at the right
};

/// The right end of what a panel leaves of the room from `left` on; of all of it where that is too little.
double uncovered(const Room& room, double left, double em) {
  const double right = room.w - room.covered;
  return right - left < kLeastBeside * em ? room.w : right;
}

/// Width of the text column in normal em: with larger type it grows up to `most`.
double measure_of(double text_scale, double most) {
  return kMeasure * std::min(text_scale, std::max(1.0, most / kMeasure));
}

/// The same of text that has the whole width of a page. Type that is larger than the window is meant for has
/// shorter lines.
double measure_across(const Room& room, double em, double fitting_em) {
  const double measure = measure_of(room.text_scale, room.w / em - 2.0 * kMargin);
  return em > fitting_em ? std::min(measure, room.w / em - 2.0 * kLeastMargin) : measure;
}

/// What is read at a glance need not grow as much as what is read for long.
double half_as_much(double text_scale) { return std::sqrt(text_scale); }

/// Text on the left; on the right the figure to the page's edges, meters below it.
Grid side_by_side(const Room& room) {
  const auto [w, h, meter_rows, text_scale, shows_space, least_em, covered] = room;
  const double fitting_em = std::min(w / (1600.0 / 23.25), h / 36.0), em = std::max(fitting_em, least_em);
  const double widest = kWidestText * w / em - kMargin - kGutter;
  // Type that is larger than the window is meant for has shorter lines.
  const double measure =
      em > fitting_em ? std::min(measure_of(text_scale, widest), widest) : measure_of(text_scale, widest);
  const double split = std::round((kMargin + measure + kGutter) * em);
  const double below = meter_rows == 0 ? 0.0 : meter_rows > 1 ? 0.48 * h : 0.30 * h;
  const double right = covered > 0 ? std::round(uncovered(room, split, em)) : w;
  return {text_scale * em,
          half_as_much(text_scale) * em,
          {kMargin * em, kTop * em, (kMargin + measure) * em, h - kBottom * em},
          rounded(split, 0, right, h - below),
          {split, h - below, right, h}};
}

/// The figure on top, meters below it, then the text, which takes of the figure's room what larger type
/// needs.
Grid one_above_the_other(const Room& room) {
  const auto [w, h, meter_rows, text_scale, shows_space, least_em, covered] = room;
  const double fitting_em = std::min(w / (kMeasure + 2.0 * kMargin), h / 44.0),
               em = std::max(fitting_em, std::min(least_em, w / kFewestEms));
  const double measure = measure_across(room, em, fitting_em);
  const double rows = std::min(2.0, static_cast<double>(meter_rows));
  const double figure = (rows > 1.0 ? 0.27 : 0.34) * h / half_as_much(text_scale),
               below = figure + 0.14 * rows * h;
  const double left = 0.5 * (w - measure * em);
  const double right = covered > 0 ? std::round(uncovered(room, 0, em)) : w;
  return {text_scale * em,
          half_as_much(text_scale) * em,
          {left, below + 1.6 * em, left + measure * em, h - kBottom * em},
          rounded(0, 0, right, figure),
          {0, figure, right, below}};
}

Grid text_alone(const Room& room) {
  const auto [w, h, meter_rows, text_scale, shows_space, least_em, covered] = room;
  const double fitting_em = std::min(w / (kMeasure + 2.0 * kMargin), h / 26.0),
               em = std::max(fitting_em, std::min(least_em, w / kFewestEms));
  // Beside a panel it moves aside, and only where that is not enough its lines are shorter.
  const double wished = measure_across(room, em, fitting_em);
  const double measure = covered > 0 ? std::min(wished, (w - covered) / em - 2.0) : wished;
  const double centred = 0.5 * (w - measure * em);
  const double left = covered > 0 ? std::min(centred, 0.5 * (w - covered - measure * em)) : centred;
  return {text_scale * em,
          half_as_much(text_scale) * em,
          {left, kTop * em, left + measure * em, h - kBottom * em},
          {},
          {}};
}

double slide_em(const Room& room) {
  return kSlideEm * std::min(room.h, room.w / (kFewestEms * kSlideEm)) * room.text_scale;
}

bool is_wide(const Room& room) {
  return stands_side_by_side({static_cast<int>(room.w), static_cast<int>(room.h)});
}

/// The widths that the text of a slide with a figure can have, px, the smallest first.
std::vector<double> slide_columns(const Room& room) {
  const double em = slide_em(room);
  if (!is_wide(room)) return {room.w - 2.0 * kSlideMargin * em};
  std::vector<double> columns;
  for (const double part : kSlideTextParts)
    columns.push_back(std::round(part * room.w - (kSlideMargin + kSlideGutter) * em));
  return columns;
}

/// Text on the left or below, and as much as there is for the figure.
Grid slide(const Room& room, bool has_figure, double column) {
  const auto [w, h, meter_rows, text_scale, shows_space, least_em, covered] = room;
  const double em = slide_em(room), small_em = em / text_scale * half_as_much(text_scale);
  const double left = kSlideMargin * em, top = kSlideTop * em, bottom = h - kSlideBottom * em;
  if (!has_figure) {
    const double measure = std::min(kSlideMeasureAlone * em, w - 2.0 * left);
    return {em, small_em, {left, top, left + measure, bottom}, {}, {}};
  }
  const double rows = std::min(2.0, static_cast<double>(meter_rows));
  if (is_wide(room)) {
    const double split = std::round(left + column + kSlideGutter * em);
    const double below = rows > 1.0 ? 0.58 * h : rows > 0.0 ? (shows_space ? 0.45 : 0.36) * h : 0.0;
    return {em,
            small_em,
            {left, top, left + column, bottom},
            rounded(split, 0, w, h - below),
            {split, h - below, w, h}};
  }
  const double figure = (rows > 0.0 ? 0.36 : 0.5) * h, below = figure + 0.16 * rows * h;
  return {em,
          small_em,
          {left, below + em, left + column, bottom},
          rounded(0, 0, w, figure),
          {0, figure, w, below}};
}

/// How plots stand in their place.
struct Rows {
  std::size_t rows, columns;
};
/// All plots of a page in the whole width, or below each of several scenes its own. On a wide slide, where
/// type is large, two or three stand one below the other on one time axis.
Rows rows_of(std::size_t plots, bool is_part, bool is_slide) {
  const std::size_t columns = is_part || (is_slide && plots <= 3) ? 1
                              : plots > 3                         ? 2
                                                                  : std::max<std::size_t>(1, plots);
  return {(plots + columns - 1) / columns, columns};
}

bool is_wide_slide(const PageRequest& request) {
  return request.profile == Profile::slides && stands_side_by_side(request.size);
}

/// Whether all that a page shows are plots, which have the place of its figure.
bool are_plots_alone(const SceneModel& model) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  return std::all_of(shown.begin(), shown.end(), [](const SceneModel* one) { return is_plots_alone(*one); });
}

std::size_t meter_rows(const SceneModel& model, bool is_slide) {
  const bool each = each_has_meters(model);
  std::size_t most = 0;
  for (const SceneModel* shown : shown_models(model))
    most = std::max(most, rows_of(meter_count(*shown), each, is_slide).rows);
  return most;
}

/// Of plots below the figure. On a page to read several figures have theirs beside them; above text they have
/// always the same room, whatever they are.
std::size_t rows_below(const PageRequest& request) {
  if (request.before && !stands_side_by_side(request.size)) return 1;
  const std::vector<FigureCell> cells = figures_on_page(request);
  return cells.size() == 1 && !are_plots_alone(*cells.front().model)
             ? meter_rows(*cells.front().model, is_wide_slide(request))
             : 0;
}

Room room_of(const PageRequest& request) {
  return {static_cast<double>(request.size.width),
          static_cast<double>(request.size.height),
          rows_below(request),
          request.text_scale,
          request.model && shows_space(request.model->drawn, request.model->needs.marks),
          request.scrolls ? kLeastEm * request.display_scale : 0.0,
          request.covered};
}

/// Whether a page has its text as it stands beside a figure: all pages to read of a stage that has one.
bool has_figure(const PageRequest& request) {
  return request.model ||
         (request.before && std::any_of(request.stage.steps.begin(), request.stage.steps.end(),
                                        [](const Step& step) { return step.scene != nullptr; }));
}

Grid grid_of(const PageRequest& request, const SlideType& type) {
  const Room room = room_of(request);
  if (request.profile == Profile::slides) return slide(room, request.model != nullptr, type.column);
  if (!has_figure(request)) return text_alone(room);
  return is_wide(room) ? side_by_side(room) : one_above_the_other(room);
}

TimePlotStyle plot_style(Theme theme, double type_size) {
  const PageColors& colors = colors_of(theme);
  return {.type_size = type_size,
          .ink = colors.ink,
          .muted = colors.quiet,
          .grid = colors.line,
          .paper = colors.paper};
}

double small_type(const PageRequest& request, double px) { return std::max(px, least_type_px(request)); }

struct Captions {
  std::vector<std::string> words;  ///< of each scene that is shown
  bool rooms_alone = false;        ///< of the lesson's: its room stays, and nothing is written there
};

Captions captions_of(const PageRequest& request, const FigureCell& cell, const FittedText& text) {
  const CaptionBlanks blanks = request.scrolls ? CaptionBlanks::behind : CaptionBlanks::before_numbers;
  Captions captions{captions_at(request.lesson, *cell.step, *cell.model, cell.t_s, text.in_captions, blanks)};
  const bool has_none = std::all_of(captions.words.begin(), captions.words.end(),
                                    [](const std::string& one) { return one.empty(); });
  captions.rooms_alone = request.scrolls && has_none && cell.step->scene;
  if (captions.rooms_alone)
    captions.words =
        lesson_captions_at(request.lesson, *cell.step, *cell.model, cell.t_s, text.in_captions, blanks);
  return captions;
}

PlacedFigure figure_on_page(const PageRequest& request, const FigureCell& cell, const Grid& grid,
                            Captions captions, const Fonts& fonts) {
  FigurePlace place{.rect = cell.figure,
                    .caption_px = small_type(request, kCaptionSize * grid.small_em),
                    .theme = request.theme,
                    .background = {},
                    .quality = quality_of(request.quality.value_or(cell.model->scene.quality))};
  if (request.theme == Theme::dark) {
    place.ground = colors_of(request.theme).backdrop;
    place.background = {Background::Kind::color, *place.ground};
  }
  place.captions = std::move(captions.words);
  place.is_frame = request.is_frame;
  place.rooms_alone = captions.rooms_alone;
  return place_figure(*cell.model, cell.t_s, place, fonts);
}

void add_plots(const std::vector<TimePlot>& plots, const PixelBox& place, const Rows& arranged,
               const PageRequest& request, const Grid& grid, Page& page, const Fonts& fonts) {
  const double pad = 1.3 * grid.small_em;
  TimePlotStyle style = plot_style(request.theme, small_type(request, kMeterSize * grid.small_em));
  const auto box_of = [&](std::size_t i) {
    const double width = place.width() / static_cast<double>(arranged.columns),
                 height = (place.height() - pad) / static_cast<double>(arranged.rows);
    const std::size_t column = i % arranged.columns, row = i / arranged.columns;
    const double x = place.x0 + width * static_cast<double>(column),
                 y = place.y0 + pad + height * static_cast<double>(row);
    return PixelBox{x + pad, y, x + width - 0.5 * pad, y + height - 0.6 * pad};
  };
  if (arranged.columns == 1)  // on one time axis
    for (std::size_t i = 0; i < plots.size(); ++i) {
      const PlotMargins own = margins_of(plots[i], box_of(i), style, fonts);
      style.least_margins = {std::max(style.least_margins.left, own.left),
                             std::max(style.least_margins.right, own.right)};
    }
  for (std::size_t i = 0; i < plots.size(); ++i) {
    append(page.sheet, lay_out(plots[i], box_of(i), style, fonts), {0, 0});
    if (!request.scrolls) continue;
    if (auto reading = reading_of(plots[i], box_of(i), style, fonts))
      page.plots.push_back(std::move(*reading));
  }
}

/// Each scene's in its own place, one below the other.
void add_plots_alone(const PageRequest& request, const FigureCell& cell, const std::vector<PixelBox>& places,
                     const Grid& grid, Page& page, const Fonts& fonts) {
  const std::vector<const SceneModel*> shown = shown_models(*cell.model);
  for (std::size_t i = 0; i < std::min(shown.size(), places.size()); ++i) {
    const std::vector<TimePlot> plots = meter_plots(*shown[i], cell.t_s);
    const std::size_t columns = plots.size() > 3 ? 2 : 1;
    add_plots(plots, places[i], {(plots.size() + columns - 1) / columns, columns}, request, grid, page,
              fonts);
  }
}

/// @param alone where plots stand that have the figure's place; empty: they stand below it
void add_meters(const PageRequest& request, const FigureCell& cell, const std::vector<PixelBox>& alone,
                const Grid& grid, Page& page, const Fonts& fonts) {
  const SceneModel& model = *cell.model;
  if (!alone.empty()) return add_plots_alone(request, cell, alone, grid, page, fonts);
  if (!each_has_meters(model)) {
    std::vector<TimePlot> plots = meter_plots(model, cell.t_s);
    Rows arranged = rows_of(plots.size(), false, is_wide_slide(request) || cell.are_plots_beside);
    if (request.covered > 0) {  // what would be too narrow to be read lies under the panel
      const double fitting = std::floor(cell.meters.width() / (kLeastPlot * grid.small_em));
      arranged.columns = std::clamp(static_cast<std::size_t>(fitting), std::size_t{1}, arranged.columns);
      plots.resize(std::min(plots.size(), arranged.rows * arranged.columns));
    }
    add_plots(plots, cell.meters, arranged, request, grid, page, fonts);
    return;
  }
  const std::vector<const SceneModel*> shown = shown_models(model);
  const double width = cell.meters.width() / static_cast<double>(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double x = cell.meters.x0 + width * static_cast<double>(i);
    const PixelBox place{x, cell.meters.y0, x + width, cell.meters.y1};
    add_plots(meter_plots(*shown[i], cell.t_s), place, {meter_rows(model, false), 1}, request, grid, page,
              fonts);
  }
}

/// The values of a piece's claims and the live numbers of its formulas, each at its slot.
Sheet live_values(const ColumnPiece& piece, const LiveState* live, View view, Language language,
                  const Fonts& fonts) {
  Sheet sheet;
  for (const LiveNumberSlot& slot : piece.numbers) {
    const auto value = live ? value_of(*slot.number, *live) : std::nullopt;
    sheet.texts.push_back(live_number_in(slot.room, *slot.number, value, language, fonts));
  }
  if (!live) return sheet;
  for (const LiveSlot& slot : piece.live) {
    double y = slot.end.y();
    for (const std::string& text : live_rows(*slot.claim, *live, view, language)) {
      TextStyle style = slot.style;
      DisplayList line = set_line(text, style, fonts);
      if (line.width > slot.room) {
        style.size *= slot.room / line.width;
        line = set_line(text, style, fonts);
      }
      const double x = slot.end.x() - line.width;
      sheet.texts.push_back({.list = std::move(line), .at = {x, y}});
      y += slot.line;
    }
  }
  return sheet;
}

/// What the claims of the steps with figures, and the numbers of all formulas, come to at this time.
Sheet live_values(const PageRequest& request, const Stack& stack, const Fonts& fonts) {
  Sheet sheet;
  const std::vector<ColumnPiece>& pieces = stack.pieces;
  const auto has_slots = [](const ColumnPiece& piece) {
    return !piece.live.empty() || !piece.numbers.empty();
  };
  if (std::none_of(pieces.begin(), pieces.end(), has_slots)) return sheet;
  const auto add = [&](const SceneModel* model, double t_s, const auto& is_of_step) {
    const auto live = model ? live_state(*model, t_s) : std::nullopt;
    const View view = model ? model->scene.views.front() : View::space;
    for (const ColumnPiece& piece : pieces)
      if (is_of_step(piece))
        append(sheet, live_values(piece, live ? &*live : nullptr, view, request.lesson.about.language, fonts),
               {0, 0});
  };
  const std::span<const FiguredStep> before = request.before.value_or(std::span<const FiguredStep>());
  for (const FiguredStep& one : before)
    add(one.model, one.t_s, [&](const ColumnPiece& piece) { return piece.step == one.step; });
  add(request.model, request.t_s, [&](const ColumnPiece& piece) {
    return std::none_of(before.begin(), before.end(),
                        [&](const FiguredStep& one) { return piece.step == one.step; });
  });
  return sheet;
}

/// Where a click answers a question of the present step, or opens it.
void add_questions(const FittedText& text, Page& page) {
  for (const ColumnPiece& piece : text.stack.pieces)
    for (const QuestionRows& rows : piece.questions)
      for (std::size_t i = 0; piece.is_new && i + 1 < rows.y.size(); ++i) {
        const PixelBox box{text.corner.x() + rows.x0, text.corner.y() + rows.y[i], text.corner.x() + rows.x1,
                           text.corner.y() + rows.y[i + 1]};
        if (picks_choice(rows.ask->type))
          page.choices.push_back({rows.ask, i, box});
        else
          page.open_questions.push_back({rows.ask, box});
      }
}

/// Beside all that the present step adds to what was there.
void add_bar_of_new(const PageRequest& request, const FittedText& text, double em, Sheet& sheet) {
  if (text.new_to <= text.new_from) return;
  constexpr double kAside = 1.75, kWidth = 0.1;  // em: clear of the bar beside an equation
  const double x = std::round(text.corner.x() - kAside * em), width = std::max(2.0, std::round(kWidth * em));
  const double y0 = text.corner.y() + text.new_from, y1 = text.corner.y() + text.new_to;
  Color color = colors_of(request.theme).question;
  const auto* turning = std::get_if<TurningInto>(&request.entrance);
  if (turning) color.a *= static_cast<float>(appeared(turning->progress));
  sheet.shapes.push_back(Area{{{x, y0}, {x + width, y0}, {x + width, y1}, {x, y1}}, color});
}

void add_column(const PageRequest& request, const FittedText& text, Sheet& sheet, const Fonts& fonts) {
  const Sheet values = live_values(request, text.stack, fonts);
  const auto* turning = std::get_if<TurningInto>(&request.entrance);
  if (turning && turning->progress < 1.0) {
    append(sheet, column_on_its_way(turning->from, text, turning->progress), {0, 0});
    append(sheet, faded(values, appeared(turning->progress)), text.corner);
    return;
  }
  const auto* fading = std::get_if<FadingIn>(&request.entrance);
  const double opacity = fading ? fading->opacity : 1.0;
  for (const ColumnPiece& piece : text.stack.pieces)
    append(sheet, faded(piece.sheet, piece.is_new ? opacity : 1.0), text.corner);
  append(sheet, faded(values, opacity), text.corner);
}

/// Each figure has its place: the only one that of the grid.
std::vector<FigureCell> placed_figures(const PageRequest& request, const FittedText& text, const Grid& grid) {
  std::vector<FigureCell> cells = figures_on_page(request);
  if (cells.empty()) return cells;
  const double gap = std::round(kBetweenFigures * grid.em);
  if (request.before && !stands_side_by_side(request.size)) {
    place_above({0, 0, grid.meters.x1, grid.meters.y1}, gap, cells);
    return cells;
  }
  if (cells.size() == 1) {
    cells.front().figure = grid.figure;
    cells.front().meters = grid.meters;
    return cells;
  }
  const int first = request.step - static_cast<int>(request.before->size());
  std::vector<double> tops;
  for (const FigureCell& cell : cells) {
    const auto i = static_cast<std::size_t>(cell.first_step - first);
    tops.push_back(text.corner.y() + text.step_tops[std::min(i, text.step_tops.size() - 1)]);
  }
  place_beside(tops, {static_cast<double>(grid.figure.x), 0, grid.meters.x1, grid.meters.y1}, gap, cells);
  return cells;
}

/// Whether a step of the request's stage, from 1, fits its slide in such type.
Result<bool> fits(const PageRequest& request, int step, const SlideType& type, double least_formula,
                  bool has_to_recall, const Fonts& fonts) {
  const bool has_figure = request.stage.steps[static_cast<std::size_t>(step - 1)].scene != nullptr;
  const Grid grid = slide(room_of(request), has_figure, type.column);
  PageRequest of_step = request;
  of_step.profile = Profile::slides;
  of_step.step = step;
  of_step.model = nullptr;
  of_step.slide_type = &type;
  return fits_slide(of_step, grid.text.width(), grid.text.height(), grid.em, least_formula, has_to_recall,
                    fonts);
}

/// Whether all steps of the request's stage do.
Result<bool> all_fit(const PageRequest& request, const SlideType& type, double least_formula,
                     bool have_to_recall, const Fonts& fonts) {
  for (std::size_t i = 0; i < request.stage.steps.size(); ++i) {
    Result<bool> fits_here =
        fits(request, static_cast<int>(i) + 1, type, least_formula, have_to_recall, fonts);
    if (!fits_here || !*fits_here) return fits_here;
  }
  return true;
}

}  // namespace

Result<double> slide_scale_of(const PageRequest& request, const Fonts& fonts) {
  const double widest = slide_columns(room_of(request)).back();
  for (const double scale : kSlideScales) {
    const auto holds = fits(request, request.step, {widest, scale}, kLeastFormulaScale, false, fonts);
    if (!holds) return failure(holds.error());
    if (*holds) return scale;
  }
  return kSlideScales.back();
}

Result<SlideType> slide_type_of(const PageRequest& request, const Fonts& fonts) {
  const std::vector<double> columns = slide_columns(room_of(request));
  const auto least_formula = [&](double column) {
    return column == columns.back() ? kLeastFormulaScale : kWishedFormulaScale;
  };
  // A wider column is better than a slide without what it goes on from, and normal type better than both.
  for (const bool have_to_recall : {true, false})
    for (const double scale : kSlideScales) {
      if (have_to_recall && scale < kSlideScales.front()) break;
      for (const double column : columns) {
        const Result<bool> fit =
            all_fit(request, {column, scale}, least_formula(column), have_to_recall, fonts);
        if (!fit) return failure(fit.error());
        if (*fit) return SlideType{column, scale};
      }
    }
  return SlideType{columns.back(), kSlideScales.back()};
}

double least_type_px(const PageRequest& request) {
  return request.scrolls ? kLeastSmall * request.display_scale : 0.0;
}

bool stands_side_by_side(Size size) { return size.width > 1.05 * size.height; }

Result<FittedText> text_of_page(const PageRequest& request, const Fonts& fonts) {
  SlideType type;
  if (request.profile == Profile::slides && request.slide_type == nullptr) {
    const Result<SlideType> found = slide_type_of(request, fonts);
    if (!found) return failure(found.error());
    type = *found;
  } else if (request.slide_type != nullptr) {
    type = *request.slide_type;
  }
  const Grid grid = grid_of(request, type);
  Result<FittedText> text =
      request.profile == Profile::slides
          ? fit_slide(request, type.scale, grid.text.width(), grid.text.height(), grid.em, fonts)
          : fit_text(request, grid.text.width(), grid.text.height(), grid.em, fonts);
  if (text) text->type = type;
  if (text) text->corner = {std::round(grid.text.x0), std::round(grid.text.y0) - text->hidden};
  if (text && request.runs && request.model)
    text->in_captions = longest_in_captions(
        request.lesson, request.stage.steps[static_cast<std::size_t>(request.step - 1)], *request.model);
  return text;
}

Result<std::vector<double>> parts_of_page(const PageRequest& request, const Fonts& fonts) {
  const Grid grid = grid_of(request, {});
  Result<std::vector<double>> heights =
      heights_of_pages(request, grid.text.width(), grid.text.height(), grid.em, fonts);
  if (heights)
    for (double& height : *heights) height /= grid.text.height();
  return heights;
}

Result<Page> compose_page(const PageRequest& request, const Fonts& fonts) {
  const Result<FittedText> text = text_of_page(request, fonts);
  if (!text) return failure(text.error());
  return compose_page(request, *text, fonts);
}

Page compose_page(const PageRequest& request, const FittedText& text, const Fonts& fonts) {
  const Grid grid = grid_of(request, text.type);
  Page page;
  page.scale = text.scale;
  page.formula_scale = text.formula_scale;
  page.equations = text.equations;
  page.whole_from = text.whole_from;
  add_questions(text, page);
  page.hidden = text.hidden;
  page.overflow = text.overflow;
  page.column = grid.text;
  page.meters = grid.meters;
  page.least_figure = kLeastBeside * grid.em / request.text_scale;
  const PixelRect& place = grid.figure;
  page.figure = {static_cast<double>(place.x), static_cast<double>(place.y),
                 static_cast<double>(place.x + place.width), static_cast<double>(place.y + place.height)};
  if (request.scrolls) add_bar_of_new(request, text, grid.em, page.sheet);
  add_column(request, text, page.sheet, fonts);
  if (!stands_side_by_side(request.size)) page.ceiling = grid.meters.y1;
  page.column_shapes = page.sheet.shapes.size();
  page.column_texts = page.sheet.texts.size();
  for (const FigureCell& cell : placed_figures(request, text, grid)) {
    PlacedFigure figure = figure_on_page(request, cell, grid, captions_of(request, cell, text), fonts);
    std::move(figure.insets.begin(), figure.insets.end(), std::back_inserter(page.insets));
    append(page.sheet, std::move(figure.sheet), {0, 0});
    add_meters(request, cell, figure.plots, grid, page, fonts);
  }
  if (request.model && are_plots_alone(*request.model)) {
    page.meters = page.figure;
    page.figure = {};
  }
  return page;
}

namespace {

// Of a picture without text, beside its width.
constexpr double kPictureEm = 1.0 / 27.0;  ///< type as large beside the figure as on a slide
constexpr double kPictureFigure = 0.62, kPicturePlots = 0.3;

}  // namespace

Size picture_size_of(const SceneModel& model, int width) {
  const std::size_t rows = are_plots_alone(model) ? 0 : meter_rows(model, false);
  const double parts = kPictureFigure + kPicturePlots * static_cast<double>(rows);
  return {width, static_cast<int>(std::lround(parts * width))};
}

namespace {

/// With the captions of the text; null: without any.
Page picture_of(const PageRequest& request, const FittedText* text, const Fonts& fonts) {
  const SceneModel& model = *request.model;
  const double w = request.size.width - request.covered, h = request.size.height, em = kPictureEm * w;
  const double rows = are_plots_alone(model) ? 0.0 : static_cast<double>(meter_rows(model, false));
  const double below = kPicturePlots * rows / (kPictureFigure + kPicturePlots * rows) * h;
  const Grid grid{em, em, {}, rounded(0, 0, w, h - below), {0, h - below, w, h}};
  const FigureCell cell{.step = &request.stage.steps[static_cast<std::size_t>(request.step) - 1],
                        .model = &model,
                        .t_s = request.t_s,
                        .figure = grid.figure,
                        .meters = grid.meters};
  Page page;
  Captions captions{std::vector<std::string>(shown_models(model).size())};
  if (text != nullptr) captions = captions_of(request, cell, *text);
  PlacedFigure figure = figure_on_page(request, cell, grid, std::move(captions), fonts);
  page.insets = std::move(figure.insets);
  append(page.sheet, std::move(figure.sheet), {0, 0});
  add_meters(request, cell, figure.plots, grid, page, fonts);
  page.meters = grid.meters;
  page.figure = {0, 0, w, h - below};
  return page;
}

}  // namespace

Page compose_picture(const PageRequest& request, const Fonts& fonts) {
  return picture_of(request, nullptr, fonts);
}

Page compose_picture(const PageRequest& request, const FittedText& text, const Fonts& fonts) {
  return picture_of(request, &text, fonts);
}

}  // namespace polhode
