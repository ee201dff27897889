// SPDX-License-Identifier: MIT
#include "tests/render/drawing/plots/plot_examples.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

/// A method of some order over ten halved steps: `constant` h^order, no better than rounding and no worse
/// than half a turn, at `cost_ns` a step.
PlotSeries stepper(const char* label, PlotLook look, double order, double constant, double cost_ns,
                   bool emphasized) {
  PlotSeries series{.label = label, .emphasized = emphasized, .look = look};
  for (int k = 0; k < 10; ++k) {
    const double steps_per_period = 24.0 * std::exp2(k);
    const double truncation = constant * std::pow(24.0 / steps_per_period, order);
    const double rounding = 4e-15 * std::sqrt(100.0 * steps_per_period);
    series.points.emplace_back(cost_ns * steps_per_period, std::min(3.0, truncation + rounding));
  }
  return series;
}

}  // namespace

WorkPrecisionPlot plot_of_all_methods() {
  using L = PlotLook;
  WorkPrecisionPlot plot;
  plot.title = "Work and precision after 100 periods";
  plot.note = "$I$ = (1, 2, 3) kg m², $\\omega$ = (0.1, 1.5, 0.2) rad/s; one core, g++ 12 -O3";
  plot.x_label = "work, ns per period";
  plot.y_label = "error of attitude, rad";
  plot.series = {
      stepper("explicit Euler", L::orange, 1, 800, 8, false),
      stepper("explicit midpoint", L::orange, 2, 60, 15, false),
      stepper("RK4", L::orange, 4, 0.9, 28, true),
      stepper("RK4 projected", L::orange, 4, 0.012, 47, false),
      stepper("splitting", L::blue, 2, 8, 80, false),
      stepper("implicit midpoint", L::blue, 2, 14, 70, false),
      stepper("implicit midpoint, exp", L::blue, 2, 19, 78, false),
      stepper("Moser–Veselov 2", L::blue, 2, 11, 66, false),
      stepper("Moser–Veselov 6", L::blue, 6, 0.004, 74, true),
      stepper("Moser–Veselov 10", L::blue, 10, 4e-5, 86, true),
      stepper("Dormand–Prince 5", L::purple, 5, 0.02, 90, false),
      stepper("Dormand–Prince 8", L::purple, 8, 5e-5, 170, true),
      {.label = "exact", .points = {{6.2, 3.1e-15}}, .emphasized = true, .look = L::star},
  };
  plot.tolerance = 1e-6;
  plot.recommended = plot.series.back().points.back();
  plot.recommended_label = "cheapest within the tolerance";
  return plot;
}

}  // namespace polhode
