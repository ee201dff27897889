// SPDX-License-Identifier: MIT
#include "render/gl/context/context.h"

#include "render/gl/context/context_open.h"

#include <GL/glcorearb.h>
#include <dlfcn.h>
#include <sys/resource.h>

#include <cstdio>
#include <string>

namespace polhode {

Result<KeptLibrary> KeptLibrary::open(const char* name, const char* packages) {
  void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (handle) return KeptLibrary(handle, name);
  const char* reason = dlerror();
  return failure(std::string("Cannot open ") + name + ": " + (reason ? reason : "unknown reason") +
                 ". Install " + packages + ".");
}

void* KeptLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

Status check_version(const GlContext& context, const char* maker) {
  const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(context.function("glGetString"));
  const char* text = get_string ? reinterpret_cast<const char*>(get_string(GL_VERSION)) : nullptr;
  int major = 0;
  int minor = 0;
  const bool read = text && std::sscanf(text, "%d.%d", &major, &minor) == 2;
  if (read && (major > 3 || (major == 3 && minor >= 3))) return success();
  return failure(std::string(maker) + " gives OpenGL \"" + (text ? text : "of no version") +
                 "\", but 3.3 or newer is needed. Install a newer Mesa.");
}

ContextResult open_any(const char* osmesa_library, const char* egl_library) {
  ContextResult osmesa = open_osmesa(osmesa_library);
  if (osmesa) return osmesa;
  ContextResult egl = open_egl(egl_library);
  if (egl) return egl;
  // EGL first: its packages are those that every release has.
  return failure("No off-screen OpenGL. EGL: " + egl.error() + " OSMesa: " + osmesa.error());
}

namespace {

/// Mesa compiles shaders as it goes, and a compiler without memory ends the program: what is left to it is
/// looked at before. With 600 MB of addresses (Mesa 22.3, two threads) it did not come to its first picture,
/// with 700 it did.
Status check_memory() {
  constexpr rlim_t kLeast = rlim_t{640} << 20;
  rlimit addresses{};
  if (getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur == RLIM_INFINITY ||
      addresses.rlim_cur >= kLeast)
    return success();
  return failure("Drawing needs 640 MiB of memory or more, and no more than " +
                 std::to_string(addresses.rlim_cur >> 20) + " MiB are allowed here (ulimit -v).");
}

}  // namespace

Result<std::unique_ptr<GlContext>> open_context(ContextKind kind) {
  if (const Status memory = check_memory(); !memory) return failure(memory.error());
  if (kind == ContextKind::osmesa) return open_osmesa();
  if (kind == ContextKind::egl) return open_egl();
  return open_any();
}

}  // namespace polhode
