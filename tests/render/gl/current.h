// SPDX-License-Identifier: MIT
// A context with its functions, for tests that draw.
#pragma once

#include "render/gl/context/context.h"
#include "render/gl/context/functions.h"

#include <memory>
#include <stdexcept>

namespace polhode::test {

struct Current {
  std::unique_ptr<GlContext> context;
  Gl gl;

  explicit Current(ContextKind kind = ContextKind::any) {
    Result<std::unique_ptr<GlContext>> opened = open_context(kind);
    if (!opened) throw std::runtime_error(opened.error());
    context = std::move(*opened);
    const Result<Gl> loaded = Gl::load(*context);
    if (!loaded) throw std::runtime_error(loaded.error());
    gl = *loaded;
  }
};

}  // namespace polhode::test
