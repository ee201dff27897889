// SPDX-License-Identifier: MIT
// Error against steps, each method a curve; the steeper, the higher its order.
#include "render/drawing/diagrams/diagram_paper.h"
#include "render/drawing/plots/method_look.h"

#include <algorithm>
#include <cmath>

namespace polhode::diagrams {
namespace {

const Vec2 kLeast(30, 20), kMost(52, 34);
constexpr double kTypeSize = 43.5;    ///< makes its labels as large as the type of a diagram
constexpr double kLargestError = 10;  // beyond, a method has not followed the motion at all

struct Sample {
  double step_s, error;
  double evaluations;  ///< in all
};

/// Of one method, from the longest step to the shortest.
std::vector<Sample> samples_of(Method method, const std::vector<MethodTable>& tables) {
  std::vector<Sample> samples;
  for (const MethodTable& table : tables)
    for (const MethodRow& row : table.rows)
      if (row.method == method && row.error.omega <= kLargestError)
        samples.push_back({table.step_s, row.error.omega, row.evaluations_per_s * std::abs(table.t_s)});
  return samples;
}

/// log₂ of what the last halving of the step did to the error, where the error is small, and far above
/// rounding, which grows with the number of steps.
std::optional<double> measured_order(const std::vector<Sample>& samples) {
  constexpr double kSmall = 0.05, kAboveRounding = 3e-12;
  std::optional<double> order;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i - 1].error < kSmall && samples[i].error > kAboveRounding)
      order = std::log2(samples[i - 1].error / samples[i].error);
  return order;
}

std::string words_of(const std::optional<double>& order) {
  if (!order) return "";
  NumberForm one_decimal(*order, *order < 10 ? 2 : 3);
  return "order " + one_decimal.text(*order);
}

std::vector<PlotSeries> series_of(const std::vector<MethodTable>& tables, double t_s, bool by_evaluations) {
  std::vector<PlotSeries> all;
  for (const MethodRow& row : tables.front().rows) {
    if (facts_of(row.method).control != StepControl::fixed) continue;
    const std::vector<Sample> samples = samples_of(row.method, tables);
    PlotSeries series{.label = std::string(facts_of(row.method).term),
                      .detail = words_of(measured_order(samples)),
                      .points = {},
                      .emphasized = true,
                      .look = look_of(row.method),
                      .place = place_of(row.method)};
    for (const Sample& sample : samples)
      series.points.emplace_back(by_evaluations ? sample.evaluations : std::abs(t_s) / sample.step_s,
                                 sample.error);
    if (!series.points.empty()) all.push_back(std::move(series));
  }
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
              .series = series_of(model.orders, t_s, by_evaluations),
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
