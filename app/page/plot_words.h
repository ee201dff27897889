// SPDX-License-Identifier: MIT
// What the plots and diagrams of a figure show, in words, for readers who cannot see them.
#pragma once

#include "app/narration/alt_text.h"
#include "app/narration/speech_text.h"
#include "render/drawing/plots/time_plot.h"
#include "render/scene/model/model.h"
#include "render/typeset/fonts.h"

#include <string>
#include <vector>

namespace polhode {

/// How a curve of a plot goes: "rises from 1 to 2", "oscillates between minus 1 and 1, with 3 maxima", "stays
/// at 2", computed from the values that are drawn. What is smaller than a twentieth of the curve's height is
/// no turn; what is less than a thousandth of the plot's height is no change.
std::string course_in_words(const TimePlot& plot, const TimeSeries& curve);

/// Of all plots that stand beside the model's figure, at t_s: the title, what they are against, from where to
/// where, and how each curve goes. `names` is what is said of a label. Where a question is asked of the
/// figure, whose answer may lie in how they go, it is read as it is by eye: at most 25 values, at both ends
/// of a curve, at each top and bottom and, where those are few, halfway between them. Empty: there are no
/// plots.
std::string words_of_plots(const SceneModel& model, double t_s, const SpeechText& names, bool is_asked);

/// What stands in the diagrams of a figure, titles, terms and numbers in the order in which they are drawn;
/// of plots of orders nothing, whose curves alt_text tells. Empty: there are no others.
std::string words_of_diagrams(const SceneModel& model, double t_s, const SpeechText& names,
                              const Fonts& fonts);

/// All that is told of a figure and what stands beside it: alt_text, its diagrams and its plots.
/// @param fonts null: diagrams are left out
std::string figure_in_words(const SceneModel& model, const std::vector<SceneInWords>& said, double t_s,
                            const SpeechText& names, const Fonts* fonts);

}  // namespace polhode
