// SPDX-License-Identifier: MIT
// What of a scene there is to be seen, and what that needs of a model, added up from the rows of overlay.h:
// no more than that is modelled.
#pragma once

#include "render/scene/description/requirements.h"
#include "render/scene/description/scene.h"

#include <string>
#include <vector>

namespace polhode {

/// The overlays of a scene that there is something to see of. A polhode, herpolhode, cones and an invariable
/// plane belong to torque-free motion; the plane and the herpolhode to the space view, the plane also to L
/// pointing down (only there is it level); N to a torque; a body at rest without torque has its shape and its
/// axes alone.
OverlaySet drawn_overlays(const Scene& scene);

/// What is missing of an overlay that a scene shows, and why: "shows nothing: no torque acts". Empty: nothing
/// is. In the language of the scene.
std::string what_is_unseen(Overlay overlay, const Scene& scene);

/// Whether the motion is followed step by step, and may leave the surfaces of its start.
bool is_computed(const Scene& scene);

/// Whether only the motion knows where what is drawn can come: with marks, a torque, a path of the centre of
/// mass, or a method of steps. Else its beginning does.
bool frame_needs_motion(const Scene& scene);

/// What a scene is modelled for. A page has plots besides its figure; numbers need the motion, and nothing of
/// what is drawn.
enum class ModelFor { numbers, figure, page };

Requirements requirements(const Scene& scene, ModelFor use = ModelFor::figure);

}  // namespace polhode
