// SPDX-License-Identifier: MIT
// Made-up work-precision diagrams for tests of layout and picture.
#pragma once

#include "render/drawing/plots/plot.h"

namespace polhode {

/// All methods: thirteen steppers whose errors fall with their order down to rounding, and the exact
/// motion.
WorkPrecisionPlot plot_of_all_methods();

}  // namespace polhode
