// SPDX-License-Identifier: MIT
// A picture as lists to draw: one pane for each view. make_figure.h makes it of a scene.
#pragma once

#include "render/figure/camera.h"
#include "render/figure/draw_list.h"

#include <string>
#include <vector>

namespace polhode {

/// A pane covers a part of the picture; x, y, width, height are fractions of it, y from the top.
struct Pane {
  double x = 0, y = 0, width = 1, height = 1;
  std::string title;  ///< names the frame where there are two panes
  Camera camera;
  DrawList list;
};

struct Figure {
  std::vector<Pane> panes;
  /// Em of a caption that stands below it; all type in the figure goes with it. 0: from the size of the
  /// picture.
  double caption_px = 0;
};

}  // namespace polhode
