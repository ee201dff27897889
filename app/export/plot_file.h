// SPDX-License-Identifier: MIT
// Plots as PNG files.
#pragma once

#include "base/result.h"
#include "render/drawing/plots/plot.h"
#include "render/image/image.h"

#include <filesystem>

namespace polhode {

inline constexpr Size kPlotSize{1920, 1080};  ///< px, a slide

/// Draws on paper and writes atomically; the file's Title and Description come from the plot. The error says
/// why not: no font, no OpenGL, or the file cannot be written.
Status write_plot(const std::filesystem::path& path, const WorkPrecisionPlot& plot);

/// What the plot shows, in words: for those who cannot see it.
std::string description_of(const WorkPrecisionPlot& plot);

}  // namespace polhode
