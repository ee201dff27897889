// SPDX-License-Identifier: MIT
// Units as learners type them, with more ways to write one than lessons have. Internal to lessons/claims/.
#pragma once

#include "lessons/claims/expressions/dimension.h"

#include <optional>
#include <string_view>

namespace polhode {

/// 1/s of turns, of radians and of neither have one dimension: what is counted tells them apart.
struct TypedUnit {
  ScaledUnit scaled;
  int angles = 0;  ///< the power of rad, deg, ° and rev together; rpm is an angle by a time
  int cycles = 0;  ///< the power of Hz
  bool is_percent = false;
};

/// Reads the units of lessons (scaled_unit) and, besides:
/// - min, h, rev, rpm and %;
/// - u for µ: "uJ";
/// - names without a blank between them, where they are no unit together: "Nm", "kWh";
/// - powers from −9 to 9, as "m2", "m^2", "m²", "s^-1", "s⁻¹", "s^(-1)";
/// - "1/min", "/min"; "*" and "·" between names.
/// What stands behind the first / is below the line; a second / is refused, and so is one with nothing behind
/// it. Nothing for what is no unit.
std::optional<TypedUnit> typed_unit(std::string_view text);

}  // namespace polhode
