// SPDX-License-Identifier: MIT
// Names of what is shown, anchored to it, and the computed values in the corner.
#include "base/words/figure_words.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <optional>
#include <vector>

namespace polhode::builders {
namespace {

const Vec3 kCenter = Vec3::Zero();

void add_symbol(DrawList& list, const char* text, const Vec3& anchor, const Color& color, const Vec3& tail) {
  list.labels.push_back(
      {.text = text, .anchor = anchor, .color = color, .size = kSymbolSize, .leader = false, .tail = tail});
}

/// @param side on the screen, x to the right and y up, where it stands
void add_text(DrawList& list, std::string text, const Vec3& anchor, const Color& color,
              const Eigen::Vector2d& side) {
  list.labels.push_back({.text = std::move(text),
                         .anchor = anchor,
                         .color = color,
                         .size = kTextSize,
                         .side = side.normalized()});
}

Vec3 in_space(const Camera& camera, const Eigen::Vector2d& side) {
  return screen_direction(camera, side.x(), side.y());
}

/// The point of a curve that lies furthest in a screen direction, if possible on the side of the viewer.
Vec3 furthest(const std::vector<Vec3>& points, const Camera& camera, const Vec3& direction) {
  const Vec3 to_eye = (camera.eye - camera.target).normalized();
  const auto score = [&](const Vec3& p) { return p.dot(direction) + 0.6 * std::min(0.0, p.dot(to_eye)); };
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return score(a) < score(b); });
}

/// Whether a point is seen in a picture that is `most` times as wide as high.
bool is_in_picture(const Camera& camera, const Vec3& point, double most) {
  const auto at = project(camera, point, 1.0, 1.0);
  return at && std::abs(at->y() - 0.5) < 0.5 && std::abs(at->x() - 0.5) < 0.5 * most;
}

/// As `furthest`; of a curve that leaves the picture there, as that of a method that gains energy does, among
/// its points well inside. Nothing if it has none.
std::optional<Vec3> furthest_in_picture(const std::vector<Vec3>& points, const Camera& camera,
                                        const Vec3& direction) {
  constexpr double kWidest = 2.0, kInside = 0.9;
  const Vec3 end = furthest(points, camera, direction);
  if (is_in_picture(camera, end, kWidest)) return end;
  std::vector<Vec3> seen;
  std::copy_if(points.begin(), points.end(), std::back_inserter(seen),
               [&](const Vec3& p) { return is_in_picture(camera, p, kInside); });
  if (seen.empty()) return std::nullopt;
  return furthest(seen, camera, direction);
}

void label_triads(const Snapshot& m, DrawList& list) {
  constexpr std::array<const char*, 3> kSpace = {"$x$", "$y$", "$z$"};
  constexpr std::array<const char*, 3> kBody = {"1", "2", "3"};
  constexpr double kBeyond = kTriadLength + 0.06;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (m.shows(Overlay::axes_space))
      list.labels.push_back({.text = kSpace[k],
                             .anchor = m.q_VS * (kBeyond * Vec3::Unit(i)) - m.center_V,
                             .color = kAxesRole.ink,
                             .size = 1.0,
                             .leader = false,
                             .tail = -m.center_V});
    if (m.shows(Overlay::axes_body))
      list.labels.push_back({.text = kBody[k],
                             .anchor = m.q_VB * (kBeyond * Vec3::Unit(i)),
                             .color = kBodyAxisRoles[k].ink,
                             .size = 1.15,
                             .leader = false,
                             .tail = kCenter});
  }
}

void label_vectors(const Snapshot& m, DrawList& list) {
  if (m.state.w_B.isZero(0.0)) return;
  constexpr double kBeyond = 0.06;
  const auto beyond = [](const Vec3& tip) -> Vec3 {
    return tip * (1.0 + kBeyond / std::max(tip.norm(), 0.1));
  };
  if (m.shows(Overlay::omega))
    add_symbol(list, "$\\vec\\omega$", beyond(m.omega_tip_V()), kOmegaRole.ink, kCenter);
  if (m.shows(Overlay::L)) add_symbol(list, "$\\vec L$", beyond(m.L_tip_V()), kLRole.ink, kCenter);
  if (m.shows(Overlay::N) && !m.shows(Overlay::terms) && !m.N_B.isZero(0.0))
    add_symbol(list, "$\\vec N$", torque_ends(m).tip, kNRole.ink, torque_ends(m).tail);
}

/// The tubes of a draw list by role, because a curve is labelled where it was drawn.
const Tube* find_tube(const DrawList& list, const Color& color) {
  for (const Tube& tube : list.tubes)
    if (tube.color == color && tube.points.size() > 2) return &tube;
  return nullptr;
}

