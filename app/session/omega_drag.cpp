// SPDX-License-Identifier: MIT
#include "app/session/omega_drag.h"

#include "physics/body/euler.h"
#include "physics/geometry/poinsot.h"
#include "physics/method.h"
#include "render/figure/omega_tip.h"
#include "render/scene/model/scene_needs.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace polhode {

namespace {

/// Of a pane, px of the page; as the renderer divides an inset.
PixelRect rect_of(const Pane& pane, const PixelRect& inset) {
  const auto px = [](double part, int whole) { return static_cast<int>(std::lround(part * whole)); };
  const int x0 = px(pane.x, inset.width), x1 = px(pane.x + pane.width, inset.width);
  const int y0 = px(pane.y, inset.height), y1 = px(pane.y + pane.height, inset.height);
  return {inset.x + x0, inset.y + y0, std::max(1, x1 - x0), std::max(1, y1 - y0)};
}

double aspect_of(const PixelRect& inset) {
  return static_cast<double>(inset.width) / std::max(1, inset.height);
}

std::optional<Vec2> on_page(const DrawnOmega& omega, const PixelRect& pane) {
  const auto at = project(omega.camera, omega.tip_V, pane.width, pane.height);
  if (!at || !at->allFinite()) return std::nullopt;
  return Vec2(pane.x + at->x(), pane.y + at->y());
}

/// Looks for the ω of an energy whose tip is drawn at a place: ω = (a₁n₁, a₂n₂, a₃n₃) with the semi-axes a of
/// the energy ellipsoid and a unit vector n.
class OmegaSearch {
 public:
  OmegaSearch(const SceneModel& model, const Inset& inset, std::size_t pane, const Vec2& wanted,
              const Vec3& semi_axes, const std::optional<AttitudeSpec>& attitude, const CameraSpec& camera)
      : trial_(model, pane, aspect_of(inset.place), attitude, camera),
        rect_(rect_of(inset.figure.panes[pane], inset.place)),
        wanted_(wanted),
        semi_axes_(semi_axes) {}

  /// The nearest there is: from `start` on if that leads to the place, else from wherever it is best to
  /// begin.
  std::optional<Vec3> from(const Vec3& start) {
    Found near = descended(start);
    if (near.off_px > kThere) near = better(near, start);
    if (!std::isfinite(near.off_px)) return std::nullopt;
    off_px_ = near.off_px;
    return omega(near.n);
  }
  /// Of the tip of what was found from the place.
  double off_px() const { return off_px_; }

 private:
  static constexpr double kThere = 0.2;  // px: nobody sees less
  struct Found {
    Vec3 n{0, 0, 1};
    double off_px = kNowhere;
  };
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();

  Vec3 omega(const Vec3& n) const { return semi_axes_.cwiseProduct(n); }

  std::optional<Vec2> off(const Vec3& n) {
    const auto drawn = trial_.at(omega(n));
    const auto at = drawn ? on_page(*drawn, rect_) : std::nullopt;
    if (!at) return std::nullopt;
    return Vec2(*at - wanted_);
  }

  double distance(const Vec3& n) {
    const auto r = off(n);
    return r ? r->norm() : kNowhere;
  }

  /// Levenberg and Marquardt's method in the tangent plane of the sphere of n.
  Found descended(const Vec3& start) {
    constexpr int kMostSteps = 40;
    constexpr double kDifference = 1e-6;
    constexpr double kEnough = 0.01, kStands = 0.005;  // px
    Found best{start, distance(start)};
    double damping = 1e-3;
    for (int i = 0; i < kMostSteps && best.off_px > kEnough && damping < 1e9; ++i) {
      const Vec3 u = best.n.unitOrthogonal(), v = best.n.cross(u);
      const auto r = off(best.n), ru = off((best.n + kDifference * u).normalized()),
                 rv = off((best.n + kDifference * v).normalized());
      if (!r || !ru || !rv) break;
      Eigen::Matrix2d J;
      J << (*ru - *r) / kDifference, (*rv - *r) / kDifference;
      const Eigen::Matrix2d JtJ = J.transpose() * J;
      const double scale = JtJ.trace();
      if (!(scale > 0.0) || !std::isfinite(scale)) break;
      bool is_nearer = false;
      while (!is_nearer && damping < 1e9) {
        const Vec2 step =
            -(JtJ + damping * scale * Eigen::Matrix2d::Identity()).ldlt().solve(J.transpose() * *r);
        const double length = step.norm();
        const Vec2 held = length > kLongestStep ? Vec2(step * (kLongestStep / length)) : step;
        const Vec3 n = (best.n + held.x() * u + held.y() * v).normalized();
        const double off_px = n.allFinite() ? distance(n) : kNowhere;
        is_nearer = off_px < best.off_px;
        if (is_nearer) {
          const bool stands = best.off_px - off_px < kStands;
          best = {n, off_px};
          damping = std::max(1e-12, 0.1 * damping);
          if (stands) return best;
        } else {
          damping *= 10.0;
        }
      }
    }
    return best;
  }

