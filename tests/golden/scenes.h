// SPDX-License-Identifier: MIT
// The golden images: one row for each kind of scene. A row names the mutations that cannot change its
// picture, and why; every other mutation must be refused by the comparison (golden_test.cpp).
#pragma once

#include "render/gl/renderer.h"
#include "render/scene/description/scene.h"

#include <string>
#include <vector>

namespace polhode::golden {

enum class Mutation { later, camera, overlay, color, attitude };
inline constexpr Mutation kMutations[] = {Mutation::later, Mutation::camera, Mutation::overlay,
                                          Mutation::color, Mutation::attitude};
const char* name_of(Mutation mutation);

struct Exception {
  Mutation mutation;
  std::string why;
};

struct Golden {
  std::string name;
  Scene scene;
  std::string background;
  Overlay removed;  ///< what Mutation::overlay takes away
  std::vector<Exception> cannot;
};

/// In the order of their names' first letters; t > 0 in every one.
std::vector<Golden> all();

}  // namespace polhode::golden