void label_curves(const Snapshot& m, const Camera& camera, DrawList& list) {
  // Names stand higher or lower than the point they name: level with it a leader is read as a minus.
  const Eigen::Vector2d right(1.0, 0.25), left(-1.0, 0.15), low_right(1.0, -0.6);
  const auto name = [&](const Color& curve, const Phrase& text, const Eigen::Vector2d& end,
                        const Color& ink) {
    const Eigen::Vector2d side(end.x(), end.y() < 0.0 ? -0.8 : 0.8);
    const Tube* tube = find_tube(list, curve);
    if (tube == nullptr) return;
    if (const auto at = furthest_in_picture(tube->points, camera, in_space(camera, end)))
      add_text(list, std::string(text.in(m.model.scene.language)), *at, ink, side);
  };
  if (m.shows(Overlay::polhode))
    name(kPolhodeRole.paint, m.L_scale > 0.0 ? words::kPathOfL : words::kPolhode, right, kPolhodeRole.ink);
  if (m.shows(Overlay::herpolhode))
    name(kHerpolhodeRole.paint, words::kHerpolhode, low_right, kHerpolhodeRole.ink);
  if (m.shows(Overlay::separatrix) && !m.model.separatrices_B.empty())
    name(kSeparatrixPaint, words::kSeparatrix, left, kAxesRole.ink);
}

void label_surfaces(const Snapshot& m, const Camera& camera, DrawList& list) {
  const auto on_silhouette = [&](const GlassEllipsoid& e, const Vec3& direction) -> Vec3 {
    const Vec3 d = e.rotation.conjugate() * direction;  // support point of the ellipsoid
    const Vec3 scaled = e.semi_axes.cwiseProduct(d);
    return e.center + e.rotation * Vec3(e.semi_axes.cwiseProduct(scaled.normalized()));
  };
  if (m.shows(Overlay::plane) && !list.floors.empty()) {
    const Vec3 aside = screen_direction(camera, 1.0, 0.0);
    const Vec3 away = -(camera.eye - camera.target).normalized();
    const Vec3 level(1.75 * aside.x() + 0.5 * away.x(), 1.75 * aside.y() + 0.5 * away.y(), list.floors[0].z);
    list.labels.push_back({.text = std::string(words::kInvariablePlane.in(m.model.scene.language)),
                           .anchor = level,
                           .color = kAxesRole.ink,
                           .size = kTextSize,
                           .leader = false});
  }
  if (m.shows(Overlay::momentum_sphere) && list.ellipsoids.size() > 1) {
    const Eigen::Vector2d left(-0.8, 0.6), right(0.8, 0.6);
    add_text(list, "$2T$ = const.", on_silhouette(list.ellipsoids.front(), in_space(camera, left)), kGlassInk,
             left);
    add_text(list, "$|\\vec L|$ = const.", on_silhouette(list.ellipsoids.back(), in_space(camera, right)),
             kSphereInk, right);
  }
}

void label_cones(const Snapshot& m, const Camera& camera, DrawList& list) {
  if (!m.shows(Overlay::cones)) return;
  const Eigen::Vector2d side(-1.0, 0.4);
  const auto name = [&](const Color& rim, const Phrase& text, const Color& ink) {
    if (const Tube* tube = find_tube(list, rim))
      add_text(list, std::string(text.in(m.model.scene.language)),
               furthest(tube->points, camera, in_space(camera, side)), ink, side);
  };
  name(kPolhodeRole.paint, words::kBodyCone, kPolhodeRole.ink);
  if (m.view == View::space) name(kHerpolhodeRole.paint, words::kSpaceCone, kHerpolhodeRole.ink);
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%#.4g", value);
  return text.data();
}

}  // namespace

Vec3 screen_direction(const Camera& camera, double x, double y) {
  const Eigen::Matrix4d v = camera.view();
  return x * Vec3(v(0, 0), v(0, 1), v(0, 2)) + y * Vec3(v(1, 0), v(1, 1), v(1, 2));
}

void add_labels(const Snapshot& m, const Camera& camera, DrawList& list) {
  if (!m.shows(Overlay::labels)) return;
  label_vectors(m, list);
  label_triads(m, list);
  label_curves(m, camera, list);
  label_surfaces(m, camera, list);
  label_cones(m, camera, list);
}

void add_values(const Snapshot& m, DrawList& list) {
  const double L = norm_of(m.L_B);
  // L²/2T, whose square may leave the range of double: |L| by the distance 2T/|L| of the plane.
  const double J = m.state.w_B.isZero(0.0) ? 0.0 : L / invariable_plane_distance(m.I(), m.state.w_B);
  Readout readout;
  const std::string gap = "\u2003";  // an em
  readout.lines.push_back("$I_1$ = " + number(m.I()[0]) + gap + "$I_2$ = " + number(m.I()[1]) + gap +
                          "$I_3$ = " + number(m.I()[2]) + " kg m²");
  readout.lines.push_back("$2T$ = $\\vec\\omega\\cdot\\vec L$ = " + number(m.two_T) + " J" + gap +
                          "$|\\vec L|$ = " + number(L) + " kg m²/s");
  if (J > 0.0) readout.lines.push_back("$L^2/2T$ = " + number(J) + " kg m²");
  Vec3 sorted = m.I().vector();
  std::sort(sorted.begin(), sorted.end());
  readout.color_bar = m.shows(Overlay::polhode_family) && J > 0.0 && sorted[2] > sorted[0];
  if (readout.color_bar) readout.marker = scale_place(m.I(), J);
  for (std::string& line : readout.lines) line = with_decimals(std::move(line), m.model.scene.language);
  list.readouts.push_back(std::move(readout));
}

}  // namespace polhode::builders
