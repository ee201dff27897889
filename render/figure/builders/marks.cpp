// SPDX-License-Identifier: MIT
// What a lesson draws of vectors of its own: trails, arrows, angles, areas, lines, planes, notes.
#include "physics/body/euler.h"
#include "physics/geometry/curve_sampling.h"
#include "render/figure/builders/builders.h"
#include "render/figure/builders/extents.h"
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace polhode::builders {
namespace {

constexpr double kLabel = 0.1;      // room for a name
constexpr double kBeyond = 0.06;    // of a name behind the tip of its arrow
constexpr double kTooShort = 0.02;  // for an arrow: there is nothing, or noise

bool is_same(const MarkVector& a, const MarkVector& b) {
  return a.quantity.fingerprint == b.quantity.fingerprint;
}

Vec3 scaled(const Vec3& v, double factor) { return std::isfinite(factor) ? Vec3(factor * v) : Vec3::Zero(); }

/// The vectors of a scene's marks as they are drawn, in the axes of the view.
class DrawnVectors {
 public:
  explicit DrawnVectors(const Snapshot& m) : m_(m), arrows_(m.model.scene.marks.arrows) {}

  /// Its value; nothing where it has none.
  std::optional<Vec3> value_V(const MarkVector& vector, double t_s, const RigidBodyState& then) const {
    const auto value_S = vector.quantity.value(m_.model, t_s, then);
    return value_S ? std::optional(to_view(*value_S, then)) : std::nullopt;
  }

  /// From the tail of its arrow to the tip. Of an arrow, or of a vector that only lends its tip or scale.
  std::optional<Vec3> along_V(const MarkVector& vector, const ArrowMark* arrow, double t_s,
                              const RigidBodyState& then) const {
    const auto value = value_V(vector, t_s, then);
    return value ? std::optional(drawn(vector, arrow, *value)) : std::nullopt;
  }

  /// Where the arrow begins; nothing where that has no place.
  std::optional<Vec3> tail_V(std::size_t arrow, double t_s, const RigidBodyState& then) const {
    const auto& at = arrows_[arrow].at;
    return at ? tip_V(*at, t_s, then, arrow) : Vec3(Vec3::Zero());
  }

  /// Where the tip of a vector is: of its arrow, if it is among the first `count`; else of the arrow of the
  /// overlay, or of an arrow from the centre.
  std::optional<Vec3> tip_V(const MarkVector& vector, double t_s, const RigidBodyState& then,
                            std::size_t count) const {
    const std::size_t index = find_arrow(vector, count);
    const ArrowMark* arrow = index < count ? &arrows_[index] : nullptr;
    const auto along = along_V(vector, arrow, t_s, then);
    const auto tail = arrow != nullptr ? tail_V(index, t_s, then) : overlay_tail_V(vector, then);
    return along && tail ? std::optional(Vec3(*tail + *along)) : std::nullopt;
  }
  std::optional<Vec3> tip_V(const MarkVector& vector, double t_s, const RigidBodyState& then) const {
    return tip_V(vector, t_s, then, arrows_.size());
  }
  std::optional<Vec3> tip_V(const MarkVector& vector) const { return tip_V(vector, m_.t_s, m_.state); }

  /// The corners of the parallelogram of two vectors as they are drawn, in order: its tail, the tip of the
  /// first, the far corner, the end of the second. Nothing where they span none.
  std::optional<std::array<Vec3, 4>> corners_V(const AreaMark& area, double t_s,
                                               const RigidBodyState& then) const {
    const auto from = own_along_V(area.from, t_s, then), to = own_along_V(area.to, t_s, then);
    const auto tip = tip_V(area.from, t_s, then);
    if (!from || !to || !tip || !span_area(*from, *to)) return std::nullopt;
    return std::array<Vec3, 4>{*tip - *from, *tip, *tip + *to, *tip - *from + *to};
  }

  /// How far from the centre the tip gets over the span.
  double reach(const MarkVector& vector) const {
    double reach = 0.0;
    for (std::size_t n = 0; n <= kCourseSteps; ++n) {
      const double far = place_S(vector, arrows_.size(), n, RigidBodyState{}).norm();
      if (std::isfinite(far)) reach = std::max(reach, far);
    }
    return reach + (stands_on_L(vector) ? m_.L_length : 0.0);
  }

  /// What one of the arrows joins at a step of the courses.
  std::pair<Vec3, Vec3> ends_V(std::size_t arrow, std::size_t step, const RigidBodyState& then) const {
    const auto& at = arrows_[arrow].at;
    const Vec3 tail_S = at ? place_S(*at, arrow, step, then) : Vec3(Vec3::Zero());
    const Vec3& value_S = course_of(arrows_[arrow].of).values_S[step];
    return {to_view(tail_S, then),
            to_view(tail_S + drawn(arrows_[arrow].of, &arrows_[arrow], value_S), then)};
  }
  /// The tip of a vector at a step of the courses.
  Vec3 place_V(const MarkVector& vector, std::size_t step, const RigidBodyState& then) const {
    return to_view(place_S(vector, arrows_.size(), step, then), then);
  }
  Vec3 direction_V(const MarkVector& vector, std::size_t step, const RigidBodyState& then) const {
    return to_view(course_of(vector).values_S[step].stableNormalized(), then);
  }

  bool has_arrow(const MarkVector& vector) const {
    return find_arrow(vector, arrows_.size()) < arrows_.size() ||
           (vector.overlay && m_.shows(*vector.overlay));
  }

 private:
  Vec3 to_view(const Vec3& v_S, const RigidBodyState& then) const {
    return m_.view == View::space ? v_S : Vec3(then.q_SB.conjugate() * v_S);
  }

  std::optional<Vec3> own_along_V(const MarkVector& vector, double t_s, const RigidBodyState& then) const {
    const std::size_t index = find_arrow(vector, arrows_.size());
    return along_V(vector, index < arrows_.size() ? &arrows_[index] : nullptr, t_s, then);
  }

  std::size_t find_arrow(const MarkVector& vector, std::size_t count) const {
    const auto end = arrows_.begin() + static_cast<std::ptrdiff_t>(count);
    return static_cast<std::size_t>(
        std::find_if(arrows_.begin(), end, [&](const ArrowMark& a) { return is_same(a.of, vector); }) -
        arrows_.begin());
  }

  /// N has one length as an overlay, too: how large it is tells nothing beside L.
  static bool has_torque_length(const MarkVector& vector, const ArrowMark* arrow) {
    return vector.overlay == Overlay::N && (arrow == nullptr || (!arrow->length && !arrow->like));
  }

  /// The tip of a vector at a time of its course.
  Vec3 place_S(const MarkVector& vector, std::size_t count, std::size_t step,
               const RigidBodyState& then) const {
    const std::size_t index = find_arrow(vector, count);
    const ArrowMark* arrow = index < count ? &arrows_[index] : nullptr;
    const Vec3& value_S = course_of(vector).values_S[step];
    Vec3 tail_S = Vec3::Zero();
    if (arrow != nullptr && arrow->at) tail_S = place_S(*arrow->at, index, step, then);
    if (arrow == nullptr && stands_on_L(vector))
      tail_S = then.q_SB * m_.L_drawn_B(angular_momentum_B(m_.I(), then.w_B));
    return tail_S + drawn(vector, arrow, value_S);
  }

  Vec3 drawn(const MarkVector& vector, const ArrowMark* arrow, const Vec3& value) const {
    if (!has_torque_length(vector, arrow)) return scaled(value, scale(vector, arrow));
    return value.isZero(0.0) ? Vec3(Vec3::Zero()) : Vec3(kTorqueLength * value.stableNormalized());
  }

  const VectorCourse& course_of(const MarkVector& vector) const {
    return m_.model.courses.at(vector.quantity.fingerprint);
  }

  /// In a frame that is kept from another ω the scale is kept too, as that of ω and L is: what grows is seen
  /// to.
  double longest_of(const MarkVector& vector) const {
    const double own = course_of(vector).longest;
    if (own == 0.0 || !m_.model.framed) return own;
    const double kept = m_.model.framed->courses.at(vector.quantity.fingerprint).longest;
    return kept > 0.0 ? kept : own;
  }

  /// The arrow of N stands on the tip of L, whose velocity it is.
  bool stands_on_L(const MarkVector& vector) const {
    return vector.overlay == Overlay::N && m_.shows(Overlay::N) && m_.shows(Overlay::L);
  }
  Vec3 overlay_tail_V(const MarkVector& vector, const RigidBodyState& then) const {
    if (!stands_on_L(vector)) return Vec3::Zero();
    return to_view(then.q_SB * m_.L_drawn_B(angular_momentum_B(m_.I(), then.w_B)), then);
  }

  /// Scene units per unit of SI.
  double scale(const MarkVector& vector, const ArrowMark* arrow) const {
    if (arrow != nullptr && arrow->like) {
      const auto own = std::find_if(arrows_.begin(), arrows_.end(), [&](const ArrowMark& a) {
        return is_same(a.of, *arrow->like) && !a.like;
      });
      return scale(*arrow->like, own == arrows_.end() ? nullptr : &*own);
    }
    const double longest = longest_of(vector);
    if (longest == 0.0) return 0.0;
    if (arrow != nullptr && arrow->length) return *arrow->length / longest;
    if (vector.overlay == Overlay::omega) return m_.omega_scale;
    if (vector.overlay == Overlay::L) return m_.L_reference > 0.0 ? m_.L_length / m_.L_reference : 0.0;
    if (vector.overlay == Overlay::N) return kTorqueLength / longest;
    constexpr double kMostAsItIs = 2;
    return vector.is_number && longest <= kMostAsItIs ? 1.0 : kArrowLength / longest;
  }

  const Snapshot& m_;
  const std::vector<ArrowMark>& arrows_;
};

/// How a vector is told from others: by its role, or by its place among those that have none.
struct Look {
  Role role;
  bool is_dashed = false;
};

class Looks {
 public:
  explicit Looks(const Marks& marks) {
    for (const TrailMark& trail : marks.trails) add(trail.of);
    for (const ArrowMark& arrow : marks.arrows) add(arrow.of);
  }

  Look of(const MarkVector& vector) const {
    if (const auto role = role_from(vector.quantity.role)) return {*role};
    const auto found = std::find(own_.begin(), own_.end(), vector.quantity.fingerprint);
    if (found == own_.end()) return {kMarkRoles.front()};
    const auto place = static_cast<std::size_t>(found - own_.begin());
    return {kMarkRoles[place % kMarkRoles.size()], place / kMarkRoles.size() % 2 == 1};
  }

 private:
  void add(const MarkVector& vector) {
    const bool is_there = std::find(own_.begin(), own_.end(), vector.quantity.fingerprint) != own_.end();
    if (!role_from(vector.quantity.role) && !is_there) own_.push_back(vector.quantity.fingerprint);
  }

  std::vector<std::string> own_;
};

Color translucent(const Color& c, float alpha) { return {c.r, c.g, c.b, alpha}; }

/// Triangles from a centre to a rim, seen from both sides.
Mesh fan(const Vec3& center, const std::vector<Vec3>& rim, const Vec3& normal, const Color& color) {
  Mesh mesh;
  mesh.color = color;
  mesh.positions.push_back(center);
  mesh.positions.insert(mesh.positions.end(), rim.begin(), rim.end());
  mesh.normals.assign(mesh.positions.size(), normal);
  for (unsigned k = 1; k + 1 < mesh.positions.size(); ++k)
    for (const unsigned corner : {0U, k, k + 1}) mesh.triangles.push_back(corner);
  return mesh;
}

constexpr float kPlaneAlpha = 0.16F, kSectorAlpha = 0.20F, kAreaAlpha = 0.34F;

constexpr double kOutsideBody = 0.99;

/// Angles about the centre stand each outside the one before, and outside its name where that lies in their
/// sector; outside a body that lies there. `value_V` is a vector at the moment.
template <class Value>
double radius_of_angle(const Snapshot& m, std::size_t index, const Value& value_V) {
  constexpr double kFirst = 0.42, kApart = 0.12, kCloser = 0.07, kName = 0.19, kAtTip = 0.2;
  const std::vector<AngleMark>& angles = m.model.scene.marks.angles;
  const AngleMark& outer = angles[index];
  if (outer.at) return kAtTip;
  const bool is_in_body = m.model.needs.solid && !m.shows(Overlay::pivot);
  double radius = is_in_body ? kOutsideBody : kFirst;
  for (std::size_t i = 0; i < index; ++i) {
    const AngleMark& inner = angles[i];
    const Vec3 leg = value_V(outer.from);
    const bool has_name_inside = !inner.tex.empty() &&
                                 inner.from.quantity.fingerprint == outer.from.quantity.fingerprint &&
                                 leg.cross(value_V(inner.to)).dot(leg.cross(value_V(outer.to))) > 0.0;
    radius += has_name_inside ? kName : is_in_body ? kCloser : kApart;
  }
  return radius;
}

/// The same at all times.
double radius_of_plane(const DrawnVectors& vectors, const PlaneMark& plane) {
  constexpr double kLeast = 1.1;
  return std::max(kLeast, plane.through ? vectors.reach(*plane.through) + kLabel : 0.0);
}

/// Its text is the formula.
void add_label(Label label, DrawList& list) {
  if (label.text.empty()) return;
  label.text = '$' + label.text + '$';
  label.size = kSymbolSize;
  label.leader = false;
  list.labels.push_back(std::move(label));
}

void add_name(const std::string& tex, const Vec3& anchor, const Color& ink, DrawList& list) {
  add_label({.text = tex, .anchor = anchor, .color = ink}, list);
}

class MarkBuilder {
 public:
  MarkBuilder(const Snapshot& m, DrawList& list)
      : m_(m), marks_(m.model.scene.marks), vectors_(m), looks_(marks_), list_(list) {}

  void add_all() {
    if (std::any_of(marks_.trails.begin(), marks_.trails.end(),
                    [](const TrailMark& trail) { return trail.on_sphere; }))
      list_.ellipsoids.push_back({.rotation = m_.q_VS, .tint = kUnitSphereTint});
    for (const PlaneMark& plane : marks_.planes) add(plane);
    for (const AreaMark& area : marks_.areas) add(area);
    for (const LineMark& line : marks_.lines) add(line);
    for (const TrailMark& trail : marks_.trails) add(trail);
    for (std::size_t i = 0; i < marks_.arrows.size(); ++i) add_arrow(i);
    for (std::size_t i = 0; i < marks_.angles.size(); ++i) add_angle(i);
    for (const NoteMark& note : marks_.notes) add(note);
  }

 private:
  void add(const TrailMark& trail) {
    constexpr double kLeastPieces = 64, kMostPieces = 512, kTurn_rad = 0.5;
    constexpr std::size_t kMostPoints = 2048;
    const auto tip_at = [&](double t_s) -> Vec3 {
      const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
      const RigidBodyState then = m_.model.motion->at(t_s);
      if (!trail.on_sphere) return vectors_.tip_V(trail.of, t_s, then).value_or(none);
      const auto value = vectors_.value_V(trail.of, t_s, then);
      return value && !value->isZero(0.0) ? Vec3(value->stableNormalized()) : none;
    };
    const double start_s = trail_start_s(m_);
    const double turns = std::abs(m_.t_s - start_s) * m_.model.scene.w0_B.stableNorm() / kTurn_rad;
    const Look look = looks_.of(trail.of);
    Tube tube{.points = sample_curve(
                  tip_at, start_s, m_.t_s,
                  {.chord_tolerance = kChordTolerance,
                   .first_pieces = static_cast<int>(std::clamp(turns, kLeastPieces, kMostPieces)),
                   .max_points = kMostPoints}),
              .radius = kTrailRadius * m_.thickness,
              .color = look.role.paint,
              .fade_start = kOldestOfTrail,
              .dash = look.is_dashed ? kArrowDash : 0.0};
    if (tube.points.size() < 2) return;
    const Vec3 now = tube.points.back();
    if (vectors_.has_arrow(trail.of))
      end_behind_tip(tube);
    else
      list_.balls.push_back({now, kPoint * tube.radius, tube.color});
    list_.tubes.push_back(std::move(tube));
  }

  void add_arrow(std::size_t index) {
    const ArrowMark& mark = marks_.arrows[index];
    const auto along = vectors_.along_V(mark.of, &mark, m_.t_s, m_.state);
    const auto tail = vectors_.tail_V(index, m_.t_s, m_.state);
    if (!along || !tail || !(along->norm() > kTooShort)) return;
    const Look look = looks_.of(mark.of);
    const bool is_torque = mark.of.overlay == Overlay::N;
    const Vec3 tip = *tail + *along;
    list_.arrows.push_back({.tail = *tail,
                            .tip = tip,
                            .radius = kArrowRadius * m_.thickness,
                            .color = look.role.paint,
                            .dash = is_torque || look.is_dashed ? kArrowDash : 0.0});
    const Vec3 named =
        mark.name_at < 1 ? Vec3(*tail + mark.name_at * *along) : Vec3(tip + kBeyond * along->normalized());
    add_label({.text = mark.tex.value_or(mark.of.quantity.tex),
               .anchor = named,
               .color = look.role.ink,
               .tail = *tail,
               .beside = mark.name_at < 1},
              list_);
  }

  void add_angle(std::size_t index) {
    constexpr int kPoints = 64;
    constexpr double kArcRadius = 0.009, kGuideRadius = 0.006, kGuide = 0.05, kNameBeyond = 0.085;
    const AngleMark& mark = marks_.angles[index];
    const auto from = vectors_.value_V(mark.from, m_.t_s, m_.state),
               to = vectors_.value_V(mark.to, m_.t_s, m_.state);
    const auto angle_rad = from && to ? arc_between(*from, *to) : std::nullopt;
    if (!angle_rad) return;
    const Vec3 u = from->stableNormalized(), v = to->stableNormalized(), axis = u.cross(v).normalized();
    const auto center = mark.at ? vectors_.tip_V(*mark.at) : Vec3(Vec3::Zero());
    if (!center) return;
    const double arc_radius = radius_of_angle(m_, index, [&](const MarkVector& vector) {
      return vectors_.value_V(vector, m_.t_s, m_.state).value_or(Vec3::Zero());
    });
    const bool is_square = is_right(*angle_rad) && arc_radius < kOutsideBody;  // a body would hide it
    const double radius = is_square ? kSquare * arc_radius : arc_radius;
    const auto at = [&](double part) -> Vec3 {
      if (is_square) return std::min(1.0, 2 * (1 - part)) * u + std::min(1.0, 2 * part) * v;
      return Eigen::AngleAxisd(part * *angle_rad, axis) * u;
    };
    Tube arc{.points = {}, .radius = kArcRadius * m_.thickness, .color = kTRole.paint};
    for (int n = 0; n <= kPoints; ++n)
      arc.points.push_back(*center + radius * at(static_cast<double>(n) / kPoints));
    list_.meshes.push_back(fan(*center, arc.points, axis, translucent(kTRole.paint, kSectorAlpha)));
    list_.tubes.push_back(std::move(arc));
    for (const Vec3& leg : {u, v})
      list_.tubes.push_back({.points = {*center, *center + (radius + kGuide) * leg},
                             .radius = kGuideRadius * m_.thickness,
                             .color = kTRole.paint});
    add_label({.text = mark.tex,
               .anchor = *center + (radius + kNameBeyond) * at(0.5),
               .color = kTRole.ink,
               .tail = *center},
              list_);
  }

  /// As vectors that are normal to each other come out, rounded: of rates by differences of the motion, too.
  static bool is_right(double angle_rad) {
    constexpr double kDifferences = 1e-6;
    return std::abs(angle_rad - std::numbers::pi / 2) < kDifferences;
  }

  void add(const AreaMark& area) {
    constexpr double kRimRadius = 0.006;
    const auto corners = vectors_.corners_V(area, m_.t_s, m_.state);
    if (!corners) return;
    const auto& [tail, from, far, to] = *corners;
    const Role role = role_from(area.role).value_or(kAxesRole);
    const Vec3 center = 0.5 * (tail + far), normal = (from - tail).cross(to - tail).stableNormalized();
    list_.meshes.push_back(
        fan(center, {tail, from, far, to, tail}, normal, translucent(role.paint, kAreaAlpha)));
    list_.tubes.push_back(
        {.points = {from, far, to}, .radius = kRimRadius * m_.thickness, .color = role.paint});
    add_name(area.tex, center, role.ink, list_);
  }

  void add(const LineMark& line) {
    constexpr double kLineRadius = 0.006;
    const auto from = vectors_.tip_V(line.from), to = vectors_.tip_V(line.to);
    if (!from || !to || !((*to - *from).norm() > kTooShort)) return;
    list_.tubes.push_back({.points = {*from, *to},
                           .radius = kLineRadius * m_.thickness,
                           .color = kAxesRole.ink,
                           .dash = kArrowDash});
  }

  void add(const PlaneMark& plane) {
    constexpr int kPoints = 96;
    constexpr double kRimRadius = 0.005;
    const auto normal = vectors_.value_V(plane.normal, m_.t_s, m_.state);
    const auto through = plane.through ? vectors_.tip_V(*plane.through) : Vec3(Vec3::Zero());
    if (!normal || normal->isZero(0.0) || !through) return;
    const Vec3 n = normal->stableNormalized(), center = through->dot(n) * n;
    const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
    const double radius = radius_of_plane(vectors_, plane);
    const Role role = role_from(plane.normal.quantity.role).value_or(kAxesRole);
    Tube rim{.points = {}, .closed = true, .radius = kRimRadius * m_.thickness, .color = role.paint};
    for (int k = 0; k < kPoints; ++k) {
      const double turn_rad = 2.0 * std::numbers::pi * k / kPoints;
      rim.points.push_back(center + radius * (std::cos(turn_rad) * u + std::sin(turn_rad) * v));
    }
    std::vector<Vec3> closed = rim.points;
    closed.push_back(closed.front());
    list_.meshes.push_back(fan(center, closed, n, translucent(role.paint, kPlaneAlpha)));
    list_.tubes.push_back(std::move(rim));
  }

  void add(const NoteMark& note) {
    const auto tip = vectors_.tip_V(note.at);
    if (!tip) return;
    if (const auto role = role_from(note.role))
      list_.labels.push_back({.text = with_decimals_in_formulas(note.text, m_.model.scene.language),
                              .anchor = *tip,
                              .color = role->ink,
                              .size = kSymbolSize,
                              .leader = false,
                              .tail = Vec3(Vec3::Zero()),
                              .beside = true});
    else
      list_.labels.push_back({.text = with_decimals_in_formulas(note.text, m_.model.scene.language),
                              .anchor = *tip,
                              .color = kInk,
                              .size = kTextSize});
  }

  static constexpr double kSquare = 0.5;  // of the radius of an angle: the sides of the square of a right one
  static constexpr double kPoint = 2.2;   // radii of a trail: the point that ends it
  static constexpr Color kUnitSphereTint = color_from_hex(0xC3CCD6);

  const Snapshot& m_;
  const Marks& marks_;
  DrawnVectors vectors_;
  Looks looks_;
  DrawList& list_;
};

}  // namespace

void add_marks(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (m.model.needs.marks) MarkBuilder(m, list).add_all();
}

void add_extents_of_marks(const Snapshot& m, Extents& extents) {
  if (!m.model.needs.marks) return;
  constexpr int kEvery = 2;  // of the steps of a course
  constexpr double kLine = 0.03;
  const Marks& marks = m.model.scene.marks;
  const DrawnVectors vectors(m);
  for (const TrailMark& trail : marks.trails)
    if (trail.on_sphere) extents.push_back(ball_at(Vec3::Zero(), 1.0));
  const auto hold = [&](const Vec3& at_V, double radius) {
    if (at_V.allFinite()) extents.push_back(ball_at(at_V, radius));
  };
  for (int n = 0; n <= kCourseSteps; n += kEvery) {
    const double t_s = m.model.span_s * n / kCourseSteps;
    const RigidBodyState then = m.model.motion->at(t_s);
    const auto step = static_cast<std::size_t>(n);
    for (std::size_t i = 0; i < marks.arrows.size(); ++i) {
      const ArrowMark& arrow = marks.arrows[i];
      const auto [tail_V, tip_V] = vectors.ends_V(i, step, then);
      if (!tail_V.allFinite() || !tip_V.allFinite() || !((tip_V - tail_V).norm() > kTooShort)) continue;
      hold(tail_V, kLine);
      hold(tip_V, kLine);
      const std::string& tex = arrow.tex.value_or(arrow.of.quantity.tex);
      if (!tex.empty() && arrow.name_at >= 1) extents.push_back(name_beyond(tip_V, tail_V, letters_of(tex)));
    }
    for (const TrailMark& trail : marks.trails)
      if (!trail.on_sphere) hold(vectors.place_V(trail.of, step, then), kLine);
    for (const AreaMark& area : marks.areas)
      if (const auto corners = vectors.corners_V(area, t_s, then))
        for (const Vec3& corner : *corners) hold(corner, kLine);
    for (const LineMark& line : marks.lines) {
      hold(vectors.place_V(line.from, step, then), kLine);
      hold(vectors.place_V(line.to, step, then), kLine);
    }
    for (const NoteMark& note : marks.notes) {
      constexpr double kHalfHeight = 0.06, kLetter = 0.035;
      Extent name = ball_at(vectors.place_V(note.at, step, then), kHalfHeight);
      name.aside = kLetter * static_cast<double>(note.text.size());
      if (name.center.allFinite()) extents.push_back(name);
    }
    for (std::size_t i = 0; i < marks.angles.size(); ++i) {
      constexpr double kName = 0.13;
      const double radius = radius_of_angle(
          m, i, [&](const MarkVector& vector) { return vectors.direction_V(vector, step, then); });
      const Vec3 from = vectors.direction_V(marks.angles[i].from, step, then),
                 to = vectors.direction_V(marks.angles[i].to, step, then);
      const auto& at = marks.angles[i].at;
      const Vec3 center = at ? vectors.place_V(*at, step, then) : Vec3(Vec3::Zero());
      hold(center + radius * from, kLabel);
      hold(center + radius * to, kLabel);
      hold(center + (radius + kLabel) * (from + to).stableNormalized(), kName);
    }
    for (const PlaneMark& plane : marks.planes) {
      const Vec3 normal = vectors.direction_V(plane.normal, step, then);
      const Vec3 through = plane.through ? vectors.place_V(*plane.through, step, then) : Vec3(Vec3::Zero());
      if (normal.allFinite() && through.allFinite())
        extents.push_back(disc_at(through.dot(normal) * normal, normal, radius_of_plane(vectors, plane)));
    }
  }
}

std::optional<Vec3> tip_of_arrow_V(const Snapshot& m, std::size_t arrow) {
  const DrawnVectors vectors(m);
  const ArrowMark& mark = m.model.scene.marks.arrows[arrow];
  const auto along = vectors.along_V(mark.of, &mark, m.t_s, m.state);
  const auto tail = vectors.tail_V(arrow, m.t_s, m.state);
  return along && tail && along->norm() > kTooShort ? std::optional(Vec3(*tail + *along)) : std::nullopt;
}

}  // namespace polhode::builders
