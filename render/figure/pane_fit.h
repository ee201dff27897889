// SPDX-License-Identifier: MIT
// The camera that holds what a scene shows: as near as it can stand, with the middle of it all in the middle
// of the pane.
#pragma once

#include "render/figure/builders/extents.h"
#include "render/figure/camera.h"

namespace polhode {

/// What is free of the pane, of its height and width on each side.
struct PaneMargins {
  double side = 0.025, top = 0.035, bottom = 0.035;
};

/// How a pane is to be filled: which point is in its middle, how far the eye stands, how wide it looks.
struct PaneFit {
  Vec3 target{0, 0, 0};
  double radius = 1;    ///< of what is held, scene units: the eye stands `distance` of them away
  double half_tan = 1;  ///< of half the field of view, vertical, before the camera's zoom
};

/// The narrowest field in which an eye in the direction of `spec` (or that of its `fitted` camera),
/// `distance` radii from the middle, sees all extents; exact for each of them. An eye that would stand among
/// them stands outside.
/// @param least_radius of what is held: of panes that are to have one scale, the largest
PaneFit pane_fit(const builders::Extents& extents, const CameraSpec& spec, double aspect,
                 const PaneMargins& margins, double least_radius = 0);

/// Looks from the direction of `spec` itself at the frame.
Camera fitted_camera(const PaneFit& fit, const CameraSpec& spec);

}  // namespace polhode
