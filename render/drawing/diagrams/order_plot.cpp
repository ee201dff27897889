// SPDX-License-Identifier: MIT
// Error against steps, each method a curve; the steeper, the higher its order.
#include "render/drawing/diagrams/diagram_paper.h"
#include "render/drawing/plots/method_look.h"
#include "render/scene/model/method_orders.h"

#include <algorithm>

namespace polhode::diagrams {
namespace {

const Vec2 kLeast(30, 20), kMost(52, 34);
constexpr double kTypeSize = 43.5;  ///< makes its labels as large as the type of a diagram

std::string words_of(const std::optional<double>& order) {
  if (!order) return "";
  NumberForm one_decimal(*order, *order < 10 ? 2 : 3);
  return "order " + one_decimal.text(*order);
}

std::vector<PlotSeries> series_of(const std::vector<MethodOrder>& orders) {
  std::vector<PlotSeries> all;
  for (const MethodOrder& one : orders)
    all.push_back({.label = std::string(facts_of(one.method).term),
                   .detail = words_of(one.order),
                   .points = one.points,
                   .emphasized = true,
                   .look = look_of(one.method),
                   .place = place_of(one.method)});
  return all;
}

void draw(const SceneModel& model, double /*unused*/, Arrangement /*unused*/, DiagramPaper& paper) {
  if (model.orders.empty()) return;
  const double t_s = model.orders.front().t_s;
  const bool by_evaluations = model.scene.compared.by_evaluations;
  const std::string work = by_evaluations ? "evaluations" : "steps";
  paper.plot({.title = "",  // its axes say what it is
              .x_label = work + " in " + NumberForm(t_s, 3).text(t_s) + " s",
              .y_label = "error of $\\vec\\omega$, relative",
              .series = series_of(method_orders(model.orders, by_evaluations)),
              .tolerance = {},
              .recommended = {},
              .recommended_label = {},
              .note = "order: log₂ of error($h$) / error($h/2$)",
              .names_at_end = true,
              // A plot's type goes by the size of the plot, a diagram's does not.
              .scale = kTypeSize / std::min(paper.extent().y(), paper.extent().x() * 9.0 / 16.0)},
             {0, 0}, paper.extent());
}

}  // namespace

const DiagramKind kOrderPlot{kLeast, kLeast, draw, kMost};

}  // namespace polhode::diagrams
