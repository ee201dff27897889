// SPDX-License-Identifier: MIT
#define GL_GLEXT_PROTOTYPES  // the browser's functions are linked, each by its name
#include "render/gl/context/webgl_context.h"

#include "render/gl/context/functions.h"

#include <emscripten/html5.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace polhode {

namespace {

struct Function {
  std::string_view name;
  void* address;
};

/// Those that we call and no others: each is a piece of script in the page.
void* address_of(std::string_view name) {
  static const Function kFunctions[] = {
#define POLHODE_GL_ADDRESS(name, TYPE) {"gl" #name, reinterpret_cast<void*>(&gl##name)},
      POLHODE_GL_FUNCTIONS(POLHODE_GL_ADDRESS)
#undef POLHODE_GL_ADDRESS
  };
  const auto found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                  [&](const Function& one) { return one.name == name; });
  return found == std::end(kFunctions) ? nullptr : found->address;
}

class CanvasContext final : public GlContext {
 public:
  explicit CanvasContext(EMSCRIPTEN_WEBGL_CONTEXT_HANDLE handle) : handle_(handle) {}
  CanvasContext(const CanvasContext&) = delete;
  CanvasContext& operator=(const CanvasContext&) = delete;
  ~CanvasContext() override { emscripten_webgl_destroy_context(handle_); }

  void* function(const char* name) const override { return address_of(name); }

 private:
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE handle_;
};

}  // namespace

Result<std::unique_ptr<GlContext>> context_of_canvas(const std::string& selector) {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.majorVersion = 2;
  wanted.minorVersion = 0;
  wanted.alpha = EM_TRUE;
  wanted.premultipliedAlpha = EM_TRUE;
  wanted.depth = EM_FALSE;
  wanted.stencil = EM_FALSE;
  wanted.antialias = EM_FALSE;
  wanted.preserveDrawingBuffer = EM_TRUE;
  const auto handle = emscripten_webgl_create_context(selector.c_str(), &wanted);
  if (handle <= 0) return failure("This browser has no WebGL 2 here, so the figure stays a picture.");
  auto context = std::make_unique<CanvasContext>(handle);
  if (emscripten_webgl_make_context_current(handle) != EMSCRIPTEN_RESULT_SUCCESS)
    return failure("The browser does not let the figure be drawn, so it stays a picture.");
  return std::unique_ptr<GlContext>(std::move(context));
}

}  // namespace polhode
