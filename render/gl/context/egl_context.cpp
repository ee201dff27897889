// SPDX-License-Identifier: MIT
// EGL_NO_X11: types only, no Xlib header.
#define EGL_NO_X11
#include "render/gl/context/context_open.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

namespace polhode {
namespace {

constexpr const char* kPackages = "the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri";

/// The end of a message, where the library is there, but none or none of use behind it.
std::string or_card(const char* package) {
  return std::string(". Install the Debian package ") + package + ", or a driver for your graphics card.";
}

struct Egl {
  PFNEGLGETPROCADDRESSPROC address;
  PFNEGLQUERYSTRINGPROC query_string;
  PFNEGLINITIALIZEPROC initialize;
  PFNEGLBINDAPIPROC bind_api;
  PFNEGLCHOOSECONFIGPROC choose_config;
  PFNEGLCREATECONTEXTPROC create_context;
  PFNEGLDESTROYCONTEXTPROC destroy_context;
  PFNEGLMAKECURRENTPROC make_current;
  PFNEGLGETERRORPROC error;
  PFNEGLRELEASETHREADPROC release_thread;
};

template <class F>
bool fetch(const KeptLibrary& library, const char* name, F& function) {
  function = reinterpret_cast<F>(library.symbol(name));
  return function != nullptr;
}

Result<Egl> load(const KeptLibrary& library) {
  Egl egl{};
  const bool complete =
      fetch(library, "eglGetProcAddress", egl.address) &&
      fetch(library, "eglQueryString", egl.query_string) && fetch(library, "eglInitialize", egl.initialize) &&
      fetch(library, "eglBindAPI", egl.bind_api) && fetch(library, "eglChooseConfig", egl.choose_config) &&
      fetch(library, "eglCreateContext", egl.create_context) &&
      fetch(library, "eglDestroyContext", egl.destroy_context) &&
      fetch(library, "eglMakeCurrent", egl.make_current) && fetch(library, "eglGetError", egl.error) &&
      fetch(library, "eglReleaseThread", egl.release_thread);
  if (complete) return egl;
  return failure(std::string(library.name()) + " lacks functions of EGL 1.4; install " + kPackages + ".");
}

bool lists(const char* extensions, std::string_view wanted) {
  std::string_view rest = extensions ? extensions : "";
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == wanted) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

std::string failed(const Egl& egl, const char* function) {
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "0x%04x", static_cast<unsigned>(egl.error()));
  return std::string(function) + " fails with EGL error " + code.data();
}

// The displays that need no screen, best first: Mesa's surfaceless platform (its software rasteriser where
// there is no GPU), then every device (drivers of other vendors have only these).
std::vector<EGLDisplay> displays(const Egl& egl) {
  std::vector<EGLDisplay> found;
  const char* extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.address("eglGetPlatformDisplayEXT"));
  if (!platform_display) return found;
  const auto add = [&](EGLenum platform, void* native) {
    const EGLDisplay display = platform_display(platform, native, nullptr);
    if (display != EGL_NO_DISPLAY) found.push_back(display);
  };
  if (lists(extensions, "EGL_MESA_platform_surfaceless"))
    add(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (!lists(extensions, "EGL_EXT_platform_device")) return found;
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.address("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!query_devices || !query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count))
    return found;
  for (EGLint i = 0; i < count; ++i) add(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)]);
  return found;
}

// The display is never terminated: EGL hands the same one to everybody in the process, so that it is not ours
// to end, and Mesa would unload its driver and LLVM only to load them again for the next context.
class EglContext : public GlContext {
 public:
  EglContext(const Egl& egl, EGLDisplay display) : egl_(egl), display_(display) {}
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() override {
    if (handle_ != EGL_NO_CONTEXT) {
      egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      egl_.destroy_context(display_, handle_);
    }
    egl_.release_thread();
  }

  Status open();
  void* function(const char* name) const override { return reinterpret_cast<void*>(egl_.address(name)); }
  ContextKind kind() const override { return ContextKind::egl; }

 private:
  Status create();

  Egl egl_;
  EGLDisplay display_;
  EGLContext handle_ = EGL_NO_CONTEXT;
};

Status EglContext::open() {
  EGLint major = 0;
  EGLint minor = 0;
  if (!egl_.initialize(display_, &major, &minor)) return failure(failed(egl_, "eglInitialize"));
  if (!lists(egl_.query_string(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
    return failure("the display lacks EGL_KHR_surfaceless_context");
  if (!egl_.bind_api(EGL_OPENGL_API)) return failure(failed(egl_, "eglBindAPI(EGL_OPENGL_API)"));
  Status created = create();
  if (!created) return created;
  if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_))
    return failure(failed(egl_, "eglMakeCurrent without a surface"));
  return success();
}

Status EglContext::create() {
  // Our pictures go to our own framebuffer object: any configuration that can do OpenGL serves.
  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl_.choose_config(display_, wanted.data(), &config, 1, &count))
    return failure(failed(egl_, "eglChooseConfig"));
  if (count == 0) return failure("eglChooseConfig finds no configuration with EGL_OPENGL_BIT");
  const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
  handle_ = egl_.create_context(display_, config, EGL_NO_CONTEXT, version.data());
  if (handle_ == EGL_NO_CONTEXT) return failure(failed(egl_, "eglCreateContext for OpenGL 3.3 core"));
  return success();
}

}  // namespace

ContextResult open_egl(const char* library_name) {
  const Result<KeptLibrary> library = KeptLibrary::open(library_name, kPackages);
  if (!library) return failure(library.error());
  const Result<Egl> egl = load(*library);
  if (!egl) return failure(egl.error());
  std::string reason = "it has neither the surfaceless nor the device platform" + or_card("libegl-mesa0");
  for (const EGLDisplay display : displays(*egl)) {
    auto context = std::make_unique<EglContext>(*egl, display);
    if (const Status opened = context->open(); !opened) {
      reason = opened.error() + or_card("libgl1-mesa-dri");
      continue;
    }
    const Status version = check_version(*context, library_name);
    if (version) return std::unique_ptr<GlContext>(std::move(context));
    reason = version.error();
  }
  return failure(std::string(library_name) + " gives no off-screen OpenGL 3.3: " + reason);
}

}  // namespace polhode
