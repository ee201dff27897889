// SPDX-License-Identifier: MIT
// The sources as they are keep the rules of rules.h.
#include "tests/layers/rules.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

namespace polhode::layers {
namespace {

namespace fs = std::filesystem;

struct Source {
  std::string path;  ///< relative to the repository
  std::string text;
};

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Every file of ours whose name ends in one of `endings`.
std::vector<Source> sources(const std::vector<std::string>& endings) {
  const fs::path root = test::source_dir();
  std::vector<Source> found;
  for (const char* folder :
       {"app", "assets", "base", "cmake", "examples", "lessons", "physics", "render", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string path = fs::relative(entry.path(), root).generic_string();
      const auto ends = [&](const std::string& ending) { return path.ends_with(ending); };
      if (entry.is_regular_file() && std::ranges::any_of(endings, ends)) {
        found.push_back({path, text_of(entry.path())});
      }
    }
  }
  return found;
}

TEST(Sources, KeepTheArrowsBetweenTheRooms) {
  const std::vector<Source> files = sources({".h", ".cpp"});
  ASSERT_GT(files.size(), 40u) << "looked in " << test::source_dir();
  for (const Source& file : files) {
    for (const Finding& finding : broken_rules(file.path, file.text)) {
      ADD_FAILURE() << finding.file << ':' << finding.line << ": " << finding.message;
    }
  }
}

std::map<std::string, std::string> texts_by_path() {
  std::map<std::string, std::string> files;
  for (Source& file : sources({".h", ".cpp"})) files.emplace(std::move(file.path), std::move(file.text));
  return files;
}

TEST(Sources, KeepTheArrowsThroughTheirHeaders) {
  for (const Finding& finding : broken_closures(texts_by_path()))
    ADD_FAILURE() << finding.file << ':' << finding.line << ": " << finding.message;
}

// 2026-11-28: two headers had a kNotDefined, in other words each, and the linker took either.
TEST(Sources, DefineEachPhraseOnce) {
  static const std::regex kDefined(R"(\b(k[A-Z]\w*)(\{| =|\[))");
  std::map<std::string, std::string> where;
  for (const Source& file : sources({".h"})) {
    if (!file.path.starts_with("base/words/")) continue;
    for (std::sregex_iterator name(file.text.begin(), file.text.end(), kDefined), end; name != end; ++name) {
      const auto [first, is_new] = where.emplace((*name)[1].str(), file.path);
      EXPECT_TRUE(is_new) << (*name)[1] << " stands in " << first->second << " and in " << file.path;
    }
  }
  EXPECT_GT(where.size(), 100u) << "looked in " << test::source_dir();
}

// 2026-11-29: beside a German lesson half of the window was English. What it says stands in base/words/; of
// the table of keys, which is English, and ids nothing does.
TEST(Sources, OfPanelsHaveNoWordsOfTheirOwn) {
  static const std::regex kWords("\"[^\"\\n]*[A-Za-z]{2,} [a-z]{2,}[^\"\\n]*\"");
  static const std::set<std::string> kKnown = {"\"frame back\"", "\"frame forward\"", "\"polhode play \"",
                                               "\"Not computed: \""};
  int looked_at = 0;
  for (const Source& file : sources({".cpp"})) {
    const bool is_panel =
        file.path.starts_with("app/window/panels/") && !file.path.ends_with("help_panel.cpp");
    if (!is_panel && !file.path.starts_with("app/window/speaker/")) continue;
    ++looked_at;
    for (std::sregex_iterator text(file.text.begin(), file.text.end(), kWords), end; text != end; ++text) {
      const auto at = static_cast<std::size_t>(text->position());
      const std::size_t comment = file.text.rfind("//", at);
      const bool is_in_comment = comment != std::string::npos && comment > file.text.rfind('\n', at);
      EXPECT_TRUE(is_in_comment || kKnown.contains(text->str())) << file.path << ": " << text->str();
    }
  }
  EXPECT_GT(looked_at, 10);
}

TEST(Sources, FollowEachArrow) {
  for (const Finding& finding : unused_arrows(texts_by_path()))
    ADD_FAILURE() << finding.file << ": " << finding.message;
}

TEST(Sources, DefineEachTypeInOneHeader) {
  const std::map<std::string, std::string> files = texts_by_path();
  std::size_t count = 0;
  for (const auto& [path, text] : files) count += types_of(text).size();
  EXPECT_GT(count, 500u) << "of " << files.size() << " files";
  for (const Finding& finding : doubled_types(files))
    ADD_FAILURE() << finding.file << ": " << finding.message << ": give one of them another name";
}

// A test that no target has passes for ever.
TEST(Sources, OfTestsAreBuilt) {
  std::string listed;
  for (const Source& list : sources({"CMakeLists.txt"}))
    if (list.path.starts_with("tests/")) listed += list.text;
  std::size_t count = 0;
  for (const Source& file : sources({"_test.cpp"})) {
    ++count;
    const std::string name = fs::path(file.path).filename().string();
    const auto is_listed = [&](char before) { return listed.find(before + name) != listed.npos; };
    EXPECT_TRUE(is_listed(' ') || is_listed('/')) << file.path << " is in no CMakeLists.txt";
  }
  EXPECT_GT(count, 200u);
}

TEST(Sources, AreFewInEachFolder) {
  constexpr int kMost = 30;  // as many as are taken in at a glance, in the list that an editor shows
  std::map<std::string, int> counts;
  for (const Source& file : sources({".h", ".cpp", ".vert", ".frag", ".glsl"}))
    ++counts[fs::path(file.path).parent_path().generic_string()];
  for (const auto& [folder, count] : counts)
    EXPECT_LE(count, kMost) << folder << ": give files that belong together a folder of their own";
}

// What a claim comes to depends on the lesson alone: whoever sets text, again and again, reads it there.
// Nothing is proved without a Prover.
TEST(Sources, OfTheProgramProveWhenALessonIsLoadedAndWhenAnAnswerIsJudged) {
  const std::set<std::string> provers = {"app/cli/commands/answer.cpp", "app/session/answers/answer_check.h",
                                         "app/session/answers/derivation_work.h",
                                         "app/session/lesson_session.cpp"};
  static const std::regex kProof(R"(\b(Prover|prove_claims)\b)");
  std::set<std::string> found;
  for (const Source& file : sources({".h", ".cpp"}))
    if (file.path.starts_with("app/") && std::regex_search(code_of(file.text), kProof))
      found.insert(file.path);
  EXPECT_EQ(found, provers) << "a proof takes milliseconds: not where text is set";
}

TEST(Sources, OfThePhysicsAreInTheIndex) {
  const std::string index = text_of(fs::path(test::source_dir()) / "physics/README.md");
  for (const Source& file : sources({".h"})) {
    constexpr std::string_view kRoom = "physics/",
                               kPublic = "physics/public/";  // these are named as public/*.h
    if (!file.path.starts_with(kRoom) || file.path.starts_with(kPublic)) continue;
    const std::string name = '`' + file.path.substr(kRoom.size()) + '`';
    EXPECT_NE(index.find(name), index.npos) << "physics/README.md does not name " << name;
  }
}

TEST(Sources, NameTheColoursOfRoles) {
  const std::string palette = text_of(fs::path(test::source_dir()) / "render/palette.h");
  static const std::regex kRole(R"(Role\{color_from_hex\((0x\w+)\),\s*color_from_hex\((0x\w+)\))");
  std::set<std::string> colours;
  for (std::sregex_iterator at(palette.begin(), palette.end(), kRole), end; at != end; ++at)
    colours.insert({(*at)[1].str(), (*at)[2].str()});
  ASSERT_GT(colours.size(), 20u) << "of 7 quantities, 3 axes and 3 marks, two each, but some the same";
  for (const Source& file : sources({".h", ".cpp"})) {
    if (file.path.starts_with("tests/") || file.path == "render/palette.h") continue;
    for (const std::string& colour : colours)
      EXPECT_EQ(file.text.find("color_from_hex(" + colour), file.text.npos)
          << file.path << " types " << colour << ", which a role of render/palette.h has";
  }
}

TEST(Sources, NameTheirLicence) {
  std::vector<Source> files = sources({".h", ".cpp", ".vert", ".frag", ".glsl", ".sh", ".py", ".js", ".css",
                                       ".cmake", "CMakeLists.txt", "packages.txt"});
  const fs::path root = test::source_dir();
  for (const char* path : {"CMakeLists.txt", "play", "check", ".ci/run"})
    files.push_back({path, text_of(root / path)});
  for (const Source& file : files) {
    EXPECT_TRUE(names_licence(file.text)) << file.path << " does not begin with SPDX-License-Identifier: MIT";
  }
}

}  // namespace
}  // namespace polhode::layers
