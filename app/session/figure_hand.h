// SPDX-License-Identifier: MIT
// A pointer on the figure, whoever has it, a window or a page: a drag turns the camera, or takes ω by its
// tip.
#pragma once

#include "app/session/lesson_session.h"
#include "render/gl/renderer.h"

#include <cstddef>
#include <string>
#include <vector>

namespace polhode {

class FigureHand {
 public:
  enum class On { nothing, figure, omega };

  /// What is held.
  On held() const { return held_; }
  /// What a hand at the point (px of the page) would take: the tip of ω within `reach` px, else the figure.
  /// @param insets of the page that is shown
  static On under(const LessonSession& session, const std::vector<Inset>& insets, const Vec2& at,
                  double reach);
  /// Takes it. For ω's tip the motion stops.
  On take(LessonSession& session, const std::vector<Inset>& insets, const Vec2& at, double reach);
  /// Moves what is held to the point, by (dx, dy) px since the last time. The motion goes on from its present
  /// t where a closed form leads back from there, and unless a question judges what it begins with.
  /// @param scales pulls at the length of ω, along its arrow: its energy is not kept
  /// @returns why ω cannot be what it was dragged to; empty: it is
  std::string drag(LessonSession& session, const std::vector<Inset>& insets, const Vec2& at, double dx,
                   double dy, bool scales = false);
  void let_go() { held_ = On::nothing; }
  /// The same; where an arrow has been pulled out of its picture, that is fitted to what is shown now.
  void let_go(LessonSession& session, const std::vector<Inset>& insets);
  /// Whether the tip stays well behind the pointer that holds it: no ω of its energy ends nearer to it.
  bool is_short() const { return held_ == On::omega && is_short_; }

 private:
  On held_ = On::nothing;
  std::size_t inset_ = 0, pane_ = 0;  ///< where it was taken
  Vec2 off_{0, 0};                    ///< px from the pointer to the tip that it holds
  bool has_scaled_ = false;           ///< since then the pointer is elsewhere
  bool is_short_ = false;
};

}  // namespace polhode
