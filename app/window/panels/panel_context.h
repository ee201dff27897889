// SPDX-License-Identifier: MIT
// What the bar and the panels of the window work with, and what they ask of it.
#pragma once

#include "app/narration/speech_text.h"
#include "app/session/lesson_session.h"
#include "app/session/method_cost.h"
#include "app/session/save_as.h"
#include "app/window/controls/control_style.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace polhode {

/// What cannot be done in a panel; done by the window after the frame.
struct WindowRequests {
  bool quit = false, full_screen = false;
  std::optional<SaveAs> save_as{};
  std::string clipboard{};  ///< to be copied; empty: nothing
};

/// A panel has its new height, and its scroll bar, two frames after it has new contents.
inline constexpr int kFramesOfFront = 3;

/// What is typed or chosen in the panels, and not yet part of the session.
struct PanelMemory {
  std::map<std::string, std::string> typed_answers{};  ///< by "stage/ask"
  std::optional<SceneEdits> edits{};                   ///< to be made
  double most_moment = 1, most_omega = 1;              ///< ends of sliders; they stand while one is held
  std::pair<Panel, Place> shown{};                     ///< panel and place of the frame before
  std::string refusal{};                               ///< why the last edit was not made; empty: it was
  SaveOptions save_as{};
  std::string folder{};
  std::unique_ptr<FrontMeasurement> front{};
  std::optional<Scene> front_of{};  ///< whose motion was measured
  int front_frames = 0;  ///< kFramesOfFront while it is shown as awaited, then down to 0 while it settles
  std::unique_ptr<AccuracyMeter> meter{};
  unsigned meter_of = 0;
  AccuracyReading live{};
  double live_shown_at = -1;  ///< of the clock: numbers change slowly enough to be read
  double live_of_t = 0;
  std::optional<Place> outlined{};  ///< that was scrolled to
  bool panel_has_focus = false;     ///< keys are for it
};

/// A rectangle of the display, px.
struct Region {
  float x = 0, y = 0, width = 0, height = 0;
};

struct PanelContext {
  LessonSession& session;
  const SpeechText& speech;
  const ControlSizes& sizes;
  PanelMemory& memory;
  WindowRequests& requests;
  double frame_ms = 0;      ///< wall time of the last frame in which a page was drawn
  double clock_s = 0;       ///< since the window opened
  bool take_focus = false;  ///< the panel was just opened by a key
};

/// Names of panels as the bar and help have them: "Outline".
const char* name_of(Panel panel);

/// Of the bar in a window of this width: narrow ones have two rows.
float bar_height(const ControlSizes& sizes, float width);
/// The row of controls below the page.
void draw_bar(PanelContext& context, const Region& region);
/// The panel that is open.
void draw_panel(PanelContext& context, const Region& region);

}  // namespace polhode
