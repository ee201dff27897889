// SPDX-License-Identifier: MIT
// What a student takes out of the window: pictures as export makes them, the motion as numbers, the scene as
// a lesson, the answers to hand in.
#pragma once

#include "app/session/lesson_session.h"
#include "render/gl/renderer.h"

#include <filesystem>
#include <string>

namespace polhode {

enum class SaveAs { page, figure, equation, trace, scene, answers };

struct SaveOptions {
  Size size{1920, 1080};     ///< of pages and figures
  bool transparent = false;  ///< background of pictures
  std::string student = {};  ///< who hands in answers, as typed; empty: nobody says
  bool operator==(const SaveOptions&) const = default;
};

/// Whether there is something of the kind on this step.
bool can_save_as(const LessonSession& session, SaveAs what);
/// Whether the equation of this step is the reader's derivation: it has none of its own, and asks for one.
bool saves_derivation(const LessonSession& session);

/// Writes a file into the folder, which is made if need be; it appears whole or not at all. Its name is the
/// one that export gives (07-poinsot-step3.png; the names of figures, traces and scenes also have their
/// kind), and if that is taken, has a number behind it: nothing is overwritten. A picture is the one that
/// `polhode export` makes of the same state, byte for byte on the same driver. Of several equations the last
/// is saved; of a step that has none and asks for a derivation, the lines of that as far as it goes: nothing
/// before the reader has one. Answers are those to the whole lesson: quiz-answers.txt (answer_report.h).
Result<std::filesystem::path> save_as(const LessonSession& session, SaveAs what, const SaveOptions& options,
                                      const std::filesystem::path& folder, Renderer& renderer);

/// A name in the folder that is not taken yet for slides of the lesson: quiz-slides.pdf. `ending` has its
/// dot.
std::filesystem::path slides_path(const LessonSession& session, const std::filesystem::path& folder,
                                  const std::string& ending);

}  // namespace polhode
