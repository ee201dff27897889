// SPDX-License-Identifier: MIT
// The rules refuse what they are there to refuse: every arrow that must not exist, made up.
#include "tests/layers/rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode::layers {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> messages(const std::string& path, std::string_view text) {
  std::vector<std::string> all;
  for (const Finding& finding : broken_rules(path, text)) {
    all.push_back(std::to_string(finding.line) + ": " + finding.message);
  }
  return all;
}

TEST(Includes, AreReadWithTheirLines) {
  EXPECT_THAT(
      includes_of(
          "// one\n#include \"physics/body/state.h\"\n\n  #  include <vector>\n#include FT_FREETYPE_H\n"),
      ElementsAre(Include{"physics/body/state.h", 2}, Include{"vector", 4}, Include{"FT_FREETYPE_H", 5}));
}

TEST(Includes, InCommentsAndTextAreNone) {
  EXPECT_THAT(
      includes_of("// #include <a>\n/*\n#include <b>\n*/\nauto t = R\"(\n#include <c>\n)\";\n#include <d>"),
      ElementsAre(Include{"d", 8}));
}

TEST(Code, KeepsLinesAndBlanksCommentsAndLiterals) {
  EXPECT_EQ(code_of("int a = 1'000;  // exit(1)\nf(\"exit(\\\"1\", 'x');\n"),
            "int a = 1'000;            \nf(          ,    );\n");
}

struct Forbidden {
  const char* path;
  const char* include;
};
void PrintTo(const Forbidden& forbidden, std::ostream* out) {
  *out << forbidden.path << " <- " << forbidden.include;
}

class ForbiddenInclude : public testing::TestWithParam<Forbidden> {};

TEST_P(ForbiddenInclude, IsRefused) {
  const std::string name = GetParam().include;
  const bool is_ours =
      name.find('/') != name.npos && name.ends_with(".h") && !name.starts_with("G") && !name.starts_with("E");
  const std::string text = "#pragma once\n#include " + (is_ours ? '"' + name + '"' : '<' + name + '>') + '\n';
  EXPECT_THAT(messages(GetParam().path, text),
              ElementsAre(testing::AllOf(testing::StartsWith("2: "), testing::HasSubstr(name))));
}

