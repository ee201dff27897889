// SPDX-License-Identifier: MIT
#include "app/page.h"

#include "app/exit_codes.h"
#include "app/text_column.h"
#include "render/scene/meter_plots.h"
#include "render/type/paragraph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {

namespace {

// Relative to the em of prose.
constexpr double kMeasure = 28.0;  ///< width of the text column: 62 to 66 characters
constexpr double kMargin = 3.1;
constexpr double kGutter = 2.4;  ///< between text and figure
constexpr double kTop = 3.1;
constexpr double kBottom = 2.2;
constexpr double kHeaderSize = 0.62;
constexpr double kHeaderToTitle = 0.9;
constexpr double kMeterSize = 0.62;

/// Where the parts of a page lie.
struct Grid {
  double em;
  PixelBox text;
  PixelRect figure;
  PixelBox meters;
};

PixelRect rounded(double x0, double y0, double x1, double y1) {
  const auto px = [](double v) { return static_cast<int>(std::lround(v)); };
  return {px(x0), px(y0), px(x1) - px(x0), px(y1) - px(y0)};
}

/// Text on the left; on the right the figure to the page's edges, meters below it.
Grid side_by_side(double w, double h, std::size_t meters) {
  const double em = std::min(w / (1600.0 / 23.25), h / 36.0);
  const double split = std::round((kMargin + kMeasure + kGutter) * em);
  const double below = meters == 0 ? 0.0 : meters > 3 ? 0.48 * h : 0.30 * h;
  return {em,
          {kMargin * em, kTop * em, (kMargin + kMeasure) * em, h - kBottom * em},
          rounded(split, 0, w, h - below),
          {split, h - below, w, h}};
}

/// The figure on top, meters below it, then the text.
Grid one_above_the_other(double w, double h, std::size_t meters) {
  const double em = std::min(w / (kMeasure + 2.0 * kMargin), h / 44.0);
  const double rows = meters == 0 ? 0.0 : meters > 3 ? 2.0 : 1.0;
  const double figure = (rows > 1.0 ? 0.27 : 0.34) * h, below = figure + 0.14 * rows * h;
  const double left = 0.5 * (w - kMeasure * em);
  return {em,
          {left, below + 1.6 * em, left + kMeasure * em, h - kBottom * em},
          rounded(0, 0, w, figure),
          {0, figure, w, below}};
}

Grid text_alone(double w, double h) {
  const double em = std::min(w / (kMeasure + 2.0 * kMargin), h / 26.0);
  const double left = 0.5 * (w - kMeasure * em);
  return {em, {left, kTop * em, left + kMeasure * em, h - kBottom * em}, {}, {}};
}

Grid grid_of(const PageRequest& request, std::size_t meters) {
  const double w = request.size.width, h = request.size.height;
  if (!request.model) return text_alone(w, h);
  return w > 1.05 * h ? side_by_side(w, h, meters) : one_above_the_other(w, h, meters);
}

/// Whether a claim, on whatever step of the stage, says of an equation that it is wrong, or does not follow.
bool is_refuted(const Stage& stage, const Equation& equation) {
  const auto refutes = [&](const Block& block) {
    const auto* claim = std::get_if<Claim>(&block);
    return claim && claim->equation == equation.id &&
           (claim->kind == ClaimKind::is_false || claim->kind == ClaimKind::non_sequitur);
  };
  return std::any_of(stage.steps.begin(), stage.steps.end(), [&](const Step& step) {
    return std::any_of(step.blocks.begin(), step.blocks.end(), refutes);
  });
}

/// The equation the accent bar stands beside: of those of the present step that hold the first with a number,
/// else the first.
const Equation* focus_of(const Stage& stage, const Step& step) {
  const Equation* focus = nullptr;
  for (const Block& block : step.blocks) {
    const auto* equation = std::get_if<Equation>(&block);
    if (!equation || is_refuted(stage, *equation)) continue;
    if (!equation->tag.empty()) return equation;
    if (!focus) focus = equation;
  }
  return focus;
}

/// A step as pieces of the column: whole, and as its equations alone.
struct StepPieces {
  std::vector<ColumnPiece> whole, equations;
};

/// What of the earlier steps a page shows: nothing before `equations_from`, everything from `whole_from`.
struct Selection {
  std::size_t equations_from, whole_from;
};

/// From all to nothing of what came before the step of index `last`.
std::vector<Selection> selections(std::size_t last) {
  std::vector<Selection> all;
  for (std::size_t whole = 0; whole <= last; ++whole) all.push_back({0, whole});
  for (std::size_t equations = 1; equations <= last; ++equations) all.push_back({equations, last});
  return all;
}

class PageText {
 public:
  PageText(const PageRequest& request, const Grid& grid, const Fonts& fonts)
      : request_(request),
        grid_(grid),
        fonts_(fonts),
        symbols_(symbols_of(request.lesson, request.theme)),
        last_(static_cast<std::size_t>(request.step - 1)) {}