  /// Of descents from the best of some directions all over the sphere; of those that come equally near, the
  /// one that is nearest to where the hand has been.
  Found better(Found best, const Vec3& start) {
    constexpr int kDirections = 600;
    constexpr std::size_t kStarts = 16;
    std::array<Found, kStarts> starts;
    for (int i = 0; i < kDirections; ++i) {  // Fibonacci's sphere
      const double z = 1.0 - (2.0 * i + 1.0) / kDirections,
                   around = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
      const double r = std::sqrt(1.0 - z * z);
      const Vec3 n(r * std::cos(around), r * std::sin(around), z);
      const Found found{n, distance(n)};
      const auto is_near = [&](const Found& other) {
        return std::isfinite(other.off_px) && other.n.dot(n) > kSameValley;
      };
      auto place = std::find_if(starts.begin(), starts.end(), is_near);
      if (place == starts.end()) place = starts.end() - 1;
      if (found.off_px < place->off_px) *place = found;
      std::sort(starts.begin(), starts.end(),
                [](const Found& a, const Found& b) { return a.off_px < b.off_px; });
    }
    for (const Found& found : starts) {
      if (!std::isfinite(found.off_px)) continue;
      const Found end = descended(found.n);
      const bool equal = std::abs(end.off_px - best.off_px) < kThere;
      if (equal ? end.n.dot(start) > best.n.dot(start) : end.off_px < best.off_px) best = end;
    }
    return best;
  }

  static constexpr double kLongestStep = 0.3;  // rad
  static constexpr double kSameValley = 0.97;  // cosine of 14°

