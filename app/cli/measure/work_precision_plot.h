// SPDX-License-Identifier: MIT
// The rows of a measurement as a work-precision diagram.
#pragma once

#include "app/cli/measure/measure_report.h"
#include "render/drawing/plots/plot.h"

namespace polhode {

/// CPU time a period, µs, against the larger of both errors; one series a method, those with a row on the
/// Pareto front, or on that of the methods that go step by step, emphasized. Rows that could not be computed
/// are left out.
WorkPrecisionPlot plot_of(const MeasureReport& report, const Problem& problem);

}  // namespace polhode
