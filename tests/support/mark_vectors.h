// SPDX-License-Identifier: MIT
// Vectors for marks, made by hand: what a lesson's expressions come to is tested with its reader.
#pragma once

#include "render/scene/description/mark.h"

#include <functional>
#include <string>

namespace polhode::test {

using VectorOfState = std::function<Vec3(const RigidBodyState&)>;

/// Components in space.
inline MarkVector mark_vector(const std::string& text, const VectorOfState& value_S, bool is_number = false) {
  SceneQuantity quantity{
      .text = text, .tex = text, .fingerprint = text, .is_vector = true, .unit = "", .role = "", .value = {}};
  quantity.value = [value_S](const SceneModel&, double, const RigidBodyState& state) -> std::optional<Vec3> {
    const Vec3 value = value_S(state);
    return value.allFinite() ? std::optional(value) : std::nullopt;
  };
  return {std::move(quantity), is_number, std::nullopt};
}

inline MarkVector body_axis(int index) {
  return mark_vector(
      "e_" + std::to_string(index + 1),
      [index](const RigidBodyState& s) { return Vec3(s.q_SB * Vec3::Unit(index)); }, true);
}

inline MarkVector space_axis(int index) {
  return mark_vector(
      std::string(1, "xyz"[index]), [index](const RigidBodyState&) { return Vec3::Unit(index); }, true);
}

/// ω.
inline MarkVector omega_vector() {
  MarkVector omega = mark_vector("\\omega", [](const RigidBodyState& s) { return Vec3(s.q_SB * s.w_B); });
  omega.quantity.role = "omega";
  omega.overlay = Overlay::omega;
  return omega;
}

/// dê3/dt = ω × ê3, rad/s.
inline MarkVector rate_of_e3() {
  return mark_vector("v", [](const RigidBodyState& s) { return Vec3(s.q_SB * s.w_B.cross(Vec3::UnitZ())); });
}

}  // namespace polhode::test
