// SPDX-License-Identifier: MIT
#include "render/gl/context/context.h"

#include "render/gl/context/context_open.h"
#include "render/gl/context/functions.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace polhode {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// EGL knows which of its contexts is current, and OSMesa is what is left.
ContextKind kind_of_current() {
  void* egl = dlopen(kEglLibrary, RTLD_NOW | RTLD_LOCAL);
  const auto current = egl ? reinterpret_cast<void* (*)()>(dlsym(egl, "eglGetCurrentContext")) : nullptr;
  return current && current() ? ContextKind::egl : ContextKind::osmesa;
}

class EachContext : public testing::TestWithParam<ContextKind> {};
INSTANTIATE_TEST_SUITE_P(Context, EachContext, testing::Values(ContextKind::osmesa, ContextKind::egl),
                         [](const auto& tested) {
                           return tested.param == ContextKind::egl ? "egl" : "osmesa";
                         });

TEST_P(EachContext, OpensWithAtLeastOpenGl33) {
  const ContextResult context = open_context(GetParam());
  ASSERT_TRUE(context.ok()) << context.error();
  EXPECT_EQ(kind_of_current(), GetParam());
  const Result<Gl> gl = Gl::load(**context);
  ASSERT_TRUE(gl.ok()) << gl.error();
  GLint major = 0;
  GLint minor = 0;
  gl->GetIntegerv(GL_MAJOR_VERSION, &major);
  gl->GetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(10 * major + minor, 33);
  EXPECT_EQ(pending_errors(*gl), "");
}

TEST_P(EachContext, IsACoreProfile) {
  const ContextResult context = open_context(GetParam());
  ASSERT_TRUE(context.ok()) << context.error();
  const Result<Gl> gl = Gl::load(**context);
  ASSERT_TRUE(gl.ok()) << gl.error();
  GLint profile = 0;
  gl->GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST_P(EachContext, MeetsTheLimitsWeBuildOn) {
  const ContextResult context = open_context(GetParam());
  ASSERT_TRUE(context.ok()) << context.error();
  const Result<Gl> gl = Gl::load(**context);
  ASSERT_TRUE(gl.ok()) << gl.error();
  const GlLimits found = limits(*gl);
  EXPECT_GE(found.samples, 4);
  EXPECT_GE(found.renderbuffer_side, 3840) << "4K";
  EXPECT_GE(found.texture_side, 3840);
  EXPECT_THAT(driver_name(*gl), HasSubstr("; "));
}

// HOSTILE F16: both ended the program within Mesa.
TEST(Context, ADriverThatOsmesaLacksIsAnError) {
  ::setenv("GALLIUM_DRIVER", "nonsense", 1);
  const ContextResult context = open_context(ContextKind::osmesa);
  ::unsetenv("GALLIUM_DRIVER");
  ASSERT_FALSE(context.ok());
  EXPECT_THAT(context.error(), AllOf(HasSubstr("\"nonsense\""), HasSubstr("llvmpipe")));
}

TEST(Context, TooLittleMemoryIsAnError) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer has terabytes of addresses, and ends a program that gets no more of them";
#endif
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  rlimit less = before;
  less.rlim_cur = 500 << 20;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &less), 0);
  const ContextResult context = open_context(ContextKind::any);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  ASSERT_FALSE(context.ok());
  EXPECT_THAT(context.error(), AllOf(HasSubstr("500 MiB"), HasSubstr("ulimit -v")));
}

TEST(Context, ManyOpenOneAfterAnother) {
  for (int round = 0; round < 5; ++round)
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
      const ContextResult context = open_context(kind);
      ASSERT_TRUE(context.ok()) << context.error();
      const Result<Gl> gl = Gl::load(**context);
      ASSERT_TRUE(gl.ok()) << gl.error();
      EXPECT_NE(gl->GetString(GL_VERSION), nullptr) << "not current";
    }
}

TEST(Context, AnyPrefersOsmesa) {
  const ContextResult context = open_context(ContextKind::any);
  ASSERT_TRUE(context.ok()) << context.error();
  EXPECT_EQ(kind_of_current(), ContextKind::osmesa);
}

