// SPDX-License-Identifier: MIT
#include "app/export/plot_file.h"

#include "app/export/picture_metadata.h"
#include "render/gl/renderer.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

std::string description_of(const WorkPrecisionPlot& plot) {
  std::string text = fmt::format("{}: {} over {}, both logarithmic.", plot.title, plot.y_label, plot.x_label);
  for (const PlotSeries& s : plot.series) {
    if (s.points.empty()) continue;
    const auto best = std::min_element(s.points.begin(), s.points.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    text += fmt::format(" {}: down to {:.2g} at {:.3g}.", s.label, best->second, best->first);
  }
  if (plot.tolerance) text += fmt::format(" Tolerance {:g}.", *plot.tolerance);
  if (plot.recommended)
    text += fmt::format(" Marked at {:.3g}, {:.2g}: {}.", plot.recommended->first, plot.recommended->second,
                        plot.recommended_label);
  return text;
}

Status write_plot(const std::filesystem::path& path, const WorkPrecisionPlot& plot) {
  const auto context = open_context(ContextKind::any);
  if (!context) return failure(context.error());
  const auto fonts = Fonts::open();
  if (!fonts) return failure(fonts.error());
  const auto renderer = Renderer::create(**context, *fonts);
  if (!renderer) return failure(renderer.error());
  const Sheet sheet = lay_out(plot, kPlotSize.width, kPlotSize.height, *fonts);
  const Result<Image> image = (*renderer)->draw(sheet, kPlotSize, {Background::Kind::paper, {}});
  if (!image) return failure(image.error());
  const PngMetadata metadata{{{"Title", plot.title},
                              {"Description", description_of(plot)},
                              {"Software", program_name_and_version()}},
                             0};
  return write_png(path, *image, metadata);
}

}  // namespace polhode
