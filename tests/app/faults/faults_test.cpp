// SPDX-License-Identifier: MIT
// Exports, decks, films and state files on disks that fail, at every operation on a file, one after the
// other, and killed at random times: nothing half-written has a final name, what fails is said, and what goes
// on ends with the bytes of one undisturbed run.
//
// ./check lets every 7th operation fail (of state files every one), from a place that depends on the kind,
// and kills some. All of them, and as many kills as one likes:
//   POLHODE_FAULTS=all POLHODE_KILLS=125 build/dev/tests/app/faults/fault_tests
#include "app/export/folder/export_folder.h"
#include "base/files/temporary_file.h"
#include "tests/app/faults/failing_files.h"
#include "tests/app/run_program.h"
#include "tests/base/files/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <thread>

namespace polhode {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;
using testing::HasSubstr;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  // its own library has to be loaded before any other
#else
constexpr bool kSanitized = false;
#endif

/// Relative path → bytes, of all files but those that a process leaves to be removed by the next.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && !is_temporary_name(entry.path().filename().string()))
      files[fs::relative(entry.path(), folder)] = text_of(entry.path());
  return files;
}

struct Work {
  const char* name;
  Words more;    ///< behind what all have in common; "@" is the folder
  bool is_film;  ///< needs ffmpeg
};

const Work kWorks[] = {
    {"pictures", {"--what", "figure", "--size", "48x27", "--each", "step"}, false},
    {"synced", {"--what", "figure", "--size", "48x27", "--stage", "rolling", "--sync", "frame"}, false},
    {"transcript", {"--what", "transcript"}, false},
    {"html", {"--size", "320x240", "--stage", "words", "--deck", "@/deck.html"}, false},
    {"pdf", {"--size", "320x240", "--stage", "words", "--deck", "@/deck.pdf"}, false},
    {"pptx", {"--size", "320x240", "--stage", "words", "--deck", "@/deck.pptx"}, false},
    {"film",
     {"--what", "figure", "--size", "48x27", "--each", "frame", "--fps", "3", "--seconds", "1", "--stage",
      "rolling", "--film", "@/film.gif"},
     true},
};

Words words_of(const Work& work, const fs::path& folder) {
  Words words = {"export", test_lesson("tiny.md"), "-o", folder, "--skip-existing"};
  for (const std::string& word : work.more)
    words.push_back(word.starts_with("@") ? folder.string() + word.substr(1) : word);
  return words;
}

bool has_ffmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

/// What an undisturbed run leaves, and how long it takes.
struct Whole {
  std::map<std::string, std::string> files;
  double takes_s = 0;
};

const Whole& whole_of(const Work& work) {
  static std::map<std::string, Whole> all;
  const auto [place, is_new] = all.try_emplace(work.name);
  if (!is_new) return place->second;
  const ScratchFolder scratch;
  const auto start = std::chrono::steady_clock::now();
  const ProgramRun run = polhode(words_of(work, scratch / "out"));
  EXPECT_EQ(run.code, 0) << run.err;
  place->second.takes_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  place->second.files = files_in(scratch / "out");
  return place->second;
}

/// Files of the undisturbed run are there as they are in it, or not at all.
void expect_nothing_half_written(const Work& work, const fs::path& folder) {
  const auto& whole = whole_of(work).files;
  for (const auto& [name, bytes] : files_in(folder))
    if (const auto found = whole.find(name); found != whole.end()) {
      EXPECT_TRUE(bytes == found->second) << name;
    }
}

/// Goes on without a fault, to the end.
void expect_to_end_whole(const Work& work, const fs::path& folder) {
  const ProgramRun run = polhode(words_of(work, folder));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(files_in(folder) == whole_of(work).files);
  EXPECT_TRUE(left_behind_in(folder).empty());
}

RunOptions failing(const fs::path& folder, long at, const fs::path& count) {
  RunOptions options;
  options.environment = {{"LD_PRELOAD", failing_files()},
                         {"POLHODE_FAULT_FOLDER", folder},
                         {"POLHODE_FAULT_AT", std::to_string(at)},
                         {"POLHODE_FAULT_COUNT", count}};
  return options;
}

bool fail_all() {
  const char* value = std::getenv("POLHODE_FAULTS");
  return value && std::string_view(value) == "all";
}

class Fault : public testing::TestWithParam<Work> {};

TEST_P(Fault, OfAnyOperationIsSaidAndLeavesNothingHalfWritten) {
  if (kSanitized) GTEST_SKIP() << "nothing can be loaded before a sanitizer";
  const Work& work = GetParam();
  if (work.is_film && !has_ffmpeg()) GTEST_SKIP() << "no ffmpeg is installed";
  const ScratchFolder counting;
  ASSERT_EQ(polhode(words_of(work, counting / "out"), failing(counting / "out", 0, counting / "count")).code,
            0);
  const long operations = std::atol(text_of(counting / "count").c_str());
  ASSERT_GT(operations, 10);
  const long step = fail_all() ? 1 : 7;
  int refused = 0;
  for (long at = 1 + (fail_all() ? 0 : static_cast<long>(std::string_view(work.name).size()) % step);
       at <= operations; at += step) {
    SCOPED_TRACE("operation " + std::to_string(at) + " of " + std::to_string(operations));
    const ScratchFolder scratch;
    const fs::path folder = scratch / "out";
    const ProgramRun run = polhode(words_of(work, folder), failing(folder, at, scratch / "count"));
    EXPECT_TRUE(run.code == 0 || run.code == 1) << run.code << ' ' << run.err;
    expect_nothing_half_written(work, folder);
    if (run.code == 0) {  // what has done its work may fail to be removed: the next run does that
      auto files = files_in(folder);
      files.erase(kMarkerName);
      EXPECT_TRUE(files == whole_of(work).files) << run.err;
    } else {
      EXPECT_THAT(run.err, HasSubstr("polhode: "));
      ++refused;
    }
    expect_to_end_whole(work, folder);
  }
  RecordProperty("operations", static_cast<int>(operations));
  EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Any, Fault, testing::ValuesIn(kWorks),
                         [](const auto& one) { return one.param.name; });

