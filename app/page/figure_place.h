// SPDX-License-Identifier: MIT
// What stands in the place of a scene's figure: its space, its diagrams, or both side by side and never over
// each other, with the caption below the picture; of scenes side by side, all of them. The same for a figure
// by itself and for a figure on a page.
#pragma once

#include "app/page/page_theme.h"
#include "render/drawing/diagrams/diagrams.h"
#include "render/gl/renderer.h"

namespace polhode {

/// What a user chooses from: draft has meshes with jagged edges, fine 2 x 2 times the pixels. What they cost:
/// `polhode measure --rendering`.
Quality quality_of(QualityLevel level);

struct FigurePlace {
  PixelRect rect{};
  double caption_px = 0;  ///< em of the caption, > 0; all other type goes with it
  Theme theme = Theme::paper;
  Background background{};        ///< of the space
  std::optional<Color> ground{};  ///< of diagrams and caption, painted; absent: what is under the sheet
  Quality quality{};
  /// Of the scenes in the order in which they stand, lines with formulas between `$`; none: the scenes' own.
  std::vector<std::string> captions{};
  /// Of a film: a caption of the still alone, which one frame would show, is left out.
  bool is_frame = false;
  /// Captions have their room and are not written: the figure of a scene that was changed by hand stays where
  /// it is.
  bool rooms_alone = false;
};

struct PlacedFigure {
  Sheet sheet{};
  std::vector<Inset> insets{};
  /// Of scenes that show nothing but plots: what is left for these, of each scene in its order.
  std::vector<PixelBox> plots{};
};

/// Whether a page has the plots of the scene in the place of its figure, for it shows nothing else.
bool is_plots_alone(const SceneModel& model);

/// The diagrams' type is as large as there is room for, up to that of labels. Where space and diagrams share
/// the place, they share it left and right or above and below, as serves both better; so do scenes, in equal
/// parts. A caption that all have in common stands once, below them. The first inset is that of the model's
/// own space, if it shows one.
PlacedFigure place_figure(const SceneModel& model, double t_s, const FigurePlace& place, const Fonts& fonts);

/// Whether each of several scenes has its plots on a page, below it, where they stand left and right; else
/// there are plots of the model's own scene alone.
bool each_has_meters(const SceneModel& model);

/// Em of the caption of a figure by itself.
double caption_px_of(Size size);

}  // namespace polhode