INSTANTIATE_TEST_SUITE_P(
    Arrows, ForbiddenInclude,
    testing::Values(
        Forbidden{"base/result.h", "physics/body/types.h"}, Forbidden{"base/a.cpp", "fstream"},
        Forbidden{"physics/a.cpp", "render/scene/description/scene.h"},
        Forbidden{"physics/a.cpp", "lessons/reader/lesson.h"}, Forbidden{"physics/a.cpp", "fmt/format.h"},
        Forbidden{"physics/public/a.h", "physics/exact/elliptic.h"},
        Forbidden{"physics/public/a.h", "physics/integrators/checkpoints.h"},
        Forbidden{"physics/public/a.h", "base/files/atomic_file.h"},
        Forbidden{"examples/a.cpp", "physics/motion.h"}, Forbidden{"examples/a.cpp", "polhode/base/result.h"},
        Forbidden{"physics/a.cpp", "unistd.h"}, Forbidden{"physics/a.cpp", "fstream"},
        Forbidden{"render/scene/a.cpp", "render/figure/figure.h"},
        Forbidden{"render/scene/a.cpp", "render/gl/context/context.h"},
        Forbidden{"render/scene/a.cpp", "lessons/reader/lesson.h"},
        Forbidden{"render/scene/a.cpp", "GL/glcorearb.h"},
        Forbidden{"render/figure/a.cpp", "render/drawing/sheet.h"},
        Forbidden{"render/drawing/a.cpp", "render/figure/figure.h"},
        Forbidden{"render/typeset/a.cpp", "render/gl/context/context.h"},
        Forbidden{"render/typeset/a.cpp", "render/scene/description/scene.h"},
        Forbidden{"render/typeset/a.cpp", "physics/body/types.h"},
        Forbidden{"render/image/a.cpp", "render/gl/context/context.h"},
        Forbidden{"render/image/a.cpp", "render/scene/description/scene.h"},
        Forbidden{"render/image/a.cpp", "Eigen/Core"},
        Forbidden{"render/gl/a.cpp", "render/scene/description/scene.h"},
        Forbidden{"render/gl/a.cpp", "lessons/reader/lesson.h"},
        Forbidden{"render/gl/a.cpp", "physics/motion.h"},
        Forbidden{"render/gl/a.cpp", "app/cli/commands/commands.h"}, Forbidden{"render/gl/a.cpp", "iostream"},
        Forbidden{"render/gl/a.cpp", "GLFW/glfw3.h"},
        Forbidden{"lessons/diagnostics/a.cpp", "lessons/claims/claim.h"},
        Forbidden{"lessons/claims/a.cpp", "lessons/reader/lesson.h"},
        Forbidden{"lessons/claims/a.cpp", "render/typeset/rich_text.h"},
        Forbidden{"lessons/reader/a.cpp", "render/gl/context/context.h"},
        Forbidden{"lessons/reader/a.cpp", "render/image/image.h"},
        Forbidden{"lessons/reader/a.cpp", "filesystem"},
        Forbidden{"lessons/reader/a.cpp", "nlohmann/json.hpp"},
        Forbidden{"lessons/reader/a.cpp", "CLI/CLI.hpp"},
        Forbidden{"app/cli/commands/export.cpp", "GLFW/glfw3.h"},
        Forbidden{"app/narration/a.cpp", "app/page/page.h"},
        Forbidden{"app/narration/a.cpp", "render/drawing/sheet.h"},
        Forbidden{"app/page/a.cpp", "app/export/folder/manifest.h"},
        Forbidden{"app/page/a.cpp", "app/cli/exit_codes.h"},
        Forbidden{"app/export/a.cpp", "app/cli/exit_codes.h"},
        Forbidden{"app/export/a.cpp", "app/session/lesson_session.h"},
        Forbidden{"app/export/a.cpp", "CLI/CLI.hpp"},
        Forbidden{"app/publish/a.cpp", "app/session/lesson_session.h"},
        Forbidden{"app/session/a.cpp", "app/cli/exit_codes.h"}, Forbidden{"app/session/a.cpp", "imgui.h"},
        Forbidden{"app/web/a.cpp", "app/export/picture_writer.h"},
        Forbidden{"app/web/a.cpp", "render/image/png.h"}, Forbidden{"app/web/a.cpp", "thread"},
        Forbidden{"app/web/a.cpp", "filesystem"}, Forbidden{"app/web/a.cpp", "imgui.h"},
        Forbidden{"app/window/a.cpp", "app/cli/exit_codes.h"},
        Forbidden{"app/window/a.cpp", "app/publish/deck.h"},
        Forbidden{"app/window/panels/a.cpp", "GLFW/glfw3.h"},
        Forbidden{"app/window/screen/screen.cpp", "GLFW/glfw3.h"},
        Forbidden{"app/window/screen/screen.h", "backends/imgui_impl_glfw.h"},
        Forbidden{"app/cli/commands/export.cpp", "imgui.h"},
        Forbidden{"app/cli/commands/export.cpp", "GL/glcorearb.h"},
        Forbidden{"app/cli/commands/export.cpp", "tests/layers/rules.h"},
        Forbidden{"tests/app/a.cpp", "GLFW/glfw3.h"}),
    [](const auto& tested) {
      std::string name = std::string(tested.param.path) + "_" + tested.param.include;
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return name;
    });

