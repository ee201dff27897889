// SPDX-License-Identifier: MIT
// What marks of one kind (mark.h) make together, or by how they are written: the edges of a box, a chain of
// arrows, a right angle.
#pragma once

#include "render/scene/description/mark.h"
#include "render/scene/model/model.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polhode {

/// The arguments of "cross(a, b)", if the whole is one; else they are empty.
std::pair<std::string, std::string> factors_of(std::string_view written);

/// Whether its sides are perpendicular on the model's motion at t_s.
bool is_right_angle(const AngleMark& angle, const SceneModel& model, double t_s);

/// Whether the lines are drawn as the edges of a box are: twelve between eight corners, where of two corners
/// those next to both are none or two, and no three are next to each other.
bool are_edges_of_box(const std::vector<LineMark>& lines);

/// Whether each of several arrows begins where the one before ends.
bool are_tip_to_tail(const std::vector<const ArrowMark*>& arrows);

}  // namespace polhode
