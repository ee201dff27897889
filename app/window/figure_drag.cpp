// SPDX-License-Identifier: MIT
#include "app/window/figure_drag.h"

#include "app/session/figure_interaction.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace polhode {

namespace {

Vec2 mouse() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

bool has_moved() { return ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0; }

bool holds(const PixelRect& rect, const Vec2& at) {
  return at.x() >= rect.x && at.y() >= rect.y && at.x() < rect.x + rect.width &&
         at.y() < rect.y + rect.height;
}

}  // namespace

std::string FigureDrag::use_mouse(LessonSession& session, const std::vector<Inset>& insets, bool on_page,
                                  double reach) {
  const ImGuiIO& io = ImGui::GetIO();
  const SceneModel* model = session.model();
  if (!io.MouseDown[0] || !model) held_ = Held::nothing;
  if (!model) return {};
  const Vec2 at = mouse();
  const auto inset =
      std::find_if(insets.begin(), insets.end(), [&](const Inset& i) { return holds(i.place, at); });
  const bool over = on_page && inset != insets.end();
  std::optional<TipOnScreen> near;
  if (over || holds_omega())
    for (const TipOnScreen& tip : omega_tips(*model, session.t_s(), insets))
      if (std::hypot(tip.x - at.x(), tip.y - at.y()) < reach) near = tip;
  if (over && io.MouseClicked[0]) {
    inset_ = static_cast<std::size_t>(inset - insets.begin());
    held_ = near ? Held::omega : Held::camera;
    if (near) {
      inset_ = near->inset;
      pane_ = near->pane;
      session.set_playing(false);
    }
  }
  if (near || holds_omega()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (over && io.MouseDoubleClicked[0]) session.set_camera(session.lesson_scene().camera);
  if (over && io.MouseWheel != 0) session.set_camera(zoomed(session.model()->scene.camera, io.MouseWheel));
  if (!is_held() || inset_ >= insets.size() || !has_moved()) return {};
  return move(session, insets[inset_]);
}

std::string FigureDrag::move(LessonSession& session, const Inset& inset) const {
  if (held_ == Held::camera) {
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    session.set_camera(orbited(session.model()->scene.camera, by.x, by.y, inset.place.height));
    return {};
  }
  const Vec2 at = mouse();
  const auto grabbed = omega_at(*session.model(), session.t_s(), inset, pane_, at.x(), at.y());
  if (!grabbed) return {};
  SceneEdits edits = session.edits();
  edits.w0_B = grabbed->w0_B;
  if (grabbed->attitude) edits.attitude = grabbed->attitude;
  edits.camera = grabbed->camera;
  const Status made = session.set_edits(edits);
  return made ? "" : made.error();
}

}  // namespace polhode