  TrialOmega trial_;
  PixelRect rect_;
  Vec2 wanted_;
  Vec3 semi_axes_;
  double off_px_ = 0;
};

/// By how much a body that begins with this ω is turned about the vertical, on which the scene holds L,
/// beside the attitude of the moment.
double turned_at_start(Scene scene, const RigidBodyState& now) {
  scene.w0_B = now.w_B;
  const Quat turn = problem_of(scene).start.q_SB * now.q_SB.inverse();
  return 2.0 * std::atan2(turn.z(), turn.w());
}

/// The camera goes round the vertical with all that is seen. So does the frame that it keeps, whose middle is
/// beside the vertical; where the motion decides on it, it is that of the same motion, turned.
void turn_about_vertical(CameraSpec& camera, const Scene& scene, double by_rad) {
  const auto turn = [&](double& azimuth_rad) {
    azimuth_rad = std::remainder(azimuth_rad + by_rad, 2.0 * std::numbers::pi);
  };
  CameraFit& fitted = *camera.fitted;  // that of held_by_hand
  turn(camera.azimuth_rad);
  turn(fitted.azimuth_rad);
  if (!frame_needs_motion(scene)) return;
  Scene begun = scene;
  begun.w0_B = *fitted.w0_B;
  begun.attitude = fitted.attitude;
  fitted.attitude = Quat(Eigen::AngleAxisd(by_rad, Vec3::UnitZ())) * problem_of(begun).start.q_SB;
}

double distance_of(const Camera& camera) { return (camera.eye - camera.target).norm(); }

/// A motion that begins in the present state has another frame than the one that led to it. It is seen from
/// as far and as large as that.
void keep_frame(CameraSpec& camera, const SceneModel& model, const Inset& inset, std::size_t pane,
                const std::optional<AttitudeSpec>& attitude, const Vec3& w_B) {
  constexpr double kSame = 1e-9;
  const Camera& shown = inset.figure.panes[pane].camera;
  const auto begun = [&] {
    return TrialOmega(model, pane, aspect_of(inset.place), attitude, camera).at(w_B);
  };
  const auto change = [](double& value, double ratio) {
    if (std::isfinite(ratio) && std::abs(ratio - 1.0) > kSame) value *= ratio;
  };
  if (const auto near = begun()) change(camera.distance, distance_of(shown) / distance_of(near->camera));
  // A scene that is zoomed otherwise than those beside it no longer has their scale: the second time allows
  // for that.
  for (int i = 0; i < 2; ++i)
    if (const auto seen = begun())
      change(camera.zoom, std::tan(0.5 * seen->camera.fov_y_rad) / std::tan(0.5 * shown.fov_y_rad));
}

/// From where the tip is shown to where it is drawn as the present motion begins anew.
Vec2 offset_of(const SceneModel& model, double t_s, const Inset& inset, std::size_t pane,
               const std::optional<AttitudeSpec>& attitude, const CameraSpec& camera, const Vec3& w_B) {
  const double aspect = aspect_of(inset.place);
  const PixelRect rect = rect_of(inset.figure.panes[pane], inset.place);
  const auto shown = drawn_omega(model, t_s, pane, aspect);
  const auto begun = TrialOmega(model, pane, aspect, attitude, camera).at(w_B);
  const auto from = shown ? on_page(*shown, rect) : std::nullopt,
             to = begun ? on_page(*begun, rect) : std::nullopt;
  return from && to ? Vec2(*to - *from) : Vec2(0, 0);
}

/// What of the motion a hand keeps that takes it now, in the present ω.
std::optional<GrabbedOmega> held_now(const SceneModel& model, double t_s, const RigidBodyState& now,
                                     const Inset& inset, std::size_t pane, bool keeps_L) {
  const bool is_pane =
      pane < inset.figure.panes.size() && inset.figure.panes.size() == model.scene.views.size();
  if (!is_pane || !now.w_B.allFinite() || !now.q_SB.coeffs().allFinite()) return std::nullopt;
  const bool holds_L = !model.scene.attitude || std::holds_alternative<LPoints>(*model.scene.attitude);
  const std::vector<const SceneModel*> shown = shown_models(model);  // they go along with it
  const bool has_plane = std::any_of(
      shown.begin(), shown.end(), [](const SceneModel* one) { return one->drawn.contains(Overlay::plane); });
  const bool has_to =
      keeps_L || has_plane ||
      std::find(model.scene.views.begin(), model.scene.views.end(), View::space) == model.scene.views.end();
  const std::optional<AttitudeSpec> attitude =
      holds_L && has_to ? std::nullopt : std::optional<AttitudeSpec>(now.q_SB);
  CameraSpec camera = held_by_hand(model.scene);
  if (!attitude && model.scene.views == std::vector{View::space})
    turn_about_vertical(camera, model.scene, turned_at_start(model.scene, now));
  keep_frame(camera, model, inset, pane, attitude, now.w_B);
  const Vec2 offset = offset_of(model, t_s, inset, pane, attitude, camera, now.w_B);
  return GrabbedOmega{now.w_B, attitude, camera, offset};
}

}  // namespace

std::vector<TipOnScreen> omega_tips(const SceneModel& model, double t_s, const std::vector<Inset>& insets) {
  std::vector<TipOnScreen> tips;
  if (insets.empty() || !shows_space(model.drawn, model.needs.marks)) return tips;
  const PixelRect& place = insets.front().place;
  const std::vector<Pane>& panes = insets.front().figure.panes;
  if (panes.size() != model.scene.views.size()) return tips;
  for (std::size_t k = 0; k < panes.size(); ++k) {
    const auto drawn = drawn_omega(model, t_s, k, aspect_of(place));
    const auto at = drawn ? on_page(*drawn, rect_of(panes[k], place)) : std::nullopt;
    if (!at) continue;
    const auto from = on_page({Vec3::Zero(), drawn->camera}, rect_of(panes[k], place));
    const Vec2 tail = from ? *from : *at;
    tips.push_back({0, k, model.scene.views[k], at->x(), at->y(), tail.x(), tail.y()});
  }
  return tips;
}

