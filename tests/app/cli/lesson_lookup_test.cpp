// SPDX-License-Identifier: MIT
#include "app/cli/lesson_lookup.h"

#include "app/cli/exit_codes.h"
#include "app/cli/or_fail.h"
#include "base/sha256.h"
#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace polhode {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class LessonLookup : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"first", "second"}) fs::create_directory(scratch / folder);
    write_text(scratch / "first/spin.md", "+++\n");
    write_text(scratch / "second/spin.md", "+++\n");
    write_text(scratch / "second/tumble.md", "+++\n");
    write_text(scratch / "second/README.md", "# Not a lesson\n");
    write_text(scratch / "second/notes.txt", "+++\n");
  }
  ScratchFolder scratch;
  std::vector<fs::path> folders{scratch / "missing", scratch / "first", scratch / "second"};
};

TEST_F(LessonLookup, FindsIdsInTheOrderOfTheFolders) {
  EXPECT_EQ(*find_lesson("spin", folders), scratch / "first/spin.md");
  EXPECT_EQ(*find_lesson("tumble", folders), scratch / "second/tumble.md");
}

TEST_F(LessonLookup, PassesOverWhatIsNoFile) {
  ASSERT_EQ(mkfifo((scratch / "first/pipe.md").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((scratch / "first/tumble.md").c_str(), 0600), 0);
  fs::create_directory(scratch / "first/folder.md");
  EXPECT_EQ(lessons_in(folders).size(), 2u);
  EXPECT_EQ(*find_lesson("tumble", folders), scratch / "second/tumble.md");
  EXPECT_FALSE(find_lesson("pipe", folders));
}

TEST_F(LessonLookup, TakesFilesAsTheyAre) {
  EXPECT_EQ(*find_lesson("./x/y", folders), "./x/y");
  EXPECT_EQ(*find_lesson("spin.md", folders), "spin.md");
}

TEST_F(LessonLookup, UnknownIdIsUsageWithTheNearestName) {
  const auto [text, fault] = find_lesson("tumbel", folders).error();
  EXPECT_EQ(fault, Fault::usage);
  EXPECT_THAT(text, HasSubstr("did you mean \"tumble\"?"));
  EXPECT_THAT(text, HasSubstr((scratch / "second").string()));
}

TEST_F(LessonLookup, IdsCannotLeaveTheFolders) {
  for (const char* name : {"..", ""}) EXPECT_EQ(find_lesson(name, folders).error().fault, Fault::usage);
}

TEST_F(LessonLookup, ListsEachIdOnceAndOnlyLessons) {
  std::vector<std::string> ids;
  for (const FoundLesson& found : lessons_in(folders)) ids.push_back(found.id);
  EXPECT_THAT(ids, testing::ElementsAre("spin", "tumble"));
  EXPECT_EQ(lessons_in(folders).front().path, scratch / "first/spin.md");
}

TEST_F(LessonLookup, FindsTranslationsByTheirLanguageAndListsTheOriginalAlone) {
  fs::copy_file(scratch / "first/spin.md", scratch / "first/spin.de.md");
  EXPECT_EQ(*find_lesson("spin.de", folders), scratch / "first/spin.de.md");
  EXPECT_FALSE(find_lesson("spin.xx", folders));
  EXPECT_FALSE(find_lesson("..de", folders));
  EXPECT_THAT(translations_of(scratch / "first/spin.md"), testing::ElementsAre(scratch / "first/spin.de.md"));
  EXPECT_EQ(lessons_in(folders).size(), 2u);
}

TEST_F(LessonLookup, ReadsNoMoreThanOneByteTooMany) {
  EXPECT_EQ(read_lesson_text("/dev/zero")->size(), kMaxLessonBytes + 1);
}

TEST_F(LessonLookup, MissingFileAndFolderFail) {
  for (const char* name : {"none.md", "first"})
    EXPECT_EQ(read_lesson_text(scratch / name).error().fault, Fault::failed) << name;
}

TEST_F(LessonLookup, LoadsWithTheDigestOfTheText) {
  const LoadedLesson loaded = or_fail(load_lesson(test_lesson("tiny.md")));
  EXPECT_EQ(loaded.lesson.id, "tiny");
  EXPECT_EQ(loaded.sha256, sha256_hex(text_of(test_lesson("tiny.md"))));
}

TEST_F(LessonLookup, InvalidLessonCarriesAllDiagnostics) {
  const auto [text, fault] = load_lesson(test_lesson("two_errors.md")).error();
  EXPECT_EQ(fault, Fault::invalid);
  EXPECT_THAT(text, HasSubstr("two_errors.md:12:"));
  EXPECT_THAT(text, HasSubstr("two_errors.md:16:"));
}

TEST_F(LessonLookup, SceneThatNoModelServesIsAnErrorAtItsStage) {
  const std::string path = test_lesson("impossible_scene.md");
  const LessonReading reading = check_lesson(text_of(path), path);
  EXPECT_FALSE(reading.lesson.has_value());
  ASSERT_EQ(reading.diagnostics.size(), 1u);
  EXPECT_EQ(reading.diagnostics[0].place.line, 10);
  EXPECT_THAT(reading.diagnostics[0].message, HasSubstr("asked"));
}

TEST_F(LessonLookup, UnknownStageIsUsageWithTheNearestName) {
  const LoadedLesson loaded = or_fail(load_lesson(test_lesson("tiny.md")));
  try {
    stage_of(loaded.lesson, "roling");
    FAIL() << "a stage is found that is not there";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code, ExitCode::usage);
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"rolling\"?"));
  }
}

}  // namespace
}  // namespace polhode