TEST(AllowedInclude, PassesInEachRoom) {
  const auto passes = [](const std::string& path, std::string_view text) {
    EXPECT_THAT(messages(path, text), IsEmpty()) << path;
  };
  passes("physics/a.cpp", "#include \"physics/body/types.h\"\n#include <Eigen/Core>\n#include <vector>\n");
  passes("render/scene/a.cpp", "#include \"physics/body/types.h\"\n#include \"base/result.h\"\n");
  passes("render/typeset/a.cpp", "#include <ft2build.h>\n#include FT_FREETYPE_H\n");
  passes("render/image/a.cpp", "#include <png.h>\n#include \"base/files/atomic_file.h\"\n");
  passes("render/gl/a.cpp", "#include \"render/figure/figure.h\"\n#include <EGL/egl.h>\n");
  passes("lessons/reader/a.cpp", "#include \"render/scene/description/scene.h\"\n#include <toml++/toml.h>\n");
  passes("app/window/window_context.cpp", "#include <GLFW/glfw3.h>\n#include <imgui.h>\n");
  passes("app/cli/a.cpp", "#include \"render/gl/context/context.h\"\n#include <iostream>\n");
}

// Each include by itself is allowed; what it leads to is not.
TEST(Closure, IsFollowedThroughHeaders) {
  const std::map<std::string, std::string> sources = {
      {"physics/motion.h", "#pragma once\n"},
      {"render/drawing/plot.h", "#pragma once\n\n#include \"physics/motion.h\"\n"},
      {"render/drawing/sheet.h", "#pragma once\n#include \"render/drawing/plot.h\"\n"},
      {"render/gl/renderer.h", "#pragma once\n#include <vector>\n#include \"render/drawing/sheet.h\"\n"}};
  for (const auto& [path, text] : sources) EXPECT_THAT(messages(path, text), IsEmpty()) << path;
  const std::vector<Finding> found = broken_closures(sources);
  ASSERT_THAT(found, testing::SizeIs(1));
  EXPECT_EQ(found[0].file, "render/gl/renderer.h");
  EXPECT_EQ(found[0].line, 3);
  EXPECT_EQ(
      found[0].message,
      "render/gl/ may not reach render/gl/renderer.h -> render/drawing/sheet.h -> render/drawing/plot.h "
      "-> physics/motion.h");
}

// What a user of the library includes leads to no formula's private parts.
TEST(Closure, OfThePublicHeadersStaysOutOfTheFormulas) {
  const std::vector<Finding> found = broken_closures(
      {{"physics/public/errors.h", "#pragma once\n#include \"physics/analysis/conditioning.h\"\n"},
       {"physics/analysis/conditioning.h", "#pragma once\n#include \"physics/exact/elliptic.h\"\n"},
       {"physics/exact/elliptic.h", "#pragma once\n"}});
  ASSERT_THAT(found, testing::SizeIs(1));
  EXPECT_EQ(found[0].message,
            "physics/public/ may not reach physics/public/errors.h -> physics/analysis/conditioning.h -> "
            "physics/exact/elliptic.h");
}

TEST(Closure, OfHeadersThatIncludeEachOtherEnds) {
  EXPECT_THAT(broken_closures({{"physics/a.h", "#include \"physics/b.h\"\n"},
                               {"physics/b.h", "#include \"physics/a.h\"\n"}}),
              IsEmpty());
}

TEST(Arrow, ThatNoFileFollowsIsReported) {
  std::map<std::string, std::string> sources = {
      {"render/drawing/a.cpp", "#include \"physics/motion.h\"\n#include \"render/typeset/rich_text.h\"\n"},
      {"render/typeset/rich_text.h", "#include \"base/colors.h\"\n"},
      {"render/palette.h", ""},
      {"render/scene/description/scene.h", ""},
      {"physics/motion.h", ""},
      {"base/colors.h", ""}};
  const auto messages = [&] {
    std::vector<std::string> all;
    for (const Finding& finding : unused_arrows(sources))
      if (finding.message.starts_with("render/drawing/")) all.push_back(finding.message);
    return all;
  };
  EXPECT_THAT(messages(), ElementsAre("render/drawing/ may see render/palette.h, and does not",
                                      "render/drawing/ may see render/scene/, and does not"));
  sources["physics/motion.h"] = "#include \"render/scene/description/scene.h\"\n";
  sources["render/drawing/b.h"] = "#include \"render/palette.h\"\n";
  EXPECT_THAT(messages(), IsEmpty()) << "through a header, or by a header of the room";
}

