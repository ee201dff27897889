// SPDX-License-Identifier: MIT
// A scene as an author would write it: what was made by hand in the window becomes a lesson.
#pragma once

#include "app/session/lesson_session.h"

#include <string>

namespace polhode {

/// "[body.NAME]" with its keys; empty for a built-in body. A shape whose moments are not its own, about the
/// centre of mass or about the pivot of this torque, is left out.
std::string own_body_of(const Body& body, const Torque& torque);

/// A whole lesson that `polhode export` reads: the front matter with the lesson's title, symbols and macros,
/// and the scene's body; one stage, with its steps up to the present one as the author wrote them; and the
/// scene, as it is now, from the step on that had the stage's first one (later scene blocks are empty). Its
/// last step has the figure of the session's model to the byte, and its page too, but for the line above
/// the title: stage 1 of 1, the last step. What is merely pointed at is not highlighted in it. The lesson's
/// id, and the name that its file should have, is that of the stage. Measured claims of the stage may fail on
/// a motion that was changed: the reader takes them, `lint` says so.
std::string lesson_of(const LessonSession& session);

/// As `polhode trace --format csv`: of the present motion, over the interval of the time line, with a line
/// for each frame of a film at speed 1, at most kMostTraceLines; it ends where the motion does. Empty without
/// a scene.
std::string trace_of(const LessonSession& session);
inline constexpr int kMostTraceLines = 20'000;

}  // namespace polhode
