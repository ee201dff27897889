// SPDX-License-Identifier: MIT
// What a page costs beside its figure.
#pragma once

#include <vector>

namespace polhode::bench {

/// For each stage of the lecture at its last step, 1600x1000: CPU time of layout, plots and drawing, without
/// any glyph kept, less that of the figure drawn alone; the median of three runs. ms
std::vector<double> page_costs_ms();

}  // namespace polhode::bench
