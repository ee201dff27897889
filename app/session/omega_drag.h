// SPDX-License-Identifier: MIT
// The tip of ω in a figure: where it is, and which ω a hand comes to that takes it and puts it elsewhere.
#pragma once

#include "render/drawing/label_layout.h"
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
  double x = 0, y = 0;    ///< px of the page
  double x0 = 0, y0 = 0;  ///< where the arrow begins
};
/// Of every pane of the model's own space, the first inset, that shows ω; empty if none does. What stands
/// beside it is not taken hold of.
std::vector<TipOnScreen> omega_tips(const SceneModel& model, double t_s, const std::vector<Inset>& insets);

/// Likewise of arrows of the lesson's that are ω with a tail, a length or a scale of their own: no hand takes
/// it by them. They have no arrow of their own here.
std::vector<TipOnScreen> untaken_tips(const SceneModel& model, double t_s, const std::vector<Inset>& insets);

/// An arrow as it stands on the page, px.
struct ArrowOnScreen {
  Vec2 tail, tip;
};
/// All of a figure.
std::vector<ArrowOnScreen> arrows_on_page(const Inset& inset);
/// What else of a figure is no ground: a box around each body and surface, boxes of this size along curves.
std::vector<PixelBox> bodies_on_page(const Inset& inset, double size);

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
  double off_px = 0;  ///< of the tip from there: as near as any of this energy comes
};
/// @param keeps_L the scene has to hold L down or up, if it does; it has anyway beside the invariable plane,
///   which is seen only where L points down
std::optional<GrabbedOmega> omega_at(const SceneModel& model, double t_s, const Inset& inset,
                                     std::size_t pane, double x, double y, bool keeps_L = false);

/// The same with an ω of `factor` times the present length: its energy is another. The tip is nowhere in
/// particular.
std::optional<GrabbedOmega> scaled_omega(const SceneModel& model, double t_s, const Inset& inset,
                                         std::size_t pane, double factor, bool keeps_L = false);

/// Makes of what was grabbed at t what reaches it at t instead of beginning with it: ω and attitude at t = 0,
/// and the camera from which it is seen as it is held. False, with nothing changed, where no closed form
/// leads back from t, where so many digits are lost on the way that one would see it, or for a picture that
/// is turned otherwise on the way.
bool begin_before(const SceneModel& model, double t_s, const Inset& inset, std::size_t pane,
                  GrabbedOmega& grabbed);

}  // namespace polhode
