// SPDX-License-Identifier: MIT
// A counterexample as the scene of a session: its body takes the place of the lesson's, until it is left.
#include "app/session/lesson_session.h"
#include "render/figure/omega_tip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode {
namespace {

Vec3 vector(const std::array<double, 3>& x) { return {x[0], x[1], x[2]}; }

/// "…, N = (0, 1, 0)", or "N = 0" where the question is about a free body.
bool says_torque(const Counterexample& counter) { return counter.state.find("N = ") != std::string::npos; }

Torque torque_of(const CounterBody& body) {
  const Vec3 N_B = vector(body.N);
  return N_B.isZero(0) ? Torque{} : Torque{BodyTorque{N_B}};
}

/// So that what is said of the body is seen, whatever the lesson's figure shows of its own: how it lies, its
/// axes, ω, and the torque. A vector that an arrow of the lesson's draws has no second one on it.
void show_what_is_said(SceneEdits& edits, const Scene& lesson_scene) {
  const bool has_surface =
      lesson_scene.show.contains(Overlay::energy_ellipsoid) && !edits.off.contains(Overlay::energy_ellipsoid);
  for (const Overlay overlay :
       {Overlay::shape, Overlay::omega, Overlay::N, Overlay::axes_body, Overlay::labels})
    if ((overlay != Overlay::shape || !has_surface) && !has_arrow_along(lesson_scene, overlay))
      set_shown(edits, lesson_scene, overlay, true);
}

}  // namespace

bool LessonSession::can_show(const Counterexample& counter) const {
  return has_scene() && counter.body && !counter.body->has_more;
}

/// The numbers stay as they are, so that what is said of them is true of the figure; what is small or slow is
/// shown by a clock of its own. What is not said stays as in the lesson's scene: the torque, with its arrow,
/// and that L points up or down.
Status LessonSession::show_counterexample(const Counterexample& counter) {
  if (!can_show(counter)) return failure("no figure can show this counterexample");
  const CounterBody& shown = *counter.body;
  const auto body = body_with_moments(vector(shown.I));
  if (!body) return failure(body.error());
  const SceneEdits before = aside_ ? aside_->before : edits_;
  const double t_s = aside_ ? aside_->t_s : t_s_;
  const std::size_t changes = aside_ ? aside_->changes : undo_.size();
  SceneEdits edits = before;
  edits.numbers.clear();
  edits.body = *body;
  edits.w0_B = vector(shown.w);
  edits.motion = MotionSpec{};
  edits.torque.reset();
  if (says_torque(counter)) edits.torque = torque_of(shown);
  const auto& [w, x, y, z] = shown.q;
  const bool is_turned = x != 0 || y != 0 || z != 0;
  edits.attitude.reset();
  if (is_turned) edits.attitude = Quat(w, x, y, z).normalized();
  show_what_is_said(edits, lesson_scene());
  edits.is_counterexample = true;
  begin_change();
  if (const Status made = set_edits(edits); !made) return made;
  begin_change();
  aside_ = Aside{counter, before, t_s, std::min(changes, undo_.size() - 1)};
  return success();
}

/// Another answer may be right, or fail for another body. What was changed by hand meanwhile stays, as one
/// change.
void LessonSession::leave_answered() {
  if (counterexample() != nullptr) leave_counterexample();
  forget_counterexamples();
  if (!aside_) return;
  undo_.resize(aside_->changes);
  undo_.push_back({aside_->before, aside_->t_s, edits_.camera, {}});
  begin_change();
}

/// What is said of one is said of the last answer: it is not made again after another.
void LessonSession::forget_counterexamples() {
  const bool has_any = std::any_of(redo_.begin(), redo_.end(),
                                   [](const Change& change) { return change.before.is_counterexample; });
  if (has_any) redo_.clear();
}

void LessonSession::leave_counterexample() {
  if (!aside_) return;
  const Aside aside = *std::exchange(aside_, std::nullopt);
  SceneEdits edits = aside.before;
  edits.camera = edits_.camera;
  if (!set_edits(edits)) reset_edits();
  undo_.resize(std::min(aside.changes, undo_.size()));
  redo_.clear();
  begin_change();
  scrub_to(aside.t_s);
}

}  // namespace polhode
