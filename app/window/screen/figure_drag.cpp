// SPDX-License-Identifier: MIT
#include "app/window/screen/figure_drag.h"

#include "app/session/camera_moves.h"
#include "app/session/omega_drag.h"

#include <imgui.h>

#include <cmath>

namespace polhode {

std::string FigureDrag::use_mouse(LessonSession& session, const std::vector<Inset>& insets, bool on_page,
                                  double reach) {
  using On = FigureHand::On;
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.MouseDown[0] || session.model() == nullptr) hand_.let_go(session, insets);
  const bool was_near_untaken = is_near_untaken_;
  is_near_ = is_near_untaken_ = false;
  if (session.model() == nullptr) return {};
  const Vec2 at(io.MousePos.x, io.MousePos.y);
  const On under = on_page ? FigureHand::under(session, insets, at, reach) : On::nothing;
  is_near_ = under == On::omega && !io.MouseDown[0];
  // Who presses it has not read why yet.
  if (under == On::figure && (!io.MouseDown[0] || io.MouseClicked[0] || was_near_untaken))
    for (const TipOnScreen& tip : untaken_tips(*session.model(), session.t_s(), insets))
      is_near_untaken_ = is_near_untaken_ || std::hypot(tip.x - at.x(), tip.y - at.y()) < reach;
  if (is_near_untaken_) ImGui::SetMouseCursor(ImGuiMouseCursor_NotAllowed);
  scales_ = io.KeyShift;
  const bool over = under != On::nothing;
  if (over && io.MouseClicked[0]) hand_.take(session, insets, at, reach);
  if (under == On::omega || holds_omega()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (over && io.MouseDoubleClicked[0]) session.set_camera(session.lesson_scene().camera);
  if (over && io.MouseWheel != 0) session.set_camera(zoomed(session.model()->scene.camera, io.MouseWheel));
  return hand_.drag(session, insets, at, io.MouseDelta.x, io.MouseDelta.y, scales_);
}

}  // namespace polhode
