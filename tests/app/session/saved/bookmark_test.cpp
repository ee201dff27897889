// SPDX-License-Identifier: MIT
#include "app/session/saved/bookmark.h"

#include "app/cli/exit_codes.h"
#include "lessons/reader/reader.h"
#include "tests/app/run_program.h"
#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Bookmark kBookmark{"free", 3, {"free", "top"}, {"words"}};
const Preferences kPreferences{Theme::dark, 1.21, true, false, true, true};

TEST(Bookmark, IsReadAsItWasWritten) {
  const ScratchFolder scratch;
  const auto folder = scratch / "state" / "polhode";
  ASSERT_TRUE(write_bookmark(folder, "example", kBookmark));
  ASSERT_TRUE(write_preferences(folder, kPreferences));
  EXPECT_EQ(read_bookmark(folder, "example")->bookmark, kBookmark);
  EXPECT_EQ(read_preferences(folder)->preferences, kPreferences);
  EXPECT_EQ(read_bookmark(folder, "another")->bookmark, Bookmark{}) << "each lesson has its own";
  EXPECT_THAT(names_in(folder), ElementsAre("example.place.json", "preferences.json")) << "and nothing else";
  ASSERT_TRUE(write_bookmark(folder, "example", {"top", 1, {"top"}}));
  EXPECT_EQ(read_bookmark(folder, "example")->bookmark.stage, "top");
}

TEST(Bookmark, IsEmptyWhereThereIsNone) {
  const ScratchFolder scratch;
  const auto bookmark = *read_bookmark(scratch / "absent", "example");
  EXPECT_EQ(bookmark.bookmark, Bookmark{});
  EXPECT_THAT(bookmark.warning, IsEmpty());
  const auto preferences = *read_preferences(scratch / "absent");
  EXPECT_EQ(preferences.preferences, Preferences{});
  EXPECT_THAT(preferences.warning, IsEmpty());
}

TEST(Bookmark, IsSetAsideWhereItIsDamaged) {
  for (const char* text :
       {"", "{", "null", "[]", "7", "{}", "{\"format\":1}",
        "{\"format\":1,\"stage\":7,\"step\":1,\"visited\":[]}",
        "{\"format\":1,\"stage\":\"free\",\"step\":\"two\",\"visited\":[]}",
        "{\"format\":1,\"stage\":\"free\",\"step\":1,\"visited\":[7]}",
        "{\"format\":1,\"theme\":\"pink\",\"text_scale\":1,\"reduced_motion\":false}",
        "{\"format\":1,\"theme\":\"dark\",\"text_scale\":1,\"reduced_motion\":\"no\"}", "\xff\xfe\x00z"}) {
    const ScratchFolder scratch;
    write_text(scratch / "example.place.json", text);
    write_text(scratch / "preferences.json", text);
    const auto bookmark = *read_bookmark(scratch.path(), "example");
    EXPECT_EQ(bookmark.bookmark, Bookmark{}) << text;
    EXPECT_THAT(bookmark.warning, HasSubstr("example.place.json was damaged")) << text;
    const auto preferences = *read_preferences(scratch.path());
    EXPECT_EQ(preferences.preferences, Preferences{}) << text;
    EXPECT_THAT(preferences.warning, HasSubstr("preferences.json was damaged")) << text;
    EXPECT_THAT(names_in(scratch.path()),
                ElementsAre("example.place.json.damaged", "preferences.json.damaged"));
    ASSERT_TRUE(write_bookmark(scratch.path(), "example", kBookmark));
    EXPECT_EQ(read_bookmark(scratch.path(), "example")->bookmark, kBookmark) << "it begins anew";
  }
}

