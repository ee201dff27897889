// SPDX-License-Identifier: MIT
// Pictures in an X11 window without OpenGL: for machines whose display has none.
#pragma once

#include "base/result.h"
#include "render/image/image.h"

#include <memory>

struct GLFWwindow;

namespace polhode {

class PlainWindow {
 public:
  /// Of a window that was made without a client API. The error says which kind of display cannot show them.
  static Result<std::unique_ptr<PlainWindow>> create(GLFWwindow* window);
  virtual ~PlainWindow() = default;
  /// From the upper left corner of the window on.
  virtual void show(const Image& picture) = 0;
};

}  // namespace polhode
