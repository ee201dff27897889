// SPDX-License-Identifier: MIT
#include "render/gl/context/context_open.h"

#include <GL/glcorearb.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace polhode {
namespace {

// The few declarations of <GL/osmesa.h> that we use: Debian ships that header in a -dev package of its own,
// which newer releases no longer have.
using OsmesaHandle = struct osmesa_context*;
using OsmesaFunction = void (*)();
using CreateContextAttribs = OsmesaHandle (*)(const int* attributes, OsmesaHandle share);
using MakeCurrent = GLboolean (*)(OsmesaHandle, void* buffer, GLenum type, GLsizei width, GLsizei height);
using DestroyContext = void (*)(OsmesaHandle);
using GetProcAddress = OsmesaFunction (*)(const char* name);
constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kStencilBits = 0x31;
constexpr int kAccumBits = 0x32;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

constexpr const char* kPackage = "the package libosmesa6, which Debian has up to release 13";

struct Osmesa {
  CreateContextAttribs create;
  MakeCurrent make_current;
  DestroyContext destroy;
  GetProcAddress address;
};

Result<Osmesa> load(const KeptLibrary& library) {
  const Osmesa osmesa{reinterpret_cast<CreateContextAttribs>(library.symbol("OSMesaCreateContextAttribs")),
                      reinterpret_cast<MakeCurrent>(library.symbol("OSMesaMakeCurrent")),
                      reinterpret_cast<DestroyContext>(library.symbol("OSMesaDestroyContext")),
                      reinterpret_cast<GetProcAddress>(library.symbol("OSMesaGetProcAddress"))};
  if (osmesa.create && osmesa.make_current && osmesa.destroy && osmesa.address) return osmesa;
  return failure(
      std::string(library.name()) +
      " lacks OSMesaCreateContextAttribs or another function of OSMesa 12; install a newer libosmesa6.");
}

class OsmesaContext : public GlContext {
 public:
  OsmesaContext(const Osmesa& osmesa, OsmesaHandle handle) : osmesa_(osmesa), handle_(handle) {}
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;
  ~OsmesaContext() override {
    osmesa_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    osmesa_.destroy(handle_);
  }

  bool make_current() {
    return osmesa_.make_current(handle_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE;
  }
  void* function(const char* name) const override { return reinterpret_cast<void*>(osmesa_.address(name)); }

 private:
  // OSMesa insists on a buffer to draw into; our pictures go to our own framebuffer object instead.
  static constexpr int kSide = 16;
  Osmesa osmesa_;
  OsmesaHandle handle_;
  std::array<std::uint8_t, 4 * kSide * kSide> buffer_{};
};

/// OSMesa asks for no other than these two, and does not look whether it got the one that the environment
/// names.
Status check_driver() {
  const char* name = std::getenv("GALLIUM_DRIVER");
  if (!name || !*name) return success();
  for (const std::string_view known : {"llvmpipe", "softpipe"})
    if (known == name) return success();
  return failure(std::string("OSMesa has no driver \"") + name +
                 "\"; set GALLIUM_DRIVER to llvmpipe, softpipe or nothing.");
}

}  // namespace

ContextResult open_osmesa(const char* library_name) {
  if (const Status driver = check_driver(); !driver) return failure(driver.error());
  const Result<KeptLibrary> library = KeptLibrary::open(library_name, kPackage);
  if (!library) return failure(library.error());
  const Result<Osmesa> osmesa = load(*library);
  if (!osmesa) return failure(osmesa.error());
  const std::array attributes{kFormat,  GL_RGBA,      kDepthBits,    24, kStencilBits,  0, kAccumBits, 0,
                              kProfile, kCoreProfile, kMajorVersion, 3,  kMinorVersion, 3, 0,          0};
  const OsmesaHandle handle = osmesa->create(attributes.data(), nullptr);
  if (!handle)
    return failure(std::string("OSMesaCreateContextAttribs of ") + library_name +
                   " refuses an OpenGL 3.3 core context; install a newer libosmesa6.");
  auto context = std::make_unique<OsmesaContext>(*osmesa, handle);
  if (!context->make_current())
    return failure(std::string("OSMesaMakeCurrent of ") + library_name + " fails; is memory short?");
  const Status version = check_version(*context, library_name);
  if (!version) return failure(version.error());
  return std::unique_ptr<GlContext>(std::move(context));
}

}  // namespace polhode