TEST(Context, AMissingLibraryIsNamedWithItsPackage) {
  const ContextResult osmesa = open_osmesa("libOSMesa-of-no-one.so.8");
  ASSERT_FALSE(osmesa.ok());
  EXPECT_THAT(osmesa.error(),
              AllOf(HasSubstr("libOSMesa-of-no-one.so.8"),
                    HasSubstr("Install the package libosmesa6, which Debian has up to release 13.")));
  const ContextResult egl = open_egl("libEGL-of-no-one.so.1");
  ASSERT_FALSE(egl.ok());
  EXPECT_THAT(egl.error(),
              AllOf(HasSubstr("libEGL-of-no-one.so.1"),
                    HasSubstr("Install the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri.")));
}

// Of the two, every release has EGL.
TEST(Context, AnyNamesBothFailuresEglFirst) {
  const ContextResult none = open_any("libOSMesa-of-no-one.so.8", "libEGL-of-no-one.so.1");
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error(), AllOf(HasSubstr("libosmesa6"), HasSubstr("libegl-mesa0")));
  EXPECT_LT(none.error().find("libegl-mesa0"), none.error().find("libosmesa6"));
}

TEST(Context, AnyFallsBackToEgl) {
  const ContextResult context = open_any("libOSMesa-of-no-one.so.8", kEglLibrary);
  ASSERT_TRUE(context.ok()) << context.error();
  EXPECT_EQ(kind_of_current(), ContextKind::egl);
}

TEST(Context, ALibraryWithoutTheFunctionsIsRefused) {
  for (const ContextResult& context : {open_osmesa("libc.so.6"), open_egl("libc.so.6")}) {
    ASSERT_FALSE(context.ok());
    EXPECT_THAT(context.error(), AllOf(HasSubstr("libc.so.6"), HasSubstr("lacks")));
  }
}

// A context of strings instead of a driver.
class FakeContext final : public GlContext {
 public:
  static const char* version;
  static const GLubyte* APIENTRY get_string(GLenum) { return reinterpret_cast<const GLubyte*>(version); }
  void* function(const char* name) const override {
    return std::string(name) == "glGetString" ? reinterpret_cast<void*>(&get_string) : nullptr;
  }
};
const char* FakeContext::version = nullptr;

TEST(Context, OlderVersionsAreRefusedWithBothVersionsNamed) {
  const FakeContext fake;
  for (const char* version : {"3.3 Mesa", "3.3.0", "4.0", "4.6.0 NVIDIA 535"}) {
    FakeContext::version = version;
    EXPECT_TRUE(check_version(fake, "lib").ok()) << version;
  }
  for (const char* version : {"3.2", "2.1 Mesa 22", "OpenGL ES 3.2", ""}) {
    FakeContext::version = version;
    const Status checked = check_version(fake, "libOld");
    ASSERT_FALSE(checked.ok()) << version;
    EXPECT_THAT(checked.error(), AllOf(HasSubstr("libOld"), HasSubstr(version), HasSubstr("3.3")));
  }
  FakeContext::version = nullptr;
  EXPECT_FALSE(check_version(fake, "libOld").ok());
}

TEST(Functions, AMissingFunctionIsNamed) {
  const Result<Gl> gl = Gl::load(FakeContext());
  ASSERT_FALSE(gl.ok());
  EXPECT_THAT(gl.error(), AllOf(HasSubstr("glDrawArrays"), HasSubstr("glReadPixels")));
  EXPECT_THAT(gl.error(), testing::Not(HasSubstr("glGetString,")));
}

TEST(Functions, PendingErrorsAreNamedAndForgotten) {
  const ContextResult context = open_context(ContextKind::any);
  ASSERT_TRUE(context.ok()) << context.error();
  const Result<Gl> gl = Gl::load(**context);
  ASSERT_TRUE(gl.ok()) << gl.error();
  gl->Enable(0xFFFF);
  EXPECT_EQ(pending_errors(*gl), "GL_INVALID_ENUM");
  EXPECT_EQ(pending_errors(*gl), "");
}

}  // namespace
}  // namespace polhode
