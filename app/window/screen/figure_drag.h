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
  /// The pointer is at the tip of an arrow of the lesson's that is ω, and by which no hand takes it.
  bool is_near_untaken() const { return is_near_untaken_; }
  bool scales_omega() const { return holds_omega() && scales_; }
  bool is_short() const { return hand_.is_short(); }  ///< the tip that it holds comes no nearer

  /// What ImGui's io has of the mouse in this frame, done to the session.
  /// @param insets of the page that is shown
  /// @param on_page the pointer is on the page, and nothing lies over it there
  /// @param reach how near the pointer has to be to take the tip of ω, px
  /// @returns why ω cannot be what it was dragged to; empty: it is
  std::string use_mouse(LessonSession& session, const std::vector<Inset>& insets, bool on_page, double reach);

 private:
  FigureHand hand_;
  bool is_near_ = false, is_near_untaken_ = false, scales_ = false;
};

}  // namespace polhode