TEST(Bookmark, NumbersAreTakenWithinTheirBounds) {
  const ScratchFolder scratch;
  write_text(scratch / "example.place.json", R"({"format":1,"stage":"free","step":1e300,"visited":[]})");
  write_text(scratch / "preferences.json",
             R"({"format":1,"theme":"dark","text_scale":1e9,"reduced_motion":false})");
  EXPECT_EQ(read_bookmark(scratch.path(), "example")->bookmark.step, kMaxStepsPerStage);
  EXPECT_EQ(read_preferences(scratch.path())->preferences.text_scale, kMostTextScale);
}

// Whether there is a window for the speaker is nobody's preference.
TEST(Bookmark, NotesAreNotKept) {
  const ScratchFolder scratch;
  write_text(
      scratch / "preferences.json",
      R"({"format":1,"theme":"dark","text_scale":1,"reduced_motion":false,"notes":true,"notes_shown":true})");
  LessonSession session(test::example());
  const auto reading = *read_preferences(scratch.path());
  EXPECT_THAT(reading.warning, IsEmpty());
  session.preferences = reading.preferences;
  session.set_presenting(true);
  EXPECT_FALSE(session.has_speaker());
  session.set_speaker(true);
  ASSERT_TRUE(write_preferences(scratch.path(), session.preferences));
  ASSERT_TRUE(write_bookmark(scratch.path(), "example", bookmark_of(session)));
  for (const char* file : {"preferences.json", "example.place.json"})
    EXPECT_THAT(text_of(scratch / file),
                ::testing::Not(testing::AnyOf(HasSubstr("notes"), HasSubstr("speaker"))))
        << file;
}

TEST(Bookmark, OfAnotherVersionIsLeftAsItIs) {
  const ScratchFolder scratch;
  write_text(scratch / "example.place.json", "{\"format\":2}");
  write_text(scratch / "preferences.json", "{\"format\":2}");
  EXPECT_FALSE(read_bookmark(scratch.path(), "example"));
  EXPECT_FALSE(read_preferences(scratch.path()));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("example.place.json", "preferences.json"));
}

TEST(Bookmark, AFolderInItsPlaceIsSaid) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "example.place.json");
  EXPECT_FALSE(read_bookmark(scratch.path(), "example"));
  EXPECT_FALSE(write_bookmark(scratch.path(), "example", kBookmark));
}

TEST(Bookmark, WhatCannotBeWrittenIsSaid) {
  const ScratchFolder scratch;
  write_text(scratch / "file", "");
  const auto written = write_bookmark(scratch / "file" / "polhode", "example", kBookmark);
  ASSERT_FALSE(written) << "a file cannot hold a folder";
  EXPECT_THAT(written.error().text, HasSubstr("cannot make"));
  EXPECT_FALSE(write_preferences(scratch / "file" / "polhode", kPreferences));
  EXPECT_FALSE(write_preferences("/proc", kPreferences)) << "a folder that takes no files";
}

TEST(Bookmark, BringsBackWhereWeWere) {
  LessonSession session(test::example());
  session.go_to({0, 3});
  session.go_to({2, 0});
  session.go_to({0, 2});
  session.leave_out("words", true);
  const Bookmark bookmark = bookmark_of(session);
  EXPECT_EQ(bookmark, kBookmark);
  LessonSession next(test::example());
  restore(next, bookmark);
  EXPECT_EQ(next.place(), (StepPlace{0, 2}));
  EXPECT_EQ(bookmark_of(next), bookmark);
}

TEST(Bookmark, PassesOverWhatTheLessonNoLongerHas) {
  LessonSession session(test::example());
  restore(session, {"gone", 3, {"gone", "words"}});
  EXPECT_EQ(session.place(), (StepPlace{0, 0}));
  EXPECT_THAT(session.visited(), ElementsAre("free", "words"));
  restore(session, {"free", 99, {}});
  EXPECT_EQ(session.place(), (StepPlace{0, 3}));
  restore(session, {"top", -5, {}});
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
  EXPECT_THAT(session.visited(), ElementsAre("top"));
  restore(session, {});
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
}

}  // namespace
}  // namespace polhode