int kills() {
  const char* value = std::getenv("POLHODE_KILLS");
  return value ? std::atoi(value) : 8;
}

RunOptions killed_after(double seconds) {
  RunOptions options;
  options.while_running = [=](pid_t program) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    kill(program, SIGKILL);
  };
  return options;
}

class KilledAtAnyTime : public testing::TestWithParam<Work> {};

TEST_P(KilledAtAnyTime, GoesOnToTheBytesOfOneRun) {
  const Work& work = GetParam();
  if (work.is_film && !has_ffmpeg()) GTEST_SKIP() << "no ffmpeg is installed";
  const double takes_s = whole_of(work).takes_s;
  std::mt19937 random(static_cast<unsigned>(std::string_view(work.name).size()));
  constexpr int kOfOneFolder = 4;
  for (int n = 0; n < kills(); n += kOfOneFolder) {
    const ScratchFolder scratch;
    const fs::path folder = scratch / "out";
    for (int i = 0; i < kOfOneFolder; ++i) {
      polhode(words_of(work, folder), killed_after(std::uniform_real_distribution(0.0, takes_s)(random)));
      expect_nothing_half_written(work, folder);
    }
    expect_to_end_whole(work, folder);
  }
}

INSTANTIATE_TEST_SUITE_P(Export, KilledAtAnyTime, testing::ValuesIn(kWorks),
                         [](const auto& one) { return one.param.name; });

class LeftByTheDead : public testing::TestWithParam<Work> {};

// A transcript left it for ever: seen once in a thousand kills, for its files are written in an instant.
TEST_P(LeftByTheDead, GoesWithTheNextRun) {
  const Work& work = GetParam();
  if (work.is_film && !has_ffmpeg()) GTEST_SKIP() << "no ffmpeg is installed";
  const ScratchFolder scratch;
  fs::create_directory(scratch / "out");
  write_text(scratch / "out" / test::name_of_the_dead(), "half");
  expect_to_end_whole(work, scratch / "out");
}

INSTANTIATE_TEST_SUITE_P(Any, LeftByTheDead, testing::ValuesIn(kWorks),
                         [](const auto& one) { return one.param.name; });

/// Answers to one question, kept in a folder of state.
class StateFile : public testing::Test {
 protected:
  void SetUp() override {
    write_text(
        lesson_,
        "+++\nformat = 1\nid = \"quiz\"\ntitle = \"Quiz\"\n+++\n# Quiz {quiz}\nAsk.\n\n"
        "```ask which\ntype = \"choice\"\nprompt = 'Which?'\nchoices = ['one', 'two']\nanswer = 2\n```\n");
  }
  ProgramRun answer(RunOptions options = {}) const {
    options.environment.emplace("XDG_STATE_HOME", state_);
    return polhode({"answer", lesson_, "quiz", "which", "B"}, options);
  }
  /// How often it was answered, as the file says; it is whole, or not there.
  int tries() const {
    const fs::path log = state_ / "polhode" / "quiz.answers.json";
    if (!fs::exists(log)) return 0;
    const std::string text = text_of(log);
    EXPECT_TRUE(Json::accept(text)) << text;
    return Json::accept(text) ? Json::parse(text)["answers"]["quiz/which"]["tries"].get<int>() : 0;
  }

  ScratchFolder folder_;
  fs::path lesson_ = folder_ / "quiz.md", state_ = folder_ / "state";
};

TEST_F(StateFile, OnADiskThatFailsHasAVerdictAndSaysWhatIsNotKept) {
  if (kSanitized) GTEST_SKIP() << "nothing can be loaded before a sanitizer";
  for (const bool is_there : {false, true}) {
    fs::remove_all(state_);
    if (is_there) answer();
    ASSERT_EQ(answer(failing(state_, 0, folder_ / "count")).code, 0);
    const long operations = std::atol(text_of(folder_ / "count").c_str());
    ASSERT_GT(operations, 5);
    for (long at = 1; at <= operations; ++at) {
      SCOPED_TRACE("operation " + std::to_string(at) + " of " + std::to_string(operations));
      fs::remove_all(state_);
      if (is_there) answer();
      const int before = tries();
      const ProgramRun run = answer(failing(state_, at, folder_ / "count"));
      EXPECT_EQ(run.code, 0);
      EXPECT_EQ(run.out, "right\n");
      const int after = tries();
      EXPECT_TRUE(after == before + 1 || (after == before && run.err.find("is not kept") != run.err.npos))
          << before << " then " << after << ' ' << run.err;
      EXPECT_EQ(answer().code, 0);
      EXPECT_EQ(tries(), after + 1);
      EXPECT_TRUE(left_behind_in(state_ / "polhode").empty());
    }
  }
}

TEST_F(StateFile, KilledAtAnyTimeIsWhole) {
  const auto start = std::chrono::steady_clock::now();
  answer();
  const double takes_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::mt19937 random(1);
  for (int n = 0; n < kills(); ++n) {
    const int before = tries();
    answer(killed_after(std::uniform_real_distribution(0.0, takes_s)(random)));
    EXPECT_THAT(tries(), testing::AnyOf(before, before + 1));
  }
  const int before = tries();
  EXPECT_EQ(answer().code, 0);
  EXPECT_EQ(tries(), before + 1);
  EXPECT_TRUE(left_behind_in(state_ / "polhode").empty());
}

}  // namespace
}  // namespace polhode
