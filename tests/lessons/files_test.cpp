// SPDX-License-Identifier: MIT
// The lessons of the repository are right.
#include "lessons/reader/checks/translation_check.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(LessonFiles, AreReadWithoutErrors) {
  int lessons = 0;
  for (const auto& path : testing::files_in(test::source_dir() / "lessons", ".md")) {
    if (path.filename() == "FORMAT.md" || path.filename() == "README.md") continue;
    ++lessons;
    const LessonReading reading = read_lesson(testing::read_file(path), path.filename().string());
    for (const Diagnostic& diagnostic : reading.diagnostics) {
      EXPECT_NE(diagnostic.severity, Severity::error) << to_string(diagnostic);
    }
    ASSERT_TRUE(reading.lesson) << path;
    EXPECT_EQ(reading.lesson->id, path.stem().stem().string()) << "a lesson is found by its file name";
    const Language language = reading.lesson->about.language;
    EXPECT_EQ(path.stem().extension().string(),
              language == Language::en ? "" : '.' + std::string(tag_of(language)))
        << "and by its language";
  }
  EXPECT_GE(lessons, 1);
}

TEST(LessonFiles, TranslationsDifferFromTheirOriginalsInWordsAlone) {
  int translations = 0;
  for (const auto& path : testing::files_in(test::source_dir() / "lessons", ".md")) {
    const std::string original = original_of(path.string());
    if (original.empty()) continue;
    ++translations;
    const LessonReading here = read_lesson(testing::read_file(path), path.filename().string());
    const LessonReading there = read_lesson(testing::read_file(original), original);
    ASSERT_TRUE(here.lesson && there.lesson) << path;
    EXPECT_THAT(testing::lines_of(check_translation(*here.lesson, "", *there.lesson, "original")),
                ::testing::IsEmpty());
  }
  EXPECT_GE(translations, 1);
}

TEST(LessonFiles, TheReferenceNamesEveryOverlayAndMethod) {
  const std::string format = testing::read_file(test::source_dir() / "lessons/FORMAT.md");
  for (const std::string& name : overlay_names()) EXPECT_THAT(format, ::testing::HasSubstr(name));
  for (const std::string& name : method_names()) EXPECT_THAT(format, ::testing::HasSubstr('"' + name + '"'));
  for (const std::string& name : named_bodies()) EXPECT_THAT(format, ::testing::HasSubstr(name));
}

}  // namespace
}  // namespace polhode
