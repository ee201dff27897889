// SPDX-License-Identifier: MIT
// Draws the flat shapes of a sheet with soft edges. Internal to render/gl/.
#pragma once

#include "render/drawing/sheet.h"
#include "render/gl/shader.h"
#include "render/gl/stream.h"
#include "render/image/image.h"

#include <memory>

namespace polhode {

class SheetPass {
 public:
  static Result<std::unique_ptr<SheetPass>> create(const Gl& gl);

  /// Draws into the bound framebuffer of this size, with premultiplied blending on.
  void draw(const std::vector<FlatShape>& shapes, Size size);

 private:
  SheetPass(const Gl& gl, Program program) : program_(std::move(program)), stream_(gl, {2, 4, 4}) {}

  Program program_;
  VertexStream stream_;
};

}  // namespace polhode
