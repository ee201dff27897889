// SPDX-License-Identifier: MIT
// What a page costs beside its figure.
#pragma once

#include <vector>

namespace polhode::bench {

/// For each stage of the lecture at its last step, 1600x1000: CPU time of layout, plots and drawing, without
/// any glyph kept, less that of the figure drawn alone; the median of three runs. ms
std::vector<double> page_costs_ms();

/// Of the lecture's derivations, each of its own lines typed letter by letter, as in a window of 1280x800:
/// CPU time of reading what is typed so far and laying out the page with it. ms, one for each letter.
std::vector<double> typing_costs_ms();
/// The same lines: CPU time of judging each. ms
std::vector<double> judging_costs_ms();

}  // namespace polhode::bench
