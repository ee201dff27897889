// SPDX-License-Identifier: MIT
// How the program for pages comes into them; what it does there: live_browser_test.cpp.
#include "app/publish/live/live_program.h"

#include "app/publish/html_text.h"
#include "tests/app/publish/reader/example_edition.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace polhode {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// A folder with something under the names of the program.
void put_program(const fs::path& folder, const std::string& script) {
  fs::create_directories(folder);
  write_text(folder / "polhode.wasm", std::string("\0asm", 4) + std::string(5000, 'x'));
  write_text(folder / "polhode.js", script);
}

TEST(LiveProgram, IsTakenFromTheFirstFolderThatHasIt) {
  const ScratchFolder folder;
  put_program(folder / "second", "second()");
  put_program(folder / "third", "third()");
  const auto program = read_live_program({folder / "first", folder / "second", folder / "third"});
  ASSERT_TRUE(program) << program.error().text;
  EXPECT_EQ(program->script, "second()");
  EXPECT_LT(program->wasm.size(), 200U);
  EXPECT_EQ(live_policy(*program), policy_hash("second()") + " 'wasm-unsafe-eval'");
}

TEST(LiveProgram, IsRefusedIfItsScriptWouldEndItsElement) {
  const ScratchFolder folder;
  put_program(folder.path(), "'</script>'");
  EXPECT_FALSE(read_live_program({folder.path()}));
}

// What is packed is data of a page, whatever it says, and gzip(1) gives it back.
TEST(LiveProgram, PackedTextCannotEndItsElementAndComesBack) {
  const std::string text = "</script><!-- <script> \u00e4 & ω\n";
  const std::string packed = packed_for_page(text);
  EXPECT_EQ(packed.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/="),
            std::string::npos);
  const ScratchFolder folder;
  write_text(folder / "packed", packed);
  const std::string command =
      "base64 -d " + (folder / "packed").string() + " | gzip -dc > " + (folder / "text").string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(text_of(folder / "text"), text);
}

TEST(LiveProgram, WhereItIsMissingOneMessageSaysHowToBuildIt) {
  const ScratchFolder folder;
  write_text(folder / "edition.md", kEditionLesson);
  const std::string page = (folder / "page.html").string();
  RunOptions nowhere;
  nowhere.environment["POLHODE_WEB"] = (folder / "none").string();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"export", (folder / "edition.md").string(), "--live", "--reader", page},
        std::vector<std::string>{"export", "--sandbox", page}}) {
    const ProgramRun run = polhode(words, nowhere);
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, AllOf(HasSubstr("polhode.wasm"), HasSubstr("./web")));
    EXPECT_FALSE(fs::exists(page));
  }
}

TEST(LiveProgram, OnlyALivePageHasIt) {
  const ScratchFolder folder;
  put_program(folder / "web", "var createPolhode;");
  write_text(folder / "edition.md", kEditionLesson);
  const auto page = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"export", (folder / "edition.md").string(), "--reader",
                                      (folder / "page.html").string()};
    words.insert(words.end(), more.begin(), more.end());
    RunOptions there;
    there.environment["POLHODE_WEB"] = (folder / "web").string();
    const ProgramRun run = polhode(words, there);
    EXPECT_EQ(run.code, 0) << run.err;
    return text_of(folder / "page.html");
  };
  EXPECT_THAT(page({}), AllOf(Not(HasSubstr("wasm")), Not(HasSubstr("data-stage"))));
  EXPECT_THAT(
      page({"--live"}),
      AllOf(HasSubstr("'wasm-unsafe-eval'"), HasSubstr("<figure data-stage=\"moves\" data-step=\"1\">"),
            HasSubstr("<figcaption data-computed>"), HasSubstr("<script>var createPolhode;</script>")));
}

TEST(LiveProgram, OptionsThatDoNotGoWithAPageAreRefused) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"export", "--sandbox", "a.txt"},
                                                {"export", "--sandbox", "a.html", "--stage", "x"},
                                                {"export", "euler-equations", "--sandbox", "a.html"},
                                                {"export", "euler-equations", "--live", "-o", "a"},
                                                {"export"}}) {
    const ProgramRun run = polhode(words);
    EXPECT_EQ(run.code, 2) << testing::PrintToString(words) << run.err;
  }
}

}  // namespace
}  // namespace polhode
