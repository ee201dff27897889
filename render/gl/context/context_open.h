// SPDX-License-Identifier: MIT
// Internal to render/gl/: the two ways to open a context, with the library's name open to tests.
#pragma once

#include "base/result.h"
#include "render/gl/context/context.h"

#include <memory>
#include <string>

namespace polhode {

inline constexpr const char* kOsmesaLibrary = "libOSMesa.so.8";
inline constexpr const char* kEglLibrary = "libEGL.so.1";

using ContextResult = Result<std::unique_ptr<GlContext>>;

ContextResult open_osmesa(const char* library = kOsmesaLibrary);
ContextResult open_egl(const char* library = kEglLibrary);
/// OSMesa, and if that fails EGL; the error names both failures.
ContextResult open_any(const char* osmesa_library = kOsmesaLibrary, const char* egl_library = kEglLibrary);

/// A library opened with RTLD_LOCAL and kept: Mesa and LLVM register thread-exit and atexit handlers, so
/// unloading them pulls code from under their own feet, and loading them again costs 20 ms. dlopen counts, it
/// does not reload.
class KeptLibrary {
 public:
  /// `packages`: "the package …" that has it, for the message.
  static Result<KeptLibrary> open(const char* name, const char* packages);
  const char* name() const { return name_; }
  /// Null if the library has no such symbol.
  void* symbol(const char* name) const;

 private:
  KeptLibrary(void* handle, const char* name) : handle_(handle), name_(name) {}
  void* handle_;
  const char* name_;
};

/// Success if the current context is OpenGL 3.3 or newer. `maker` is the library, for the message.
Status check_version(const GlContext& context, const char* maker);

}  // namespace polhode
