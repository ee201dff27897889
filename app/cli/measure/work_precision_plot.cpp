// SPDX-License-Identifier: MIT
#include "app/cli/measure/work_precision_plot.h"

#include "render/drawing/plots/method_look.h"

#include <fmt/format.h>

#include <cmath>

namespace polhode {

namespace {

constexpr double kNanosecondsPerMicrosecond = 1e3;
constexpr double kExploded = 100;  // errors beyond are of no size worth an axis

std::pair<double, double> point_of(const WorkPrecisionRow& row) {
  return {row.ns_per_period / kNanosecondsPerMicrosecond, row.error()};
}

std::vector<PlotSeries> series_of(const std::vector<WorkPrecisionRow>& rows) {
  const std::vector<bool> front = pareto_front(rows), of_steps = front_step_by_step(rows);
  std::vector<PlotSeries> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].method != rows[i - 1].method) {
      PlotSeries& fresh = all.emplace_back();
      fresh.label = name_of(rows[i].method);
      fresh.look = look_of(rows[i].method);
      fresh.place = place_of(rows[i].method);
    }
    if (rows[i].error() < kExploded) all.back().points.push_back(point_of(rows[i]));
    if (front[i] || of_steps[i]) all.back().emphasized = true;
  }
  std::erase_if(all, [](const PlotSeries& series) { return series.points.empty(); });
  return all;
}

/// For a page, which has a µ and little room.
std::string label_of(const WorkPrecisionRow& row) {
  WorkPrecisionRow without_step = row;
  without_step.step_s.reset();
  std::string text = cost_text(without_step);
  if (const auto at = text.find(" us "); at != std::string::npos) text.replace(at, 4, " µs ");
  return row.step_s ? fmt::format("step {:.3g} s, {}", *row.step_s, text) : text;
}

std::string note_of(const MeasureReport& report, const Problem& problem) {
  const Vec3 I = problem.I.vector(), w_B = problem.start.w_B;
  return fmt::format(
      "I = ({:.4g}, {:.4g}, {:.4g}) kg m², ω = ({:.4g}, {:.4g}, {:.4g}) rad/s at t = 0{}; {:g} {} "
      "of {:.4g} s",
      I[0], I[1], I[2], w_B[0], w_B[1], w_B[2], problem.torque.empty() ? ", no torque" : ", with torque",
      report.periods, report.unit, report.period_s);
}

}  // namespace

WorkPrecisionPlot plot_of(const MeasureReport& report, const Problem& problem) {
  WorkPrecisionPlot plot;
  plot.title = "What accuracy costs";
  plot.x_label = "CPU time a period, µs";
  plot.y_label = fmt::format("error after {:g} {}: the larger of ω (relative) and attitude (rad)",
                             report.periods, report.unit);
  plot.series = series_of(report.rows);
  plot.tolerance = report.tolerance;
  plot.note = note_of(report, problem);
  if (report.recommended) {
    plot.recommended = point_of(report.rows[*report.recommended]);
    plot.recommended_label = label_of(report.rows[*report.recommended]);
  }
  return plot;
}

}  // namespace polhode
