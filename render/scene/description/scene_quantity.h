// SPDX-License-Identifier: MIT
// A quantity of a lesson's own in a scene: "E", "comp(L, 1)", "ddt(e3)". What computes it comes with it from
// whoever read it: scenes know no expressions.
#pragma once

#include "physics/body/state.h"

#include <functional>
#include <optional>
#include <string>

namespace polhode {

struct SceneModel;

struct SceneQuantity {
  std::string text;         ///< as it is written; what a saved scene writes again
  std::string tex;          ///< as it is printed, without macros
  std::string fingerprint;  ///< of its parts, words of the lesson written out: the same of what is the same
  bool is_vector = false;   ///< else a scalar
  std::string unit;         ///< of SI, "kg m²/s"; empty: a number, or one that cannot be told
  std::string role;         ///< of its colour, as role_from of palette.h knows it; empty: none
  /// On the model's motion, whose state at t_s the last argument is: components in space, SI; of a scalar
  /// the first. Nothing where it is not defined or not finite. What is nothing but rounding is 0. Pure. About
  /// 1 µs where it speaks of no rates, else with six more states of the motion.
  std::function<std::optional<Vec3>(const SceneModel&, double t_s, const RigidBodyState&)> value;

  /// The same word may stand for something else in a lesson that was changed.
  bool operator==(const SceneQuantity& other) const {
    return text == other.text && tex == other.tex && fingerprint == other.fingerprint && role == other.role;
  }
};

}  // namespace polhode