TEST(Library, NeitherPrintsNorExits) {
  for (const std::string call :
       {"std::cout << 1;", "std::cerr << 1;", "printf(\"\");", "std::fprintf(stderr, \"\");", "puts(\"\");",
        "exit(1);", "std::exit (1);", "::_exit(1);", "std::abort();"}) {
    EXPECT_THAT(messages("physics/a.cpp", "void f() {\n  " + call + "\n}\n"), testing::SizeIs(1)) << call;
    EXPECT_THAT(messages("app/cli/a.cpp", "void f() {\n  " + call + "\n}\n"), IsEmpty()) << call;
  }
}

TEST(Library, MayWriteIntoTextAndHaveMembersOfTheseNames) {
  EXPECT_THAT(
      messages("render/gl/a.cpp", "snprintf(b, 9, \"%d\", 1);\nscope.exit();\np->abort();\non_exit(f);\n"),
      IsEmpty());
}

TEST(Header, NeedsPragmaOnce) {
  EXPECT_THAT(messages("physics/a.h", "int f();\n"), testing::SizeIs(1));
  EXPECT_THAT(messages("physics/a.h", "#pragma once\nint f();\n"), IsEmpty());
}

TEST(File, OutsideEveryRoomIsRefused) { EXPECT_THAT(messages("util/a.cpp", ""), testing::SizeIs(1)); }

TEST(Types, AreThoseOfNamespacesThatHaveAName) {
  EXPECT_THAT(
      types_of(R"(
#define OPEN {
namespace polhode {
struct Declared;
enum class Early : int;
struct Plain { struct Inner {}; using Alias = int; };
class Derived final : public std::vector<Plain> {};
template <class T, int N = 3>
struct Templated {};
enum class Kind : char { a, b };
enum Old { c };
template <class T>
using Alias = std::array<T, 3>;
inline Plain made(struct Declared* from) { struct Local {}; return {}; }
template <class T> T made() { return {}; }
const Plain kPlain = {};
// struct Commented {};
namespace { struct Hidden {}; }
namespace builders { struct Deep {}; }
}
namespace polhode::layers { union Both { int a; char b; }; }
)"),
      ElementsAre("polhode::Plain", "polhode::Derived", "polhode::Templated", "polhode::Kind", "polhode::Old",
                  "polhode::Alias", "polhode::builders::Deep", "polhode::layers::Both"));
}

TEST(Types, OfOneNameInTwoHeadersAreReported) {
  const std::map<std::string, std::string> sources = {
      {"app/a.h", "namespace polhode {\nenum class Command { quit };\nstruct Other {};\n}\n"},
      {"app/b.h", "namespace polhode {\nstruct Command {\n  int code;\n};\n}\n"},
      {"app/c.h", "namespace polhode::cli {\nstruct Command {};\n}\nnamespace polhode {\nstruct Other;\n}\n"},
      {"app/d.cpp", "namespace polhode {\nstruct Other {};\n}\n"}};
  const std::vector<Finding> found = doubled_types(sources);
  ASSERT_THAT(found, testing::SizeIs(1));
  EXPECT_EQ(found[0].file, "app/b.h");
  EXPECT_EQ(found[0].message, "polhode::Command is defined in app/a.h too");
}

TEST(Licence, IsNamedOnTheFirstLineOrBelowTheShebang) {
  EXPECT_TRUE(names_licence("// SPDX-License-Identifier: MIT\n"));
  EXPECT_TRUE(names_licence("#!/bin/sh\n# SPDX-License-Identifier: MIT\n"));
  EXPECT_FALSE(names_licence(""));
  EXPECT_FALSE(names_licence("\n// SPDX-License-Identifier: MIT\n"));
  EXPECT_FALSE(names_licence("// SPDX-License-Identifier: GPL-3.0\n"));
}

}  // namespace
}  // namespace polhode::layers
