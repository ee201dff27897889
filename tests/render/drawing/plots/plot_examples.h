// SPDX-License-Identifier: MIT
// Made-up work-precision diagrams for tests of layout and picture.
#pragma once

#include "render/drawing/plots/plot.h"

namespace polhode {

/// A full ladder: thirteen steppers whose errors fall with their order down to rounding, and the exact
/// motion.
WorkPrecisionPlot ladder_plot();

}  // namespace polhode
