// SPDX-License-Identifier: MIT
// Where the figures of several steps stand on a page to read: each beside, or above, the text that it is for.
#pragma once

#include "app/page/page.h"

namespace polhode {

/// A picture of a page, with its plots.
struct FigureCell {
  const Step* step = nullptr;
  const SceneModel* model = nullptr;
  double t_s = 0;
  int first_step = 1, last_step = 1;  ///< that it is for
  PixelRect figure;
  PixelBox meters;
  bool are_plots_beside = false;  ///< on the right of the figure, else below it
};

/// Of steps that follow each other and have the same picture, that of the last. The step of the request comes
/// last. Without places.
std::vector<FigureCell> figures_on_page(const PageRequest& request);

/// Puts figures one below the other into `column`, each with its plots on its right. Where all have room,
/// each begins at its height of `tops`, px of the page, at which its text begins.
void place_beside(const std::vector<double>& tops, const PixelBox& column, double gap,
                  std::vector<FigureCell>& cells);
/// Puts them side by side into `band`, each with its plots below it.
void place_above(const PixelBox& band, double gap, std::vector<FigureCell>& cells);

}  // namespace polhode
