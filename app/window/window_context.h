// SPDX-License-Identifier: MIT
// The OpenGL context of a GLFW window.
#pragma once

#include "render/gl/context/context.h"

struct GLFWwindow;

namespace polhode {

/// Makes it current on this thread. The error says which version it is, if that is not enough. `window` must
/// outlive the context.
Result<std::unique_ptr<GlContext>> context_of_window(GLFWwindow* window);

}  // namespace polhode