  struct Fitted {
    Stack stack;
    double scale;
  };
  /// Everything at its full size if that fits; else smaller; else less of what came before; else much
  /// smaller.
  Fitted fit() const {
    constexpr std::array<double, 3> kScales = {1.0, 0.93, kLeastScale};
    std::vector<std::vector<StepPieces>> by_scale;
    for (const Selection& selection : selections(last_))
      for (std::size_t i = 0; i < kScales.size(); ++i) {
        if (by_scale.size() == i) by_scale.push_back(all_pieces(kScales[i], 0));
        Stack made = stacked(by_scale[i], selection, kScales[i]);
        if (made.height <= grid_.text.height()) return {std::move(made), kScales[i]};
      }
    return much_smaller();
  }

 private:
  TextColumn column(double scale) const {
    return {grid_.text.width(), scale * grid_.em, request_.theme, symbols_, fonts_};
  }

  Fitted much_smaller() const {
    constexpr double kSmallest = 0.3;
    for (double scale = 0.94 * kLeastScale; scale > kSmallest; scale *= 0.94) {
      Stack made = stacked(all_pieces(scale, last_), {last_, last_}, scale);
      if (made.height <= grid_.text.height()) return {std::move(made), scale};
    }
    throw CommandError(ExitCode::invalid,
                       fmt::format("stage \"{}\": step {} has more text than a page holds; split it with ---",
                                   request_.stage.id, request_.step));
  }

  std::vector<StepPieces> all_pieces(double scale, std::size_t first) const {
    std::vector<StepPieces> pieces(last_ + 1);
    for (std::size_t i = first; i <= last_; ++i)
      pieces[i] = pieces_of(request_.stage.steps[i], i == last_, scale);
    return pieces;
  }

  StepPieces pieces_of(const Step& step, bool is_present, double scale) const {
    const TextColumn column = this->column(scale);
    const Equation* focus = is_present ? focus_of(request_.stage, step) : nullptr;
    const std::vector<std::string> marked =
        is_present && step.scene ? step.scene->highlight : std::vector<std::string>();
    StepPieces pieces;
    for (const Block& block : step.blocks) {
      if (const auto* equation = std::get_if<Equation>(&block)) {
        pieces.whole.push_back(column.equation(*equation, equation == focus, marked));
        // Without the words that refute it, what is wrong would stand there as if it were right.
        if (!is_present && !is_refuted(request_.stage, *equation))
          pieces.equations.push_back(column.earlier_equation(*equation));
      }
      if (const auto* prose = std::get_if<Prose>(&block)) pieces.whole.push_back(column.prose(prose->text));
      if (const auto* callout = std::get_if<Callout>(&block))
        pieces.whole.push_back(column.callout(*callout));
      if (const auto* ask = std::get_if<Ask>(&block)) pieces.whole.push_back(column.question(*ask));
    }
    return pieces;
  }

