// SPDX-License-Identifier: MIT
// What the bar and the panels of the window work with, and what they ask of it.
#pragma once

#include "app/narration/speech_text.h"
#include "app/session/answers/progress.h"
#include "app/session/lesson_session.h"
#include "app/session/saved/save_as.h"
#include "app/window/controls/control_style.h"
#include "app/window/controls/lesson_texts.h"
#include "app/window/controls/overlay_pictures.h"
#include "base/words/phrase.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// What cannot be done while a panel is drawn; the panels or the window do it afterwards.
struct WindowRequests {
  bool quit = false, full_screen = false, leave_full_screen = false;
  bool next_step = false;
  bool find = false;                    ///< words are to be typed that are looked for
  bool type_answer = false;             ///< the panel of questions was opened by the mouse, to be typed in
  const Ask* type_answer_to = nullptr;  ///< the one that was clicked; null: none
  std::string open_lesson{};            ///< id of another lesson; empty: none
  std::optional<SaveAs> save_as{};
  std::string slides{};                 ///< to be made of the chosen stages: ".html", ".pdf"; empty: none
  std::filesystem::path slides_file{};  ///< where, once it is known
  std::string read_aloud{};             ///< what is to be read aloud, or is being read; empty: nothing
  std::string clipboard{};              ///< to be copied; empty: nothing
  /// They make another model, and what is being drawn refers to the present one.
  std::optional<SceneEdits> edits{};
  std::optional<Counterexample> counterexample{};  ///< to be shown in the figure, likewise
};

/// A rectangle of the display, px.
struct Region {
  float x = 0, y = 0, width = 0, height = 0;
};

struct PanelContext {
  LessonSession& session;
  const SpeechText& speech;
  LessonTexts& texts;
  OverlayPictures& pictures;
  const ControlSizes& sizes;
  WindowRequests& requests;
  double frame_ms = 0;                         ///< wall time of the last frame in which a page was drawn
  double clock_s = 0;                          ///< since the window opened
  const std::vector<LessonProgress>& lessons;  ///< all that there are, this one among them
  bool take_focus = false;                     ///< the panel was just opened by a key, or to be typed in
  bool finds = false;                          ///< and words are to be typed that are looked for
  const Ask* typed_to = nullptr;               ///< whose field takes it; null: the first that there is
  bool has_keys = false;                       ///< keys are for the panel (Panels::has_focus)
  bool is_reached = false;                     ///< Tab has just come to the control that has the focus

  Language language() const { return session.lesson().about.language; }
  std::string said(const Phrase& phrase) const { return std::string(phrase.in(language())); }
};

/// Of the bar in a window of this width: narrow ones have two rows.
float bar_height(const ControlSizes& sizes, float width, Language language);
/// The row of controls below the page.
void draw_bar(PanelContext& context, const Region& region);

}  // namespace polhode
