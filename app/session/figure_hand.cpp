// SPDX-License-Identifier: MIT
#include "app/session/figure_hand.h"

#include "app/session/camera_moves.h"
#include "app/session/omega_drag.h"
#include "lessons/reader/questions/state_task.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace polhode {

namespace {

bool holds(const PixelRect& rect, const Vec2& at) {
  return at.x() >= rect.x && at.y() >= rect.y && at.x() < rect.x + rect.width &&
         at.y() < rect.y + rect.height;
}

std::optional<std::size_t> inset_at(const std::vector<Inset>& insets, const Vec2& at) {
  const auto found =
      std::find_if(insets.begin(), insets.end(), [&](const Inset& i) { return holds(i.place, at); });
  if (found == insets.end()) return std::nullopt;
  return static_cast<std::size_t>(found - insets.begin());
}

std::optional<TipOnScreen> tip_near(const LessonSession& session, const std::vector<Inset>& insets,
                                    const Vec2& at, double reach) {
  std::optional<TipOnScreen> near;
  for (const TipOnScreen& tip : omega_tips(*session.model(), session.t_s(), insets))
    if (std::hypot(tip.x - at.x(), tip.y - at.y()) < reach) near = tip;
  return near;
}

/// Whether a question of the step lets ω be changed and the attitude not.
bool asks_for_omega_alone(const LessonSession& session) {
  const std::vector<const Ask*> asks = session.questions();
  return std::any_of(asks.begin(), asks.end(), [](const Ask* ask) {
    return ask->task && ask->task->change.contains(Steered::omega) &&
           !ask->task->change.contains(Steered::attitude);
  });
}

}  // namespace

FigureHand::On FigureHand::under(const LessonSession& session, const std::vector<Inset>& insets,
                                 const Vec2& at, double reach) {
  if (session.model() == nullptr || !inset_at(insets, at)) return On::nothing;
  return tip_near(session, insets, at, reach) ? On::omega : On::figure;
}

FigureHand::On FigureHand::take(LessonSession& session, const std::vector<Inset>& insets, const Vec2& at,
                                double reach) {
  held_ = On::nothing;
  if (session.model() == nullptr) return held_;
  const auto inset = inset_at(insets, at);
  if (!inset) return held_;
  inset_ = *inset;
  held_ = On::figure;
  if (const auto tip = tip_near(session, insets, at, reach)) {
    held_ = On::omega;
    inset_ = tip->inset;
    pane_ = tip->pane;
    off_ = Vec2(tip->x, tip->y) - at;
    session.set_playing(false);
  }
  return held_;
}

std::string FigureHand::drag(LessonSession& session, const std::vector<Inset>& insets, const Vec2& at,
                             double dx, double dy) {
  if (session.model() == nullptr) held_ = On::nothing;
  if (held_ == On::nothing || inset_ >= insets.size() || (dx == 0 && dy == 0)) return {};
  const Inset& inset = insets[inset_];
  if (held_ == On::figure) {
    session.set_camera(orbited(session.model()->scene.camera, dx, dy, inset.place.height));
    return {};
  }
  const Vec2 to = at + off_;
  const auto grabbed =
      omega_at(*session.model(), session.t_s(), inset, pane_, to.x(), to.y(), asks_for_omega_alone(session));
  if (!grabbed) return {};
  off_ += grabbed->offset;
  SceneEdits edits = session.edits();
  edits.w0_B = grabbed->w0_B;
  // A method that knows steady rotations alone gives way to the one that serves any.
  if (session.model()->scene.motion.method == Method::uniform) edits.motion = MotionSpec{};
  if (grabbed->attitude) edits.attitude = grabbed->attitude;
  edits.camera = grabbed->camera;
  const Status made = session.set_edits(edits);
  return made ? "" : made.error();
}

}  // namespace polhode