  Stack stacked(const std::vector<StepPieces>& steps, const Selection& shown, double scale) const {
    const bool is_whole = shown.whole_from == 0;
    std::vector<ColumnPiece> pieces = {header(), column(scale).title(request_.stage.title_text, !is_whole)};
    for (std::size_t i = shown.equations_from; i <= last_; ++i) {
      const auto& more = i < shown.whole_from ? steps[i].equations : steps[i].whole;
      pieces.insert(pieces.end(), more.begin(), more.end());
    }
    return stack(pieces);
  }

  /// Lesson, stage, step: small, above the title; without the lesson's title where that is too long.
  ColumnPiece header() const {
    TextStyle quiet;
    quiet.size = kHeaderSize * grid_.em;
    quiet.color = colors_of(request_.theme).quiet;
    quiet.sans = true;
    std::string place = fmt::format("stage {} of {}", request_.number, request_.lesson.stages.size());
    if (request_.stage.steps.size() > 1)
      place += fmt::format("  ·  step {} of {}", request_.step, request_.stage.steps.size());
    DisplayList line = set_line(request_.lesson.title + "  ·  " + place, quiet, fonts_);
    if (line.width > grid_.text.width()) line = set_line(place, quiet, fonts_);
    ColumnPiece piece;
    piece.height = std::round(quiet.size);
    piece.gap = kHeaderToTitle * grid_.em;
    piece.sheet.texts.push_back({.list = std::move(line), .at = {0, std::round(0.8 * quiet.size)}});
    return piece;
  }

  const PageRequest& request_;
  const Grid& grid_;
  const Fonts& fonts_;
  std::vector<MathSymbol> symbols_;
  std::size_t last_;  ///< index of the step
};

TimePlotStyle plot_style(Theme theme, double type_size) {
  const PageColors& colors = colors_of(theme);
  return {.type_size = type_size,
          .ink = colors.ink,
          .muted = colors.quiet,
          .grid = colors.line,
          .paper = colors.paper};
}

/// The figure, full size of its place.
Inset figure_inset(const PageRequest& request, const PixelRect& place) {
  const double aspect = static_cast<double>(place.width) / std::max(1, place.height);
  Inset inset{.figure = make_figure(*request.model, request.t_s, aspect),
              .place = place,
              .background = {},
              .quality = {}};
  if (request.theme == Theme::dark)
    inset.background = {Background::Kind::color, colors_of(request.theme).backdrop};
  return inset;
}

void add_meters(const PageRequest& request, const Grid& grid, const std::vector<TimePlot>& plots,
                Sheet& sheet, const Fonts& fonts) {
  const std::size_t columns = plots.size() > 3 ? 2 : plots.size();
  const std::size_t rows = columns == 0 ? 0 : (plots.size() + columns - 1) / columns;
  const double pad = 1.3 * grid.em;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const double width = grid.meters.width() / static_cast<double>(columns),
                 height = grid.meters.height() / static_cast<double>(rows);
    const double x = grid.meters.x0 + width * static_cast<double>(i % columns),
                 y = grid.meters.y0 + height * static_cast<double>(i / columns);
    const PixelBox box{x + pad, y + pad, x + width - 0.5 * pad, y + height - 0.6 * pad};
    append(sheet, lay_out(plots[i], box, plot_style(request.theme, kMeterSize * grid.em), fonts), {0, 0});
  }
}

}  // namespace

Page compose_page(const PageRequest& request, const Fonts& fonts) {
  const std::vector<TimePlot> plots =
      request.model ? meter_plots(*request.model, request.t_s) : std::vector<TimePlot>();
  const Grid grid = grid_of(request, plots.size());
  PageText::Fitted text = PageText(request, grid, fonts).fit();
  Page page;
  page.scale = text.scale;
  page.column = grid.text;
  page.meters = grid.meters;
  append(page.sheet, std::move(text.stack.sheet), {std::round(grid.text.x0), std::round(grid.text.y0)});
  if (!request.model) return page;
  page.insets.push_back(figure_inset(request, grid.figure));
  add_meters(request, grid, plots, page.sheet, fonts);
  return page;
}

}  // namespace polhode
