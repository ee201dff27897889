// SPDX-License-Identifier: MIT
#include "app/session/figure_hand.h"

#include "app/session/camera_moves.h"
#include "app/session/omega_drag.h"
#include "lessons/reader/questions/state_task.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

std::optional<TipOnScreen> tip_in(const LessonSession& session, const std::vector<Inset>& insets,
                                  std::size_t inset, std::size_t pane) {
  for (const TipOnScreen& tip : omega_tips(*session.model(), session.t_s(), insets))
    if (tip.inset == inset && tip.pane == pane) return tip;
  return std::nullopt;
}

/// By which factor an arrow gets longer that is pulled by so many px. One that is seen from its end is short,
/// and is not pulled to nothing at once.
double pulled(const TipOnScreen& tip, const Vec2& by) {
  constexpr double kLeastLength = 40, kMost = 1.25;  // px; of one movement
  const Vec2 arrow(tip.x - tip.x0, tip.y - tip.y0);
  const double length = arrow.norm();
  const Vec2 along = length > 1 ? Vec2(arrow / length) : Vec2(0, -1);
  return std::clamp(1 + by.dot(along) / std::max(length, kLeastLength), 1 / kMost, kMost);
}

/// What it judges is the start of the motion.
bool asks_for_state(const LessonSession& session) {
  const std::vector<const Ask*> asks = session.questions();
  return std::any_of(asks.begin(), asks.end(), [](const Ask* ask) { return ask->task != nullptr; });
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
  has_scaled_ = is_short_ = false;
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

void FigureHand::let_go(LessonSession& session, const std::vector<Inset>& insets) {
  if (std::exchange(held_, On::nothing) != On::omega || session.model() == nullptr) return;
  const bool leaves = std::any_of(insets.begin(), insets.end(), [](const Inset& inset) {
    const std::vector<ArrowOnScreen> arrows = arrows_on_page(inset);
    return std::any_of(arrows.begin(), arrows.end(),
                       [&](const ArrowOnScreen& arrow) { return !holds(inset.place, arrow.tip); });
  });
  CameraSpec camera = session.camera();
  if (!leaves || !camera.fitted) return;
  camera.fitted->w0_B.reset();
  camera.fitted->attitude.reset();
  if (*camera.fitted == CameraFit{camera.azimuth_rad, camera.elevation_rad}) camera.fitted.reset();
  session.set_camera(camera);
}

std::string FigureHand::drag(LessonSession& session, const std::vector<Inset>& insets, const Vec2& at,
                             double dx, double dy, bool scales) {
  if (session.model() == nullptr) held_ = On::nothing;
  if (held_ == On::nothing || inset_ >= insets.size() || (dx == 0 && dy == 0)) return {};
  const Inset& inset = insets[inset_];
  if (held_ == On::figure) {
    session.set_camera(orbited(session.model()->scene.camera, dx, dy, inset.place.height));
    return {};
  }
  const double t_s = session.t_s();
  const bool keeps_L = asks_for_omega_alone(session);
  const auto tip = tip_in(session, insets, inset_, pane_);
  if (tip && std::exchange(has_scaled_, scales)) off_ = Vec2(tip->x, tip->y) - at + Vec2(dx, dy);
  const Vec2 to = at + off_;
  auto grabbed = scales && tip
                     ? scaled_omega(*session.model(), t_s, inset, pane_, pulled(*tip, Vec2(dx, dy)), keeps_L)
                     : omega_at(*session.model(), t_s, inset, pane_, to.x(), to.y(), keeps_L);
  constexpr double kShort = 10;  // px: what one sees and does not take for the hand's own
  is_short_ = !scales && (!grabbed || grabbed->off_px > kShort);
  if (!grabbed) return {};
  const bool keeps_t =
      t_s != 0 && !asks_for_state(session) && begin_before(*session.model(), t_s, inset, pane_, *grabbed);
  off_ += grabbed->offset;
  SceneEdits edits = session.edits();
  edits.w0_B = grabbed->w0_B;
  // A method that knows steady rotations alone gives way to the one that serves any.
  if (session.model()->scene.motion.method == Method::uniform) edits.motion = MotionSpec{};
  if (grabbed->attitude) edits.attitude = grabbed->attitude;
  edits.camera = grabbed->camera;
  const Status made = session.set_edits(edits);
  if (made && keeps_t) session.scrub_to(t_s);
  return made ? "" : made.error();
}

}  // namespace polhode
