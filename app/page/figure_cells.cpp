// SPDX-License-Identifier: MIT
#include "app/page/figure_cells.h"

#include "app/page/figure_place.h"
#include "render/drawing/plots/meter_plots.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

constexpr double kFigurePart = 0.56;  ///< of the width, beside plots; of the height, above them
constexpr double kLeastPart = 0.8;    ///< of an even share of the column: no figure is lower
constexpr double kHighestPlot = 0.9;  ///< of its width, of one that stands alone beside a figure

PixelRect rounded(const PixelBox& box) {
  const auto px = [](double v) { return static_cast<int>(std::lround(v)); };
  return {px(box.x0), px(box.y0), px(box.x1) - px(box.x0), px(box.y1) - px(box.y0)};
}

/// The figure, and its plots beside or below it; plots that are all there is have the place of the figure.
void fill(const PixelBox& place, bool beside, FigureCell& cell) {
  PixelBox figure = place, meters = place;
  const bool has_plots = meter_count(*cell.model) > 0 || each_has_meters(*cell.model);
  if (has_plots && !is_plots_alone(*cell.model)) {
    cell.are_plots_beside = beside && !each_has_meters(*cell.model);
    if (cell.are_plots_beside) {
      figure.x1 = meters.x0 = std::round(std::lerp(place.x0, place.x1, kFigurePart));
      const double spare = place.height() - kHighestPlot * meters.width();
      if (meter_count(*cell.model) == 1 && spare > 0.0)
        meters = {meters.x0, meters.y0 + std::round(0.5 * spare), meters.x1,
                  meters.y1 - std::round(0.5 * spare)};
    } else
      figure.y1 = meters.y0 = std::round(std::lerp(place.y0, place.y1, kFigurePart));
  }
  cell.figure = rounded(figure);
  cell.meters = meters;
}

/// Where parts begin that wish to begin at `tops` and are at least `least` high.
std::vector<double> beginnings(std::vector<double> tops, const PixelBox& column, double least) {
  tops.front() = column.y0;
  for (std::size_t k = 1; k < tops.size(); ++k) tops[k] = std::max(tops[k], tops[k - 1] + least);
  double end = column.y1;
  for (std::size_t k = tops.size(); k-- > 1;) end = tops[k] = std::round(std::min(tops[k], end - least));
  return tops;
}

}  // namespace

std::vector<FigureCell> figures_on_page(const PageRequest& request) {
  std::vector<FigureCell> cells;
  const auto take = [&](int number, const SceneModel* model, double t_s) {
    if (model == nullptr) {
      if (!cells.empty()) cells.back().last_step = number;
      return;
    }
    const Step& step = request.stage.steps[static_cast<std::size_t>(number - 1)];
    const bool stays = !cells.empty() && step.scene && cells.back().step->scene &&
                       same_picture(*cells.back().step->scene, *step.scene);
    const int first = stays ? cells.back().first_step : number;
    if (stays) cells.pop_back();
    cells.push_back({.step = &step,
                     .model = model,
                     .t_s = t_s,
                     .first_step = first,
                     .last_step = number,
                     .figure = {},
                     .meters = {}});
  };
  if (request.before)
    for (const FiguredStep& one : *request.before) take(one.step, one.model, one.t_s);
  take(request.step, request.model, request.t_s);
  return cells;
}

void place_beside(const std::vector<double>& tops, const PixelBox& column, double gap,
                  std::vector<FigureCell>& cells) {
  const double least = kLeastPart * column.height() / static_cast<double>(cells.size());
  const std::vector<double> from = beginnings(tops, column, least);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const bool is_last = k + 1 == cells.size();
    fill({column.x0, from[k], column.x1, is_last ? column.y1 : from[k + 1] - gap}, true, cells[k]);
  }
}

void place_above(const PixelBox& band, double gap, std::vector<FigureCell>& cells) {
  const double count = static_cast<double>(cells.size());
  const double width = (band.width() - (count - 1.0) * gap) / count;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double x = std::round(band.x0 + static_cast<double>(k) * (width + gap));
    fill({x, band.y0, k + 1 == cells.size() ? band.x1 : std::round(x + width), band.y1}, false, cells[k]);
  }
}

}  // namespace polhode
