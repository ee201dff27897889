// SPDX-License-Identifier: MIT
// The mouse on the figure: it turns and moves the camera, or takes ω by its tip.
#pragma once

#include "app/session/figure_hand.h"

#include <string>
#include <vector>

namespace polhode {

class FigureDrag {
 public:
  bool is_held() const { return hand_.held() != FigureHand::On::nothing; }
  bool holds_omega() const { return hand_.held() == FigureHand::On::omega; }
  bool is_near_omega() const { return is_near_; }  ///< a press would take it by its tip
  bool scales_omega() const { return holds_omega() && scales_; }

  /// What ImGui's io has of the mouse in this frame, done to the session.
  /// @param insets of the page that is shown
  /// @param on_page the pointer is on the page, and nothing lies over it there
  /// @param reach how near the pointer has to be to take the tip of ω, px
  /// @returns why ω cannot be what it was dragged to; empty: it is
  std::string use_mouse(LessonSession& session, const std::vector<Inset>& insets, bool on_page, double reach);

 private:
  FigureHand hand_;
  bool is_near_ = false, scales_ = false;
};

}  // namespace polhode
