// SPDX-License-Identifier: MIT
// How the program for pages comes into them; what it does there: live_browser_test.cpp.
#include "app/publish/live/live_program.h"

#include "app/publish/html_text.h"
#include "app/publish/live/live_assets.h"
#include "base/words/live_words.h"
#include "tests/app/publish/text_edition/example_edition.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <regex>
#include <set>

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
  EXPECT_EQ(program->script, packed_for_page("second()"));
  EXPECT_LT(program->wasm.size(), 200U);
  EXPECT_EQ(live_policy({*program, ""}), policy_hash("second()") + " 'wasm-unsafe-eval'");
}

// Beside pages: each names it, none has it, and its name is another when its text is.
TEST(LiveProgram, LiesBesidePagesAsAScript) {
  const LiveProgram program{"a\\b\"c", "'sha256-x'", "d~e"};
  const LiveFile file = live_file(program);
  EXPECT_EQ(file.text, "polhodeLive.hold({\"polhode.wasm\": \"d~e\", \"polhode.js\": \"a\\\\b\\\"c\"});\n");
  EXPECT_THAT(file.name, testing::MatchesRegex("polhode-[0-9a-f]{12}\\.js"));
  EXPECT_NE(file.name, live_file({"a", "'sha256-x'", "d~e"}).name);
  const LiveParts parts{program, "text", file.name};
  EXPECT_THAT(
      live_elements(parts, Language::en),
      AllOf(HasSubstr(packed_for_page("text")), HasSubstr(file.name), Not(HasSubstr("polhode.wasm"))));
  EXPECT_EQ(live_policy(parts), "'sha256-x' 'wasm-unsafe-eval' 'strict-dynamic'");
}

// A word that is asked for under another name would be "undefined" on the page.
TEST(LiveProgram, HasTheWordsThatTheScriptsOfPagesAskFor) {
  const std::string script = std::string(live_assets::kLiveJs) + live_assets::kFiguresJs;
  std::set<std::string> asked, there = {"decimal"};
  const std::regex use(R"(\bwords\.(\w+))");
  for (std::sregex_iterator found(script.begin(), script.end(), use), end; found != end; ++found)
    if ((*found).prefix().str().back() != '.') asked.insert((*found)[1]);  // `this.words` is the program's
  for (const NamedPhrase& phrase : words::kLive) there.emplace(phrase.name);
  EXPECT_EQ(asked, there);
}

TEST(LiveProgram, SpeaksThePagesLanguage) {
  const LiveParts parts{{"script", "hash", "wasm"}, "text"};
  EXPECT_THAT(live_elements(parts, Language::en),
              AllOf(HasSubstr(R"("decimal":".")"), HasSubstr("Copy link")));
  EXPECT_THAT(live_elements(parts, Language::de),
              AllOf(HasSubstr(R"("decimal":",")"), HasSubstr("Link kopieren"), Not(HasSubstr("Copy link"))));
  EXPECT_THAT(live_without_script(Language::de), HasSubstr("Die Abbildungen sind hier Bilder."));
}

/// The bytes of packed text, as the page's script reads them.
std::string bytes_of_text(const std::string& text) {
  std::string bytes;
  std::uint64_t bits = 0;
  int count = 0;
  const auto digit = [&](std::size_t i) { return text[i] == '~' ? '<' - '!' : text[i] - '!'; };
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const bool is_pair = i + 1 < text.size();
    bits = is_pair ? bits << 13 | static_cast<std::uint64_t>(digit(i) * 93 + digit(i + 1))
                   : bits << 6 | static_cast<std::uint64_t>(digit(i));
    for (count += is_pair ? 13 : 6; count >= 8; count -= 8)
      bytes += static_cast<char>(bits >> (count - 8) & 0xFF);
  }
  return bytes;
}

