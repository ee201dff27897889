// SPDX-License-Identifier: MIT
// The parts of a model, which are computed only where a scene asks for them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// What a scene asks of the physics. To add a part: a member here and its row in requirements.cpp.
struct Requirements {
  bool omega = false;     ///< ω_B(t)
  bool attitude = false;  ///< q_SB(t)
  bool polhode = false;   ///< curve through ω
  bool polhode_family = false;
  bool separatrix = false;
  bool herpolhode = false;     ///< samples the motion with attitude
  bool rolling_ticks = false;  ///< times of equal arc length along the polhode
  bool trail_L = false;
  bool trail_omega = false;
  bool cones = false;
  bool solid = false;    ///< a shape to draw
  bool meters = false;   ///< plots against time
  bool terms = false;    ///< how long the terms of I·ω̇ + ω×(I·ω) = N become
  bool ghost = false;    ///< the exact motion beside the computed one
  bool methods = false;  ///< the table of methods
  bool orders = false;   ///< the same at shorter and shorter steps
  bool marks = false;    ///< trails, arrows, angles, areas, lines, planes and notes of the lesson's own
  bool operator==(const Requirements&) const = default;
};

struct RequirementFacts {
  bool Requirements::*part;
  std::string_view name;   ///< as `info` says it
  std::string_view words;  ///< as the window says it
};
/// All of them, in the order of the members.
std::span<const RequirementFacts> requirement_facts();

/// Of the parts that are needed.
std::vector<std::string> names_of(const Requirements& needs);

}  // namespace polhode
