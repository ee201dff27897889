// SPDX-License-Identifier: MIT
#include "app/narration/alt_text.h"

#include "physics/body/euler.h"
#include "render/drawing/diagrams/diagrams.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace polhode {

namespace {

std::string words_of(Overlay overlay) {
  switch (overlay) {
    case Overlay::shape:
      return "the solid body";
    case Overlay::energy_ellipsoid:
      return "the energy ellipsoid";
    case Overlay::momentum_sphere:
      return "the sphere of constant angular momentum";
    case Overlay::momentum_ellipsoid:
      return "the momentum ellipsoid";
    case Overlay::omega:
      return "the angular velocity ω";
    case Overlay::L:
      return "the angular momentum L";
    case Overlay::N:
      return "the torque N";
    case Overlay::axes_body:
      return "the body axes 1, 2, 3";
    case Overlay::axes_space:
      return "the space axes x, y, z";
    case Overlay::polhode:
      return "the polhode";
    case Overlay::polhode_family:
      return "the family of polhodes of the same energy";
    case Overlay::separatrix:
      return "the separatrices";
    case Overlay::herpolhode:
      return "the herpolhode";
    case Overlay::plane:
      return "the invariable plane";
    case Overlay::trail_L:
      return "the trail of the tip of L";
    case Overlay::trail_omega:
      return "the trail of the tip of ω";
    case Overlay::cones:
      return "the body cone and the space cone";
    case Overlay::labels:
      break;  // names of the rest
    case Overlay::values:
      return "the computed values";
    case Overlay::turn_orders:
      return "the body turned by a quarter about x and then y, and beside it about y and then x";
    case Overlay::p:
      return "the momentum p of the centre of mass";
    case Overlay::v:
      return "the velocity v of the centre of mass";
    case Overlay::F:
      return "the force F";
    case Overlay::puck:
      return "a sliding puck";
    case Overlay::transport:
      return "an arrow A, at its tip a triangle of dA/dt, d*A/dt and ω×A";
    case Overlay::terms:
      return "the arrows of I·ω̇ and ω×(I·ω), which add up to N";
    case Overlay::pivot:
      return "the stand and the axle";
    case Overlay::tensor_bars:
      return "bars of the components of I in space and in the body";
    case Overlay::cofactors:
      return "ω×(I·ω) as a determinant with its cofactors";
    case Overlay::cyclic_wheel:
      return "the wheel of the indices 1, 2, 3";
    case Overlay::energy_rows:
      return "the three products that cancel in the rate of the energy";
    case Overlay::momentum_rows:
      return "the three products that cancel in the rate of L·L";
    case Overlay::cards:
      return "cards of the twelve equations";
    case Overlay::method_table:
      return "a table of methods, their errors and their cost";
    case Overlay::order_plot:
      return "the errors of methods against the number of their steps, and their measured orders";
  }
  return "";
}

std::string view_words(const std::vector<View>& views) {
  if (views.size() > 1) return "Seen from space and from the body, side by side";
  return !views.empty() && views.front() == View::body ? "Seen from the body" : "Seen from space";
}

std::string board_words(const OverlaySet& show) {
  const std::size_t count = boards_in(show).size();
  return count > 1 ? "Boards" : "A board";
}

std::string shown_words(const OverlaySet& show) {
  std::vector<std::string> words;
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    if (show.contains(overlay) && !words_of(overlay).empty()) words.push_back(words_of(overlay));
  }
  if (words.empty()) return "nothing";
  const std::string last = words.back();
  words.pop_back();
  return words.empty() ? last : fmt::format("{} and {}", fmt::join(words, ", "), last);
}

std::string moment_words(const PrincipalMoments& I, const Vec3& w_B, double t_s) {
  const Vec3 L_B = angular_momentum_B(I, w_B);
  const double angle_deg = std::atan2(w_B.cross(L_B).norm(), w_B.dot(L_B)) * 180.0 / std::numbers::pi;
  std::string text = fmt::format("At t = {:.4g} s the body turns at {:.3g} rad/s", t_s, w_B.norm());
  constexpr double kParallel_deg = 1e-6;  // what rounding leaves
  if (!w_B.isZero(0.0))
    text += angle_deg < kParallel_deg ? ", with ω along L"
                                      : fmt::format(", with ω {:.2g}° away from L", angle_deg);
  return text + '.';
}

}  // namespace

std::string alt_text(const Scene& scene, const std::string& caption, const Vec3& w_B, double t_s) {
  const OverlaySet drawn = drawn_overlays(scene);
  std::string text = fmt::format(
      "{}: {}. ", shows_space(drawn) ? view_words(scene.views) : board_words(drawn), shown_words(drawn));
  if (!caption.empty()) text += caption + (caption.ends_with('.') ? " " : ". ");
  const Vec3& I = scene.body.moments.vector();
  text += fmt::format("The body is \"{}\" with principal moments {:.4g}, {:.4g}, {:.4g} kg m². ",
                      scene.body.name, I[0], I[1], I[2]);
  return text + moment_words(scene.body.moments, w_B, t_s);
}

}  // namespace polhode