// What is packed is data of a page, whatever it says, and gzip(1) gives it back, however many bits are left
// over at the end; gzip complains of a byte too many.
TEST(LiveProgram, PackedTextCannotEndItsElementAndComesBack) {
  const ScratchFolder folder;
  std::set<std::size_t> lengths;  // of what gzip takes, by what 13 bits leave
  std::string text = "</script><!-- <script> \u00e4 & ω\n";
  for (int i = 0; i < 60; ++i) {
    const std::string packed = packed_for_page(text);
    for (const char c : packed) ASSERT_TRUE(c > ' ' && c < '\x7f' && c != '<') << packed;
    const std::string bytes = bytes_of_text(packed);
    lengths.insert(bytes.size() % 13);
    write_text(folder / "packed", bytes);
    const std::string command =
        "gzip -dc < " + (folder / "packed").string() + " > " + (folder / "text").string();
    ASSERT_EQ(std::system(command.c_str()), 0) << i;
    EXPECT_EQ(text_of(folder / "text"), text);
    text += static_cast<char>('!' + i * 37 % 90);
  }
  EXPECT_EQ(lengths.size(), 13U);
}

TEST(LiveProgram, WhereItIsMissingOneMessageSaysHowToBuildIt) {
  const ScratchFolder folder;
  write_text(folder / "edition.md", kEditionLesson);
  const std::string page = (folder / "page.html").string();
  RunOptions nowhere;
  nowhere.environment["POLHODE_WEB"] = (folder / "none").string();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"export", (folder / "edition.md").string(), "--live", "--reader", page},
        std::vector<std::string>{"export", (folder / "edition.md").string(), "--live", "--deck", page},
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
  EXPECT_THAT(page({}), AllOf(Not(HasSubstr("wasm")), Not(HasSubstr("data-stage=\""))));
  EXPECT_THAT(
      page({"--live"}),
      AllOf(HasSubstr("'wasm-unsafe-eval'"), HasSubstr("<figure data-stage=\"moves\" data-step=\"1\">"),
            HasSubstr("<figcaption data-computed>"),
            HasSubstr("id=\"polhode.js\">" + packed_for_page("var createPolhode;") + "</script>")));
}

// Of a deck the slides with a figure have one that is pressed, and the others are pictures.
TEST(LiveProgram, ADeckHasItIfItIsLive) {
  const ScratchFolder folder;
  put_program(folder / "web", "var createPolhode;");
  write_text(folder / "edition.md", kEditionLesson + std::string("# Words alone {words}\nNo figure.\n"));
  const auto deck = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"export", (folder / "edition.md").string(),
                                      "--deck", (folder / "deck.html").string(),
                                      "--size", "480x270"};
    words.insert(words.end(), more.begin(), more.end());
    RunOptions there;
    there.environment["POLHODE_WEB"] = (folder / "web").string();
    const ProgramRun run = polhode(words, there);
    EXPECT_EQ(run.code, 0) << run.err;
    return text_of(folder / "deck.html");
  };
  EXPECT_THAT(deck({}), AllOf(Not(HasSubstr("wasm")), Not(HasSubstr("<figure")), Not(HasSubstr("noscript"))));
  const std::string live = deck({"--live"});
  EXPECT_THAT(live,
              AllOf(HasSubstr("'wasm-unsafe-eval'"),
                    HasSubstr("<figure data-stage=\"moves\" data-step=\"1\" data-slide><img "),
                    HasSubstr("<figure data-stage=\"asked\" data-step=\"1\" data-slide><img "),
                    HasSubstr("The figures are pictures here"), Not(HasSubstr("data-stage=\"words\"")),
                    HasSubstr("id=\"polhode.js\">" + packed_for_page("var createPolhode;") + "</script>")));
}

TEST(LiveProgram, OptionsThatDoNotGoWithAPageAreRefused) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"export", "--sandbox", "a.txt"},
        {"export", "--sandbox", "a.html", "--stage", "x"},
        {"export", "euler-equations", "--sandbox", "a.html"},
        {"export", "euler-equations", "--live", "-o", "a"},
        {"export", "euler-equations", "--live", "--deck", "a.pdf"},
        {"export", "euler-equations", "--live", "--deck", "a.html", "--what", "figure"},
        {"export", "euler-equations", "--live", "--deck", "a.html", "--text-size", "1.2"},
        {"export"}}) {
    const ProgramRun run = polhode(words);
    EXPECT_EQ(run.code, 2) << testing::PrintToString(words) << run.err;
  }
}

}  // namespace
}  // namespace polhode