std::vector<TipOnScreen> untaken_tips(const SceneModel& model, double t_s, const std::vector<Inset>& insets) {
  std::vector<TipOnScreen> tips;
  if (insets.empty() || !shows_space(model.drawn, model.needs.marks)) return tips;
  const PixelRect& place = insets.front().place;
  const std::vector<Pane>& panes = insets.front().figure.panes;
  if (panes.size() != model.scene.views.size()) return tips;
  for (std::size_t k = 0; k < panes.size(); ++k)
    for (const DrawnOmega& drawn : drawn_otherwise(model, t_s, k, aspect_of(place)))
      if (const auto at = on_page(drawn, rect_of(panes[k], place)))
        tips.push_back({0, k, model.scene.views[k], at->x(), at->y(), at->x(), at->y()});
  return tips;
}

std::vector<ArrowOnScreen> arrows_on_page(const Inset& inset) {
  std::vector<ArrowOnScreen> arrows;
  for (const Pane& pane : inset.figure.panes) {
    const PixelRect rect = rect_of(pane, inset.place);
    for (const Arrow& arrow : pane.list.arrows) {
      const auto tail = on_page({arrow.tail, pane.camera}, rect),
                 tip = on_page({arrow.tip, pane.camera}, rect);
      if (tail && tip) arrows.push_back({*tail, *tip});
    }
  }
  return arrows;
}

namespace {

/// About points of a figure; a point of its own that is not seen has no part in it.
class BoxOfPoints {
 public:
  BoxOfPoints(const Camera& camera, const PixelRect& rect) : camera_(camera), rect_(rect) {}

  void add(const Vec3& point) {
    const auto at = on_page({point, camera_}, rect_);
    if (!at) return;
    box_ = is_empty_ ? PixelBox{at->x(), at->y(), at->x(), at->y()}
                     : PixelBox{std::min(box_.x0, at->x()), std::min(box_.y0, at->y()),
                                std::max(box_.x1, at->x()), std::max(box_.y1, at->y())};
    is_empty_ = false;
  }
  void append_to(std::vector<PixelBox>& boxes, double grown = 0) const {
    if (!is_empty_) boxes.push_back(box_.grown(grown));
  }

 private:
  const Camera& camera_;
  const PixelRect& rect_;
  PixelBox box_;
  bool is_empty_ = true;
};

}  // namespace

std::vector<PixelBox> bodies_on_page(const Inset& inset, double size) {
  constexpr std::size_t kMostOfMesh = 400, kMostOfTube = 60;
  std::vector<PixelBox> boxes;
  for (const Pane& pane : inset.figure.panes) {
    const PixelRect rect = rect_of(pane, inset.place);
    for (const GlassEllipsoid& one : pane.list.ellipsoids) {
      BoxOfPoints box(pane.camera, rect);
      for (int i = 0; i < 27; ++i) {
        const Vec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (i != 13) box.add(one.center + one.rotation * Vec3(one.semi_axes.cwiseProduct(way.normalized())));
      }
      box.append_to(boxes);
    }
    for (const Mesh& one : pane.list.meshes) {
      BoxOfPoints box(pane.camera, rect);
      const std::size_t by = 1 + one.positions.size() / kMostOfMesh;
      for (std::size_t i = 0; i < one.positions.size(); i += by) box.add(one.positions[i]);
      box.append_to(boxes);
    }
    for (const Tube& one : pane.list.tubes) {
      const std::size_t by = 1 + one.points.size() / kMostOfTube;
      for (std::size_t i = 0; i < one.points.size(); i += by) {
        BoxOfPoints box(pane.camera, rect);
        box.add(one.points[i]);
        box.append_to(boxes, 0.5 * size);
      }
    }
  }
  return boxes;
}

