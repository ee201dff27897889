// SPDX-License-Identifier: MIT
// A scene as an author would write it: what was made by hand in the window becomes a lesson.
#pragma once

#include "app/session/lesson_session.h"

#include <string>
#include <string_view>

namespace polhode {

/// "[body.NAME]" with its keys, moments about the pivot as such; empty for a built-in body. The shape is left
/// out where the body's moments are not those of the shape, neither about the centre of mass nor about the
/// pivot of this torque.
std::string own_body_of(const Body& body, const Torque& torque);

/// The present stage as a lesson of its own, which `polhode export` reads. It has the lesson's front matter
/// (title, symbols, macros) with the scene's body, and one stage: its steps up to the present one as the
/// author wrote them, but the scene as it is now in place of the stage's first, and later scene blocks empty.
/// The last step has the same figure as the session to the byte, and the same page, save for the line above
/// the title, which says stage 1 of 1; a symbol that is merely pointed at is not highlighted. `id` is what
/// its file is called; what can be no id, such as an empty one, is that of the stage. Measured claims may
/// fail on a motion that was changed; the lesson reads all the same, and `lint` says so.
std::string lesson_of(const LessonSession& session, std::string_view id = {});

/// As `polhode trace --format csv`: of the present motion, over the interval of the time line, with a line
/// for each frame of a film at speed 1, at most kMostTraceLines; it ends where the motion does. Empty without
/// a scene.
std::string trace_of(const LessonSession& session);
inline constexpr int kMostTraceLines = 20'000;

}  // namespace polhode
