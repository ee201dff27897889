// SPDX-License-Identifier: MIT
// What a speaker sees while an audience sees the page: that page, the step that comes next, what the author
// means to say, the time, and all stages to jump to. It draws with the context, the renderer and the pictures
// of the audience's screen, which stays the one that acts: whatever is pressed here is done there.
#pragma once

#include "app/window/screen/screen.h"

#include <memory>

namespace polhode {

class ScreenOfSpeaker {
 public:
  /// `audience` must outlive it. Makes an ImGui context of its own, and leaves it the current one.
  static Result<std::unique_ptr<ScreenOfSpeaker>> create(Screen& audience);
  ~ScreenOfSpeaker();
  ScreenOfSpeaker(const ScreenOfSpeaker&) = delete;
  ScreenOfSpeaker& operator=(const ScreenOfSpeaker&) = delete;

  /// Behind a frame of the audience's screen, which it shows. The page itself costs a copy, the next step as
  /// much as a page, once.
  Status draw(LessonSession& session, const ScreenFrame& frame);
  /// Until the clock shows something else.
  double seconds_to_wake() const;

  const Framebuffer& picture() const { return *picture_; }
  Image read() const { return picture_->read(); }
  ImGuiContext* imgui() const { return imgui_; }
  /// Since it was made, or since the speaker set it to nought.
  double elapsed_s() const { return clock_s_ - begun_s_; }

 private:
  ScreenOfSpeaker(Screen& audience, std::unique_ptr<ControlPass> controls, ImGuiContext* imgui);
  struct Areas {
    Region page, controls, outline, next, notes;
  };
  Areas areas_of(Size size) const;
  Region figure_in(const Region& page) const;
  void adopt_style(const LessonSession& session, const ScreenFrame& frame);
  void draw_controls(LessonSession& session, const Region& region);
  void draw_clock(const LessonSession& session);
  void draw_outline(LessonSession& session, const Region& region);
  void draw_notes(const LessonSession& session, const Region& region);
  void show_page(const LessonSession& session, const Region& region);
  void show_next(const LessonSession& session, const Region& region);
  void point(const LessonSession& session, const Region& page) const;

  Screen& audience_;
  std::unique_ptr<ControlPass> controls_;
  ImGuiContext* imgui_;
  PageView next_page_;
  LessonTexts texts_;
  std::optional<Framebuffer> picture_;
  std::unique_ptr<LessonSession> next_;  ///< at the step after the present one
  std::optional<ControlSizes> sizes_;
  std::optional<Theme> theme_;
  std::optional<StepPlace> shown_place_;
  std::optional<float> controls_height_;  ///< of the buttons and the clock, px, as the last frame had it
  bool pointer_is_left_ = false;          ///< since a step came or a button was pressed it has not moved
  std::optional<StepPlace> outlined_;     ///< where the outline was scrolled to
  double clock_s_ = 0, begun_s_ = 0;
};

}  // namespace polhode
