// SPDX-License-Identifier: MIT
// The tip of ω in a figure: where it is, and which ω a hand comes to that takes it and puts it elsewhere.
#pragma once

#include "render/gl/renderer.h"
#include "render/scene/model/model.h"

#include <optional>
#include <vector>

namespace polhode {

/// Where the tip of ω is in a figure, and in which pane.
struct TipOnScreen {
  std::size_t inset = 0;  ///< of the page
  std::size_t pane = 0;
  View view = View::space;
  double x = 0, y = 0;  ///< px of the page
};
/// Of every pane of the model's own space, the first inset, that shows ω; empty if none does. What stands
/// beside it is not taken hold of.
std::vector<TipOnScreen> omega_tips(const SceneModel& model, double t_s, const std::vector<Inset>& insets);

/// The ω, in body axes, whose tip is drawn at the point (px of the page) and the offset, or as near as any
/// can be. It has the present energy; under torque that of the moment. "Drawn" means in the same pane, in the
/// scene that starts with this ω, with `camera`, and with `attitude` at t = 0. In space the body keeps the
/// attitude of the moment, so that the motion goes on from there; but where the scene has to hold L down or
/// up it turns under the hand, and the tip stays at the pointer. Nothing for a body at rest. Found by
/// Levenberg and Marquardt's method from the present ω; if that does not get there, from others.
struct GrabbedOmega {
  Vec3 w0_B;
  std::optional<AttitudeSpec> attitude;  ///< that of the moment; absent: L stays where the scene holds it
  /// With the frame that the scene had before the hand. Where L stays, the body begins turned about the
  /// vertical beside the moment; a camera of space alone goes round with it, so that it is seen as it was.
  CameraSpec camera;
  Vec2 offset{0, 0};  ///< px by which the tip is drawn elsewhere as the motion begins anew; it is at the
                      ///< point and this, so that ω goes on from what it is
};
/// @param keeps_L the scene has to hold L down or up, if it does; it has anyway beside the invariable plane,
///   which is seen only where L points down
std::optional<GrabbedOmega> omega_at(const SceneModel& model, double t_s, const Inset& inset,
                                     std::size_t pane, double x, double y, bool keeps_L = false);

}  // namespace polhode
