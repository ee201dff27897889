// SPDX-License-Identifier: MIT
// What is said of how the motion that is shown is computed: what of it, and why by this method.
#pragma once

#include "app/session/lesson_session.h"
#include "render/scene/model/model.h"

#include <string>
#include <vector>

namespace polhode {

/// What the model's scene requires, in words ("ω(t)", "attitude", "polhode"), and what is therefore not
/// computed.
struct RequirementWords {
  std::vector<std::string> computed, left_out;
};
RequirementWords requirement_words(const SceneModel& model);

/// Why the motion that is shown is computed by its method: what the scene's model says of it, unless the
/// method was chosen here instead of the lesson's. Precondition: there is a scene.
std::string why_method(const LessonSession& session);

}  // namespace polhode
