// SPDX-License-Identifier: MIT
#include "render/gl/passes/sheet_pass.h"

#include "render/gl/passes/sheet_geometry.h"
#include "render/gl/shader_sources.h"

namespace polhode {

Result<std::unique_ptr<SheetPass>> SheetPass::create(const Gl& gl) {
  auto program = Program::create(gl, "shape", {shaders::kShapeVert}, {shaders::kShapeFrag});
  if (!program) return failure(program.error());
  return std::unique_ptr<SheetPass>(new SheetPass(gl, std::move(program).value()));
}

void SheetPass::draw(const std::vector<FlatShape>& shapes, Size size) {
  if (shapes.empty()) return;
  program_.use();
  program_.set("u_size", static_cast<float>(size.width), static_cast<float>(size.height));
  stream_.draw(make_geometry(shapes));
}

}  // namespace polhode
