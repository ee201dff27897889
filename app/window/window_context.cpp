// SPDX-License-Identifier: MIT
#include "app/window/window_context.h"

#include "render/gl/context/context_open.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace polhode {

namespace {

class WindowContext final : public GlContext {
 public:
  void* function(const char* name) const override {
    return reinterpret_cast<void*>(glfwGetProcAddress(name));
  }
};

}  // namespace

Result<std::unique_ptr<GlContext>> context_of_window(GLFWwindow* window) {
  glfwMakeContextCurrent(window);
  auto context = std::make_unique<WindowContext>();
  if (Status version = check_version(*context, "The window's driver"); !version)
    return failure(version.error());
  return std::unique_ptr<GlContext>(std::move(context));
}

}  // namespace polhode