std::optional<GrabbedOmega> omega_at(const SceneModel& model, double t_s, const Inset& inset,
                                     std::size_t pane, double x, double y, bool keeps_L) {
  if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  const RigidBodyState now = model.motion->at(t_s);
  auto held = held_now(model, t_s, now, inset, pane, keeps_L);
  if (!held) return std::nullopt;
  const PrincipalMoments& I = model.scene.body.moments;
  // Free motion keeps the energy of its start, also where a method does not.
  const double two_T = 2.0 * kinetic_energy(I, model.scene.torque.empty() ? model.scene.w0_B : now.w_B);
  if (!(two_T > 0.0) || !std::isfinite(two_T)) return std::nullopt;
  const Vec3 semi_axes = energy_ellipsoid_semi_axes(I, two_T);
  const Vec3 start = now.w_B.cwiseQuotient(semi_axes).normalized();
  if (!start.allFinite()) return std::nullopt;
  OmegaSearch search(model, inset, pane, Vec2(x, y) + held->offset, semi_axes, held->attitude, held->camera);
  const auto w0_B = search.from(start);
  if (!w0_B) return std::nullopt;
  held->w0_B = *w0_B;
  held->off_px = search.off_px();
  return held;
}

std::optional<GrabbedOmega> scaled_omega(const SceneModel& model, double t_s, const Inset& inset,
                                         std::size_t pane, double factor, bool keeps_L) {
  const RigidBodyState now = model.motion->at(t_s);
  auto held = held_now(model, t_s, now, inset, pane, keeps_L);
  if (!held || !std::isfinite(factor) || !(factor > 0) || now.w_B.isZero(0)) return std::nullopt;
  held->w0_B = factor * now.w_B;
  return held;
}

bool begin_before(const SceneModel& model, double t_s, const Inset& inset, std::size_t pane,
                  GrabbedOmega& grabbed) {
  constexpr double kUnseen = 1e-6;  // of a radian, and of ω
  const std::vector<View>& views = model.scene.views;
  const bool is_alone = model.beside.empty();  // others would begin elsewhere too
  if (!is_alone || (!grabbed.attitude && views.size() != 1)) return false;
  Scene scene = model.scene;
  scene.w0_B = grabbed.w0_B;
  if (grabbed.attitude) scene.attitude = grabbed.attitude;
  Problem problem = problem_of(scene);
  const RigidBodyState then = problem.start;
  const auto closed = closed_form(problem);
  const auto& named = model.scene.motion.method;
  if (!closed || (named && *named != *closed && *named != Method::uniform)) return false;
  const MethodChoice choice{.method = *closed};
  RigidBodyState start, reached;
  try {
    start = make_motion(problem, choice)->at(-t_s);
    if (!start.w_B.allFinite() || !start.q_SB.coeffs().allFinite()) return false;
    problem.start = start;
    if (!grabbed.attitude) {  // L is where the scene holds it, and the body is turned about it
      scene.w0_B = start.w_B;
      problem = problem_of(scene);
    }
    reached = make_motion(problem, choice)->at(t_s);
  } catch (const std::domain_error&) {
    return false;
  }
  if (!reached.w_B.allFinite() || !((reached.w_B - then.w_B).norm() < kUnseen * then.w_B.norm()))
    return false;
  if (grabbed.attitude && !(reached.q_SB.angularDistance(then.q_SB) < kUnseen)) return false;
  grabbed.w0_B = start.w_B;
  if (grabbed.attitude) grabbed.attitude = start.q_SB;
  // The frame is that of this beginning, not of one at the moment.
  CameraSpec camera = held_by_hand(model.scene);
  double by_rad = grabbed.camera.azimuth_rad - camera.azimuth_rad;
  if (!grabbed.attitude && views.front() == View::space) {
    const Quat turn = reached.q_SB * then.q_SB.inverse();
    by_rad += 2.0 * std::atan2(turn.z(), turn.w());
  }
  if (by_rad != 0) turn_about_vertical(camera, model.scene, by_rad);
  keep_frame(camera, model, inset, pane, grabbed.attitude, start.w_B);
  grabbed.camera = camera;
  grabbed.offset = Vec2(0, 0);
  return true;
}

}  // namespace polhode
