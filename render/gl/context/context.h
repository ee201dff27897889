// SPDX-License-Identifier: MIT
// Who makes an OpenGL context; all drawing goes to our own framebuffer, so nothing else differs.
#pragma once

#include "base/result.h"

#include <memory>
#include <string>

namespace polhode {

enum class ContextKind { any, osmesa, egl };  ///< `any`: OSMesa, and if that fails EGL

/// A current OpenGL ≥ 3.3 core context. It is made current on the thread that opened it and must stay there;
/// one at a time. (The window's own context is another implementation, in app/.)
class GlContext {
 public:
  virtual ~GlContext() = default;
  /// Address of a GL function; null if there is none.
  virtual void* function(const char* name) const = 0;
};

/// Opens libOSMesa or libEGL (surfaceless platform) at run time. The error names what failed and the Debian
/// package to install.
Result<std::unique_ptr<GlContext>> open_context(ContextKind kind);

}  // namespace polhode
