// SPDX-License-Identifier: MIT
// What holds a heavy top: a stand below the pivot, the axle through it, and the weight that turns it.
#include "base/words/figure_words.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"
#include "render/scene/model/heavy_top_body.h"

#include <cmath>
#include <numbers>

namespace polhode::builders {
namespace {

constexpr Color kSteel = color_from_hex(0xAEB6BF);
constexpr double kFoot = -1.12;

/// Surface of revolution about z: radius and height of its rings, from below.
struct Ring {
  double radius, z;
};

void add_revolved(const std::vector<Ring>& rings, const Quat& q_V, const Color& color, DrawList& list) {
  constexpr unsigned kSides = 48;
  Mesh mesh;
  mesh.color = color;
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    const Ring &low = rings[k], &high = rings[k + 1];
    const double slope = high.z - low.z, shrink = low.radius - high.radius;
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (unsigned i = 0; i <= kSides; ++i) {
      const double a = 2.0 * std::numbers::pi * i / kSides;
      const Vec3 out(std::cos(a), std::sin(a), 0.0);
      const Vec3 normal = (slope * out + shrink * Vec3::UnitZ()).normalized();
      for (const Ring& ring : {low, high}) {
        mesh.positions.push_back(q_V * (ring.radius * out + ring.z * Vec3::UnitZ()));
        mesh.normals.push_back(q_V * normal);
      }
      if (i == kSides) break;
      for (unsigned corner : {0U, 2U, 1U, 1U, 2U, 3U}) mesh.triangles.push_back(first + 2 * i + corner);
    }
  }
  list.meshes.push_back(std::move(mesh));
}

void add_stand(DrawList& list) {
  add_revolved({{0.42, kFoot},
                {0.42, kFoot + 0.03},
                {0.40, kFoot + 0.05},
                {0.06, kFoot + 0.08},
                {0.030, -0.06},
                {0.045, -0.045},
                {0.045, 0.0},
                {0.0, 0.02}},
               Quat::Identity(), kSteel, list);
}

void add_axle(const Vec3& axis_V, double far, DrawList& list) {
  constexpr double kRadius = 0.022;
  add_revolved({{0.0, -0.1}, {kRadius, -0.1}, {kRadius, far}, {0.0, far}},
               shortest_rotation(Vec3::UnitZ(), axis_V), kSteel, list);
}

/// Where the weight is drawn: below the centre, and before the stand where that would hide it.
struct WeightEnds {
  Vec3 tail, tip;
  bool is_before_stand;
};
WeightEnds weight_ends(const Snapshot& m, const Camera& camera, const Vec3& center_V, double length) {
  const Vec3 tip = center_V - length * (m.q_VS * Vec3::UnitZ());
  constexpr double kNearStand = 0.12;  // of a top that is all but upright
  constexpr double kBefore = 0.09;     // half the stand's thickness, and half the arrow's
  if (m.view != View::space || tip.head<2>().norm() >= kNearStand) return {center_V, tip, false};
  Vec3 to_eye = camera.eye - camera.target;
  to_eye.z() = 0.0;
  const Vec3 before = to_eye.isZero(0.0) ? Vec3(Vec3::Zero()) : Vec3(kBefore * to_eye.normalized());
  return {center_V + before, tip + before, true};
}

}  // namespace

void add_pivot(const Snapshot& m, const Camera& camera, DrawList& list) {
  if (!m.shows(Overlay::pivot)) return;
  const HeavyTopBody body = heavy_top_body(m.model.scene, *heavy_top_of(m.model.scene));
  const double scale = scene_units_per_m(m);
  const Vec3 center_V = m.q_VB * (scale * body.center_B);
  const Vec3 half = 0.5 * scale * body.shape.size_m;
  add_axle(center_V.normalized(), center_V.norm() + half.minCoeff() + 0.1, list);
  if (m.view == View::space) add_stand(list);
  constexpr double kBelow = 0.24;
  const WeightEnds weight = weight_ends(m, camera, center_V, half.maxCoeff() + kBelow);
  list.arrows.push_back({.tail = weight.tail, .tip = weight.tip, .radius = 0.016, .color = kNRole.paint});
  // With or without `labels`: it is in no list of what is shown, and has the colour of torques.
  list.labels.push_back({.text = std::string(words::kWeight.in(m.model.scene.language)),
                         .anchor = weight.tip,
                         .color = kNRole.ink,
                         .size = 1.0,
                         .leader = false,
                         .tail = weight.tail,
                         .beside = weight.is_before_stand});
}

}  // namespace polhode::builders
