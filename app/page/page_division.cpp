// SPDX-License-Identifier: MIT
#include "app/page/page_division.h"

#include "app/page/figure_cells.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <limits>

namespace polhode {

namespace {

constexpr double kFullest = 0.97;    ///< of a page: computed numbers may be wider than what stands for them
constexpr double kCostOfPage = 1.0;  ///< beside that of room left over: of half a page 0.25
// Of a question that is followed by something on its page. Most cost less than a page more. For a prediction
// a page more is always cheaper: it costs at most 1, and 1 for the room that is left on each of the two.
constexpr double kCostOfQuestion = 0.35, kCostOfPrediction = 3.0;

double cost_of_questions(const Step& step) {
  double cost = 0.0;
  for (const Ask* ask : blocks_of<Ask>(step))
    cost = std::max(cost, ask->type == Ask::Type::predict ? kCostOfPrediction : kCostOfQuestion);
  return cost;
}

bool has_several_plots(const Scene& scene) {
  return scene.meters.size() > 1 || std::any_of(scene.beside.begin(), scene.beside.end(),
                                                [](const Scene& other) { return !other.meters.empty(); });
}

/// Of steps `first` to `last`, from 0.
int figures_in(const Stage& stage, std::size_t first, std::size_t last) {
  int count = 0;
  const Scene* before = nullptr;
  for (std::size_t i = first; i <= last; ++i) {
    const Scene* scene = stage.steps[i].scene.get();
    if (scene && !(before && (before == scene || same_picture(*before, *scene))))
      count += has_several_plots(*scene) ? 2 : 1;
    if (scene) before = scene;
  }
  return count;
}

double cost_of(const Stage& stage, std::size_t first, std::size_t last, double part) {
  const double left = std::max(0.0, 1.0 - part);
  double cost = kCostOfPage + left * left;
  for (std::size_t i = first; i < last; ++i) cost += cost_of_questions(stage.steps[i]);
  return cost;
}

}  // namespace

Result<std::vector<int>> pages_of_stage(const PageRequest& request, const Fonts& fonts) {
  const Stage& stage = request.stage;
  const std::size_t count = stage.steps.size();
  std::vector<FiguredStep> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({.step = static_cast<int>(i) + 1});
  // The cheapest division of the first k steps, and where its last page begins.
  std::vector<double> cost(count + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> begins(count + 1, 0);
  cost[0] = 0.0;
  for (std::size_t last = 0; last < count; ++last) {
    PageRequest until = request;
    until.step = static_cast<int>(last) + 1;
    until.model = nullptr;
    until.before = std::span(all).first(last);
    const Result<std::vector<double>> parts = parts_of_page(until, fonts);
    if (!parts) return failure(parts.error());
    for (std::size_t back = 0; back < parts->size(); ++back) {
      const std::size_t first = last - back;
      const bool fits = (*parts)[back] <= kFullest && figures_in(stage, first, last) <= kMostFiguresOnPage;
      if (back > 0 && !fits) break;  // a step alone is set smaller
      const double whole = cost[first] + cost_of(stage, first, last, (*parts)[back]);
      if (whole >= cost[last + 1]) continue;
      cost[last + 1] = whole;
      begins[last + 1] = first;
    }
  }
  std::vector<int> ends;
  for (std::size_t k = count; k > 0; k = begins[k]) ends.insert(ends.begin(), static_cast<int>(k));
  return ends;
}

}  // namespace polhode
